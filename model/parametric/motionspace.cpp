// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/motionspace.h"

#include "model/core/badargument.h"
#include "model/parametric/hybridblend.h"
#include "model/parametric/references.h"

#include <cmath>

namespace quadrille {

namespace {

void requireSettings(std::span<const SpaceTakeSource> takes, const std::vector<SpaceParameter>& parameters,
                     const MotionSpaceSettings& settings)
{
    if (takes.size() > 1 && parameters.empty())
        refuse("A motion space of several takes has no parameter",
               "Say what they differ in, such as their speed.");
    if (takes.size() == 1 && !parameters.empty())
        refuse("A motion space of one take has a parameter", "Add takes that differ in it, or leave it out.");
    if (!(settings.tolerance > 0 && std::isfinite(settings.tolerance)))
        refuse("The tolerance of a motion space is not positive", "The usual one is 5 mm.");
    if (settings.mostReferences < 0)
        refuse("A motion space cannot have fewer than 0 references", "Use 0 for linear blends.");
    for (const SpaceTakeSource& source : takes) {
        if (!(source.speed > 0 && std::isfinite(source.speed)))
            refuse("The speed of “" + source.take.sequence.name + "” in a motion space is not positive",
                   "1 is as it was captured.");
    }
}

/// Takes that do not cycle are said, not bent.
void requireCycles(const Alignment& alignment)
{
    if (!alignment.cycle)
        return;
    for (std::size_t t = 0; t < alignment.takes.size(); ++t) {
        const TakeUse use = alignment.reports[t].use;
        if (use == TakeUse::NoCycle || use == TakeUse::TooShort)
            refuse("No cycle like that of “" + alignment.takes[alignment.reference].name +
                       "” was found in “" + alignment.takes[t].name + "”",
                   "Leave it out, give the frames of one cycle of it, or turn cycles off.");
    }
}

SpacePoint measuredPlace(const MotionSpace& space, const SpacePoint& byHand,
                         const PerformedMovement& movement)
{
    SpacePoint place{};
    for (std::size_t d = 0; d < space.parameters.size(); ++d)
        place[d] = space.parameters[d].measure == SpaceMeasure::ByHand
                       ? byHand[d]
                       : measured(space.parameters[d], movement);
    return place;
}

void placeTakes(MotionSpace& space, std::span<const SpaceTakeSource> takes)
{
    std::vector<SpacePoint> places;
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const SpaceTake& take = space.takes[t];
        const PerformedMovement movement{take.poses,   space.vertexCount(), take.steps,
                                         take.seconds, space.isCyclic,      space.up};
        if (takes[t].place) {
            places.push_back(*takes[t].place);
            continue;
        }
        for (const SpaceParameter& parameter : space.parameters) {
            if (parameter.measure == SpaceMeasure::ByHand)
                refuse("“" + take.name + "” has no place on the axis “" + parameter.name + "”",
                       "Give it one, or say what the parameter measures.");
        }
        places.push_back(measuredPlace(space, {}, movement));
    }
    space.weights = WeightSpace(places, static_cast<int>(space.parameters.size()));
}

} // namespace

MotionSpace makeMotionSpace(std::string name, std::span<const SpaceTakeSource> takes, std::size_t reference,
                            std::vector<SpaceParameter> parameters, Positions templatePose,
                            const MotionSpaceSettings& settings, const Progress& progress)
{
    requireSettings(takes, parameters, settings);
    std::vector<TrainingTake> training;
    for (const SpaceTakeSource& source : takes)
        training.push_back(source.take);
    const Alignment alignment =
        alignTakes(training, reference, settings.alignment, templatePose, progress.part(0, 0.3));
    requireCycles(alignment);

    MotionSpace space{.name = std::move(name),
                      .topology = takes[reference].take.sequence.topology,
                      .up = settings.alignment.up,
                      .fps = alignment.fps,
                      .isCyclic = alignment.cycle.has_value(),
                      .takes = {},
                      .weights = {},
                      .references = {},
                      .parameters = std::move(parameters),
                      .map = {}};
    for (std::size_t t = 0; t < takes.size(); ++t)
        space.takes.push_back(
            makeSpaceTake(training[t].sequence, alignment.takes[t],
                          {.up = space.up, .isCyclic = space.isCyclic, .speed = takes[t].speed},
                          Progress(progress.token())));
    placeTakes(space, takes);
    refine(space, settings, progress.part(0.35, 0.9));
    space.map = fitParameterMap(space.weights, space.parameters, [&](const SpacePoint& place) {
        progress.report(0.9);
        const BlendedMovement movement = blendedMovement(space, space.weights.at(place));
        return measuredPlace(space, place, movement.performed(space));
    });
    return space;
}

} // namespace quadrille
