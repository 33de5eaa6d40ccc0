// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/axes.h"
#include "model/variation/playback.h"
#include "model/variation/subject.h"

#include <span>
#include <vector>

namespace quadrille {

/// How far the way of a movement and its timing differ from one take to the next.
struct WayRange
{
    double heading = 0; ///< greatest turn from the take's heading, radians
    double way = 0;     ///< greatest distance from the take's way over the ground, metres
    double tempo = 0;   ///< standard deviation of the logarithm of durations
};

/// Between a take, or those of a blend, and the other captured takes of the same movement (sameMovement).
/// Where there is none it is a guess: a turn of 4 degrees and a tenth of what the take turns, a twentieth of
/// its way, and a fortieth of its duration.
WayRange wayRange(const Movement& movement, const VariationSubject& subject, UpAxis up);

/// The path on the ground of a variation: that of what it varies, changed by how its displacements differ,
/// evenly and no further than the range. Single displacements that were learned from few takes wobble, and
/// their errors add up. \param displacements  of the variation. \param guide  placements of what is varied.
/// \pre As many displacements as placements.
std::vector<RigidMotion> boundedPath(std::span<const Displacement> displacements,
                                     std::span<const RigidMotion> guide, const WayRange& range,
                                     const PathSettings& settings);

/// Positions on the reference, and of each the nearest of the frames that were there before.
struct TempoPlayback
{
    std::vector<double> positions;
    std::vector<std::size_t> nearest;
};

/// Plays frames faster and slower where something stands, from the first to the last; what flies keeps its
/// time, so that what stands takes up all of the change, as far as a seventh more or less of its own time
/// goes. \param playback  positions on the reference, ascending. \param stands  of each of them. \param tempo
/// logarithm of the whole duration's factor.
TempoPlayback inTempo(const std::vector<double>& playback, const std::vector<bool>& stands, double tempo);

} // namespace quadrille
