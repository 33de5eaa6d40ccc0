// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/table.h"
#include "model/core/units.h"
#include "model/variation/timewarp.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// After how many frames the poses of a take of locomotion come back: the least lag at which the mean
/// distance of frames has a minimum that is low enough, seen over at least a fifth of it, in frames that
/// move. Nothing for takes that are no locomotion: their poses never come back, do not go on the same way, or
/// rest before and after.
/// \param distances  of the poses of all pairs of frames of the take.
/// \param greatestReturn  mean distance at that lag, in the largest at a shorter lag.
std::optional<std::int64_t> findPeriod(const Table<float>& distances, double greatestReturn);

/// A take that a cycle is looked for in.
struct CycleTake
{
    const Table<float>* costs = nullptr; ///< usable frames of the reference × frames of the take
    std::optional<std::int64_t> period;  ///< its own; a take without one is matched as a whole
};

/// Where the reference's cycle should begin, so that the other takes hold one from the same phase on: the
/// first frame of the run of `period` frames that they match best together; the earliest without others.
/// \pre 0 < period ≤ frames of the reference.
/// \throws Error Cancelled. Cost: O(starts · windows · period²) with at most 32 starts and 64 windows of each
/// take, and as many again near the best.
std::int64_t chooseCycleStart(std::span<const CycleTake> takes, std::int64_t period,
                              std::int64_t referenceFrames, const Progress& progress = {});

/// Which frames of a take that has a period are its cycle from the same phase on: of all runs of so many
/// frames the one that matches the reference's cycle best.
/// \param costs  frames of the reference's cycle × frames of the take. \pre period ≤ frames of the take.
FrameRange cycleWindow(const Table<float>& costs, std::int64_t period);

/// One cycle in a take that has more than that (somebody who begins to walk, and stops), by subsequence
/// warping. Nothing where no frames run like the reference's cycle and come back.
/// \param toReference  distances of the poses of the reference's cycle to those of the take. \param own  of
/// the poses of the take to each other.
/// \param greatestMatch  mean distance on the path, in the mean of all.
/// \param greatestReturn  distance of the first frame and the one after the last, in the mean of all.
std::optional<FrameRange> cycleWithin(const Table<float>& toReference, const Table<float>& own,
                                      const WarpSteps& steps, double greatestMatch, double greatestReturn);

} // namespace quadrille
