// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describebodyparts.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<TrainingEntry>)
{
    using E = TrainingEntry;
    f.about("training");
    f.reference("sequence", &E::sequence, NamedKind::Sequence, {.need = Need::Required});
    f.field("range", &E::range);
    f.unknown(&E::unknown);
}

/// What both pairs of a blend have in common.

template <typename E, typename Fields>
void describeBlend(Fields& f, const char* fromHelp, const char* toHelp, const char* weightsHelp)
{
    f.reference("from", &E::from, NamedKind::Sequence, {.help = fromHelp, .need = Need::Required});
    f.reference("to", &E::to, NamedKind::Sequence, {.help = toHelp, .need = Need::Required});
    f.field("weights", &E::weights,
            {.help = weightsHelp, .need = Need::Always, .limits = Limits::within(0, 1, nullptr)});
}

template <typename Fields>
void describe(Fields& f, Type<AcrossBlendEntry>)
{
    f.about("across_blend",
            "The other two takes of a blend of four: all nodes of the grid over the square are learned.");
    describeBlend<AcrossBlendEntry>(f, "The take across from the first.", "The take across from the second.",
                                    "Of this pair against the first one, ascending.");
    f.unknown(&AcrossBlendEntry::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<BlendEntry>)
{
    f.about("blend");
    describeBlend<BlendEntry>(f, "", "", "Of the second take, ascending.");
    f.object("across", &BlendEntry::across, {.loss = Loss::OfOwner});
    f.unknown(&BlendEntry::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<AcrossSamplesEntry>)
{
    using E = AcrossSamplesEntry;
    f.about("across_samples", "The other two takes of a blend of four.");
    f.reference("of", &E::of, NamedKind::Sequence,
                {.help = "The take across from the first.", .need = Need::Required});
    f.reference("to", &E::to, NamedKind::Sequence,
                {.help = "The take across from the second.", .need = Need::Required});
    f.field(
        "weight", &E::weight,
        {.help = "Of this pair against the first one.", .need = Need::Always, .limits = limits::blendWeight});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<SamplesEntry>)
{
    using E = SamplesEntry;
    f.about("samples");
    f.reference("of", &E::of, NamedKind::Sequence,
                {.help = "The take that is varied, or the first of two.", .need = Need::Required});
    f.reference("to", &E::to, NamedKind::Sequence,
                {.help = "The second take of a blend.", .loss = Loss::OfOwner});
    f.field("weight", itself);
    f.object("across", &E::across, {.loss = Loss::OfOwner});
    f.as(Role::Count, "count", &E::count,
         {.help = "How many variations.",
          .need = Need::Always,
          .limits = limits::count.upTo(10'000, {"There are more than 10000 variations", ""})});
    f.as(Role::Seed, "seed", &E::seed, {.need = Need::Always, .limits = limits::seed});
    f.field("discarded", &E::discarded,
            {.help = "Which variations of this set were thrown away, from 1.",
             .limits = Limits::from(1, nullptr)});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describeLearning(Fields& f)
{
    using S = GpdmSettings;
    const auto of = [](auto member) { return at(&VariationEntry::learning, member); };
    f.as(Role::Count, "dimensions", of(&S::dimensions),
         {.help = "Of the latent space.",
          .limits = Limits::between(1, 10, "The dimensions must be from 1 to 10", "Write 3, as usual.")});
    f.as(Role::Count, "restarts", of(&S::restarts),
         {.help = "Starts beyond the first.",
          .limits = limits::count.upTo(100, {"There are more than 100 restarts", ""})});
    f.as(Role::Seed, "seed", of(&S::seed), {.limits = limits::seed});
    f.field("tolerance", of(&S::tolerance),
            {.help = "Learning stops where the objective falls by less than this share.",
             .limits = Limits::above(0, "The tolerance is not above zero", "Write 1e-6, as usual.")});
    f.as(Role::Count, "window", of(&S::window),
         {.help = "In so many iterations.",
          .limits = Limits::from(1, "The window is below one iteration", "Write 10, as usual.")
                        .upTo(1e6, "The window", "iterations")});
    f.as(
        Role::Count, "iterations", of(&S::greatestIterations),
        {.help = "At most, of one start.",
         .limits = Limits::from(1, "There is no iteration to learn in").upTo(1e6, "Learning", "iterations")});
}

template <typename Fields>
void describeSampling(Fields& f)
{
    using E = VariationEntry;
    using S = HmcSettings;
    f.as(
        Role::Count, "leapfrog_steps", at(&E::chain, &S::leapfrogSteps),
        {.help = "Of a trajectory of the chain.",
         .limits = Limits::from(1, "A trajectory has at least one step").upTo(1e6, "A trajectory", "steps")});
    f.as(Role::Count, "burn_in", at(&E::chain, &S::burnIn),
         {.help = "Trajectories before the first sample.",
          .limits = limits::count.upTo(1e6, "The burn-in", "trajectories")});
    f.as(Role::Count, "thinning", at(&E::chain, &S::thinning),
         {.help = "Trajectories from one sample to the next.",
          .limits = Limits::from(1, "Samples are at least one trajectory apart")
                        .upTo(1e6, "The thinning", "trajectories")});
    f.field("acceptance", &E::chain);
    f.field("spread", &E::extent);
    f.field("uncertainty", at(&E::extent, &TrajectoryLimits::uncertainty),
            {.help = "Variance of a pose at most, as a share of that of an unknown one.",
             .limits =
                 Limits::above(0, "The uncertainty must be above 0, and 1 at most", "Write 0.25, as usual.")
                     .upTo(1, {"The uncertainty must be above 0, and 1 at most", "Write 0.25, as usual."})});
}

template <typename Fields>
void describeLimits(Fields& f)
{
    using S = VariationLimits;
    const auto of = [](auto member) { return at(&VariationEntry::limits, member); };
    f.field("pose_distance", &VariationEntry::limits);
    f.field(
        "skate", of(&S::skate),
        {.help = "How much faster standing feet may slide than in the take, sizes of the figure a second.",
         .limits = Limits::above(0, nullptr)});
    f.field("intersections", of(&S::intersections),
            {.help =
                 "Pairs of triangles that go through each other in the worst frame beyond those of the worst "
                 "frame of all takes, a share of all.",
             .limits = Limits::from(0, nullptr)});
    f.field("volume_change", of(&S::volumeChange),
            {.help = "How far the volume may leave that of the poses learned from, a share.",
             .limits = Limits::above(0, nullptr)});
    f.field("collapse", of(&S::collapse),
            {.help =
                 "Triangles of a region of the body that are less than half as large as in any pose learned "
                 "from, or folded by 60 degrees more, a share of them.",
             .limits = Limits::from(0, nullptr)});
    f.field("sink", of(&S::sink),
            {.help = "How much deeper than the take a variation may reach, sizes of the figure.",
             .limits = Limits::from(0, nullptr)});
}

template <typename Fields>
void describe(Fields& f, Type<VariationEntry>)
{
    using E = VariationEntry;
    f.about("variation");
    f.name("name", &E::name);
    f.as(Role::Character, "character", &E::character, {.help = ownCharacterHelp});
    f.list("sequences", &E::training,
           {.help = "The takes that are learned, as “walk” or {\"sequence\": \"walk\", \"range\": [0, 40]}.",
            .need = Need::Always,
            .loss = Loss::OfOwner,
            .shortKey = "sequence"});
    f.reference("reference", &E::reference, NamedKind::Sequence,
                {.help = "The take whose timing the others are warped to; the first."});
    f.object("template", &E::templatePose,
             {.help = "The frame that all poses are laid onto; the first of the reference."});
    f.field("cycles", &E::cycles, {.help = "Takes of locomotion are cut to one cycle."});
    f.list("blends", &E::blends, {.help = "Pairs of takes that are blended before learning."});
    f.field("displacement_share", &E::displacementShare,
            {.help = "Variance of the displacements, in mean variances of a coordinate.",
             .limits = Limits::above(0, "The share of the displacements is not above zero")});
    f.group("learning", "learning", "", &E::unknownOfLearning, [](auto& own) { describeLearning(own); });
    f.group("sampling", "sampling", "", &E::unknownOfSampling, [](auto& own) { describeSampling(own); });
    f.list("samples", &E::samples);
    f.word("poses", &E::draw, words<PoseDraw>({{"mean", PoseDraw::Mean}, {"sample", PoseDraw::Sample}}),
           {.help = "From latent positions the most probable poses, or one draw for each trajectory."});
    f.field("contact_correction", &E::correctsContacts, {.help = "Feet that stand in the take stand still."});
    f.group("limits", "variation_limits",
            "What makes a variation bad, so that another is drawn in its place.", &E::unknownOfLimits,
            [](auto& own) { describeLimits(own); });
    f.unknown(&E::unknown);
}

} // namespace quadrille
