// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/core/units.h"
#include "model/variation/timewarp.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// After how many frames the poses of a take of locomotion come back: the least number by which frames lie
/// apart that resemble each other most (a lag with a minimum of the mean distance), seen over at least a
/// fifth of it. Nothing for takes that are no locomotion: their poses never come back, or do not go on the
/// same way.
/// \param distances  of the poses of all pairs of frames of the take.
/// \param greatestReturn  mean distance at that lag, in the largest at a shorter lag.
std::optional<std::int64_t> findPeriod(const Table<float>& distances, double greatestReturn);

/// One cycle of a take that runs like the reference's.
struct CycleMatch
{
    std::vector<WarpMatch> path; ///< the reference's frames of the cycle from 0; the take's from its first
    double meanCost = 0;         ///< of a cell, the one that closes the cycle included
};

/// The run of frames of a take that resembles a cycle best, by subsequence warping. The frame after it must
/// resemble the cycle's beginning again. Nothing where the take is too short.
/// \param costs  frames of the reference's cycle × frames of the take.
std::optional<CycleMatch> matchCycle(const Table<float>& costs, const WarpSteps& steps);

/// Where the reference's cycle should begin, so that the other takes hold one from the same phase on: the
/// first frame of the run of `period` frames that they match best together.
/// \param costs  of each other take, all frames of the reference × its frames.
/// \pre 0 < period ≤ frames of the reference.
std::int64_t chooseCycleStart(std::span<const Table<float>> costs, std::int64_t period,
                              std::int64_t referenceFrames, const WarpSteps& steps);

} // namespace quadrille
