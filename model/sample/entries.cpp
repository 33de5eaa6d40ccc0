// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/entries.h"

#include "model/variation/parts/proposedparts.h"

#include <algorithm>

namespace quadrille {

namespace {

FrameChoice labelled(std::string label)
{
    FrameChoice choice;
    choice.label = std::move(label);
    return choice;
}

KeyEntry keyAt(std::string sequence, std::int64_t frame, double seconds)
{
    KeyEntry key;
    key.sequence = std::move(sequence);
    key.frame = FrameIndex(frame);
    key.time = seconds;
    return key;
}

ActionEntry actionOf(std::string label, int repeat = 1)
{
    ActionEntry action;
    action.frames = labelled(std::move(label));
    action.repeat = repeat;
    return action;
}

PartCurveEntry curveEntry(const PartCurve& curve)
{
    // As many points as suffice to drag the curve by.
    constexpr std::size_t points = 8;
    PartCurveEntry entry;
    entry.curve = curve;
    const std::size_t count = curve.vertices.size();
    for (std::size_t i = 0; i < points && count >= points; ++i)
        entry.points.push_back(curve.vertices[i * count / points]);
    return entry;
}

/// \param takes  the first is the reference.
VariationEntry variationOf(std::string name, const std::string& character,
                           const std::vector<std::string>& takes)
{
    VariationEntry variation;
    variation.name = std::move(name);
    variation.character = character;
    for (const std::string& take : takes)
        variation.training.emplace_back().sequence = take;
    return variation;
}

/// A jump from the crouch before it to the one after it; what is stood before and after would cost as much to
/// learn as the jump.
FrameRange jumpIn(const SampleTake& take)
{
    constexpr std::int64_t around = 10;
    return {FrameIndex(std::max<std::int64_t>(take.flight.first.value - around, 0)),
            FrameIndex(std::min(take.flight.last.value + around, take.sequence.frameCount() - 1))};
}

SamplesEntry samplesOf(std::string take, int count)
{
    SamplesEntry samples;
    samples.of = std::move(take);
    samples.count = count;
    return samples;
}

} // namespace

std::vector<EvaluationEntry> sampleEvaluations(const std::string& character)
{
    std::vector<EvaluationEntry> evaluations;
    for (const char* table : {"fig4", "fig11", "fig12", "table1", "cvs-fig4", "cvs-fig7"}) {
        evaluations.emplace_back().table = table;
        evaluations.back().character = character;
    }
    return evaluations;
}

std::vector<ExportEntry> sampleExports()
{
    ExportEntry glb;
    glb.name = "walk for Blender";
    glb.what = "sequences/walk 1";
    glb.path = "exports/walk_1.glb";
    ExportEntry film;
    film.name = "dance film";
    film.what = "sequences/dance 1";
    film.path = "exports/dance_1.mp4";
    ExportEntry tour;
    tour.name = "along an S for Blender";
    tour.what = "animations/along an S";
    tour.path = "exports/along_an_S.glb";
    ExportEntry walks;
    walks.name = "walks for machine learning";
    walks.what = "variations/walking";
    walks.path = "exports/walking.npy";
    return {glb, film, tour, walks};
}

std::vector<AnimationEntry> sampleAnimations(const std::string& character)
{
    const auto named = [&character](std::string name) {
        AnimationEntry animation;
        animation.name = std::move(name);
        animation.character = character;
        return animation;
    };
    PathEntry curve;
    // As tight as the takes can turn: the body stays within a hand's breadth of it.
    curve.points = {{0, 0, 0},        {0.22, 0, 0.98},  {0.25, 0, 2.02}, {0.14, 0, 2.99}, {0.02, 0, 4.06},
                    {-0.11, 0, 5.03}, {-0.14, 0, 6.03}, {0.17, 0, 6.99}, {0.17, 0, 8},    {0.08, 0, 8.98}};
    curve.spans = {{.from = 3.5, .to = 6, .frames = labelled("jog")}};
    curve.obstacles = {{.corners = {Vec2d(-1.6, 2.4)}, .radius = 0.4}};
    curve.clearance = 0.3;
    AnimationEntry path = named("along an S");
    path.constraints = {curve};
    path.search.mu = 0.05;
    path.search.deadZone = 0.04;
    AnimationEntry keys = named("dance by the clock");
    keys.constraints = {keyAt("dance 1", 10, 0), keyAt("dance 1", 40, 2.5), keyAt("dance 1", 20, 4),
                        keyAt("dance 1", 60, 6.5)};
    AnimationEntry actions = named("walk, kick, jump");
    actions.constraints = {actionOf("walk"), actionOf("kick", 2), actionOf("high jump")};
    actions.gentleBlend = true;
    actions.post.steps.contacts.emplace();
    return {path, keys, actions};
}

BodyPartsEntry sampleBodyParts(const SampleBody& body)
{
    const ProposedParts proposed = proposeParts(body.topology, body.rest);
    BodyPartsEntry entry;
    entry.character = body.name;
    for (const PartCurve& curve : proposed.curves)
        entry.curves.push_back(curveEntry(curve));
    for (const PartDescription& part : proposed.parts)
        entry.parts.emplace_back().part = part;
    return entry;
}

std::vector<VariationEntry> sampleVariations(const SampleCharacter& character)
{
    const std::string& name = character.body.name;
    VariationEntry walking = variationOf("walking", name, {"walk 1", "jog 1", "left turn 1", "right turn 1"});
    BlendEntry blend;
    blend.from = "walk 1";
    blend.to = "jog 1";
    walking.blends = {blend};
    SamplesEntry between = samplesOf("walk 1", 2);
    between.to = "jog 1";
    between.weight = 0.3;
    walking.samples = {samplesOf("walk 1", 5), between};
    VariationEntry jumping =
        variationOf("jumping", name, {"short jump 1", "long jump 1", "low jump 1", "high jump 1"});
    for (TrainingEntry& training : jumping.training) {
        const auto take = std::ranges::find(character.takes, training.sequence,
                                            [](const SampleTake& each) { return each.sequence.name; });
        training.range = jumpIn(*take);
    }
    jumping.samples = {samplesOf("short jump 1", 3), samplesOf("high jump 1", 2)};
    return {walking, jumping};
}

std::vector<MotionSpaceEntry> sampleMotionSpaces(const SampleCharacter& character)
{
    const auto spaceOf = [&](std::string name, std::string parameter, SpaceMeasure measure,
                             std::initializer_list<const char*> takes) {
        MotionSpaceEntry space;
        space.name = std::move(name);
        space.character = character.body.name;
        for (const char* take : takes)
            space.takes.emplace_back().sequence = take;
        space.parameters.push_back({.name = std::move(parameter), .measure = measure});
        return space;
    };
    MotionSpaceEntry jumping =
        spaceOf("jumping", "height", SpaceMeasure::JumpHeight, {"low jump 1", "high jump 1"});
    for (SpaceTakeEntry& entry : jumping.takes) {
        const auto take = std::ranges::find(character.takes, entry.sequence,
                                            [](const SampleTake& each) { return each.sequence.name; });
        entry.range = jumpIn(*take);
    }
    return {spaceOf("walking", "speed", SpaceMeasure::Speed, {"walk 1", "jog 1"}),
            spaceOf("turning", "turning", SpaceMeasure::Turning, {"walk 1", "left turn 1", "right turn 1"}),
            jumping};
}

SequenceEntry sampleBodyAtRest(const CharacterEntry& character)
{
    SequenceEntry entry;
    entry.name = character.name + " at rest";
    entry.character = character.name;
    entry.source = character.mesh;
    return entry;
}

TransferEntry sampleTransfer(const std::string& bodyAtRest)
{
    TransferEntry entry;
    entry.name = "walk of the other body";
    entry.clip = "sequences/walk 1";
    entry.target.sequence = bodyAtRest;
    return entry;
}

} // namespace quadrille
