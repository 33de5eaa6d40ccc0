// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/comparison.h"
#include "model/project/fields/describeshared.h"

namespace quadrille {

template <typename Fields>
void describe(Fields& f, Type<GraphEntry>)
{
    using E = GraphEntry;
    f.about("graph");
    f.as(Role::Character, "character", &E::character, {.help = ownCharacterHelp});
    f.word("metric", at(&E::pose, &PoseDistanceSettings::metric),
           words<PoseMetric>({{"surface", PoseMetric::Surface}, {"euclidean", PoseMetric::Euclidean}}),
           {.help = "How poses are compared: by the rotation and stretch of their triangles, or by their "
                    "vertices."});
    f.field("stretch_weight", at(&E::pose, &PoseDistanceSettings::stretchWeight),
            {.help = "Of the stretch against the rotation.",
             .limits = Limits::from(0, "The weight of the stretch is below zero")});
    f.field(
        "triangles", at(&E::pose, &PoseDistanceSettings::triangles),
        {.help =
             "How many triangles, or vertices, poses are compared by, spread evenly over the surface; where "
             "it is left out all, or 1,000 where there are more than 5,000 frames.",
         .limits = Limits::from(1, "At least one triangle must be compared",
                                "Leave it out for the usual number.")});
    f.word("cost", &E::cost,
           words<TransitionCost>({{"sum", TransitionCost::Sum}, {"mean", TransitionCost::Mean}}),
           {.help = "Of a transition: the sum of the step costs on its way, as published, or their mean."});
    f.word("cost_scale", &E::costScale,
           words<CostScale>({{"none", CostScale::None}, {"liveliness", CostScale::Liveliness}}),
           {.help =
                "What costs are divided by before they weigh in the graphs: nothing, as published, or how "
                "lively the two sequences are, so that transitions between calm takes are dearer."});
    f.word(
        "length", &E::length,
        words<TransitionLength>({{"path", TransitionLength::Path}, {"windows", TransitionLength::Windows}}),
        {.help = "How many frames a transition lasts: as many as its warp path has cells, as published, in "
                 "which the takes slow down, or as the mean of its two windows."});
    f.field("contact_weight", at(&E::steps, &StepWeights::contacts),
            {.help =
                 "What it costs beside the pose distance to blend two frames of which each foot stands in "
                 "one only, rad, and as much to drag a foot that stands over an eighth of the body's "
                 "height; 0 as published.",
             .limits = Limits::from(0, "The weight of contacts is below zero")});
    f.field("velocity_weight", at(&E::steps, &StepWeights::velocity),
            {.help =
                 "What it costs beside the pose distance when body and feet move by a body height a second "
                 "otherwise, rad; 0 as published.",
             .limits = Limits::from(0, "The weight of velocities is below zero")});
    f.field("slope", &E::slope,
            {.help = "Frames in a row in which only one of the two sequences goes on.",
             .limits = Limits::between(TransitionSettings::leastSlope, TransitionSettings::greatestSlope,
                                       "The slope must be 2, 3, 4 or 5")});
    f.field("durations", &E::durations);
    f.field("alpha", &E::alpha,
            {.help = "Weight of time against deformation.", .need = Need::Always, .limits = limits::alpha});
    f.word("smoothing", &E::smoothing,
           words<CostSmoothing>(
               {{"none", CostSmoothing::None}, {"3x3", CostSmoothing::Mean3}, {"5x5", CostSmoothing::Mean5}}),
           {.help = "What the local minima of the motion graph are looked for in: costs as they are, as "
                    "published, or their means over squares of 3×3 or 5×5 frames, so that fewer small dents "
                    "count."});
    f.field("d_max", &E::greatestDistance,
            {.help = "The pose distance that counts as 1; the largest of the character where it is left out.",
             .limits = Limits::above(0, "The largest pose distance must be above zero",
                                     "Leave it out to take the largest of the character.")});
    f.unknown(&E::unknown);
}

template <typename Fields>
void describe(Fields& f, Type<EvaluationEntry>)
{
    using E = EvaluationEntry;
    f.about("evaluation");
    f.field(
        "table", &E::table,
        {.help =
             "A table of the paper on shape motion: how interpolation keeps edges and volume (fig4), "
             "kinds of "
             "transitions (fig7), Essential graph and motion graph (fig9), the centre of a blend with "
             "constant (fig11) and rising weights (fig12), pose distances against reference joint angles "
             "(table1), poses at times (table2); what shows at transitions (junctions), how calm walks "
             "along paths are (walks), what makes Essential graphs dense (density), and what shows of "
             "variations beside the takes that they vary (variations). Of a model of appearance: how well "
             "textures are restored by its number of components (fig17 SSIM, fig18 squared error), those "
             "that were left out (fig19, fig20), textures between two by Eigen textures (fig22) and "
             "against captured ones (appearance-interpolation), those of poses of a take that was left out "
             "(appearance-shape), and bytes (appearance-rates). Of transfers that name a truth: how far "
             "they are from it (transfer-error). Of motion spaces: how far their blends are from non-linear "
             "ones "
             "(ia4d-table1, ia4d-fig4), transitions between them (ia4d-table2), and interpolated distances "
             "of "
             "poses (ia4d-table3).",
         .need = Need::Required,
         .choices = evaluationTables});
    f.reference("character", &E::character, NamedKind::Character,
                {.help = "All characters where it is left out.", .loss = Loss::OfOwner});
    f.reference("sequences", &E::sequences, NamedKind::Sequence,
                {.help =
                     "Of fig11 and fig12: which is blended into which; those that turn most to the left and "
                     "to the right where they are left out. Of table2: those that keys are drawn from.",
                 .expected = "The name of a sequence in quotes is expected here"});
    f.field("alphas", &E::alphas,
            {.help = "Of fig9 and density: weights of time; for density, the graph's where it is left out.",
             .limits = limits::alpha,
             .fallbackList = figure9Alphas});
    f.field(
        "count", &E::count,
        {.help =
             "What is drawn: pairs of frames for fig4 and fig22 (20), keys for table2 (10), transitions for "
             "junctions (200), sets of frames of each size for fig19 and fig20 (5), frames at each "
             "distance for appearance-interpolation (20), frames of each take for appearance-shape (10). Of "
             "fig17 and fig18: cameras around the body (4).",
         .limits = Limits::between(1, 100'000, "The count must be from 1 to 100000")});
    f.as(Role::Seed, "seed", &E::seed, {.help = "Of what is drawn.", .limits = limits::seed});
    f.unknown(&E::unknown);
}

} // namespace quadrille
