// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/core/units.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// How a take runs against the reference: the same phase of the movement at the same place. Both ends of the
/// frames used meet both ends of the reference.
struct TakeWarp
{
    FrameRange frames; ///< of the take that are used: one cycle of it, or all
    /// Of each reference frame its position in the take, in frames of the take (fractional), ascending.
    std::vector<double> positions;
    /// Of each frame used its position on the reference, 0 … reference frames − 1, ascending: samples are
    /// played back by it in the timing of the take. Inverse of the positions, linear between them.
    std::vector<double> playback;

    bool operator==(const TakeWarp&) const = default;
};

/// How many frames of the take pass from one reference frame to the next, at least a twentieth: of each one
/// since the one before it, of the first as of the second; 1 each where the warp has no positions.
std::vector<double> takeSteps(const TakeWarp& warp, std::size_t referenceFrames);

/// A frame of the reference that is matched with a frame of a take.
struct WarpMatch
{
    int reference = 0;
    int take = 0;
    bool operator==(const WarpMatch&) const = default;
};

/// How far warps may go.
struct WarpSteps
{
    /// Frames of one that one frame of the other may be matched with further, in a row; where two lengths
    /// differ by more, as many as they need. 0: any number.
    int longestRun = 3;
    /// More than this counts as any number.
    static constexpr int greatestRun = 100;

    bool operator==(const WarpSteps&) const = default;
};

/// A path from the first row of costs to the last one by steps (1,1), (1,0), (0,1), and the sum of its cells.
struct WarpPathResult
{
    std::vector<WarpMatch> path;
    double cost = 0;

    double meanCost() const { return cost / static_cast<double>(path.size()); }
};

/// Dynamic time warping of whole against whole: the cheapest path from the first cell to the last. Among
/// equal ones the one with its diagonal steps latest.
/// \param costs  reference frames × take frames, not negative. \pre At least one of each.
/// Cost: O(rows · columns · longestRun).
WarpPathResult warpWhole(const Table<float>& costs, const WarpSteps& steps = {});

/// Subsequence dynamic time warping: the whole reference against the run of frames of the take that it
/// matches best, wherever that begins and ends. Nothing where the take is too short for it.
/// \param costs, steps  as for warpWhole; the limit is kept.
std::optional<WarpPathResult> warpWithin(const Table<float>& costs, const WarpSteps& steps = {});

/// The warp that a path means. Where several frames of the take match one reference frame, their mean
/// position is used, and where several reference frames match one frame of the take, the middle one of them;
/// the others lie in between. The ends of the path stay matched.
/// \param smoothing  standard deviation of the Gaussian that evens the steps of the path out, in reference
/// frames; 0: none. Ends and order stay.
/// \param first  frame of the take that column 0 of the costs stands for.
TakeWarp warpOf(const std::vector<WarpMatch>& path, double smoothing, FrameIndex first = FrameIndex(0));

/// A warp and its share in a blend.
struct WarpShare
{
    const TakeWarp* warp = nullptr;
    double share = 0; ///< not negative
};

/// The warp of a blend of takes on one reference: length and timing in between. Its frames count from 0, as
/// it was never captured, unless one of the takes is all of it: then it is that take's.
/// \pre The shares add up to 1; all warps have as many reference frames.
TakeWarp blendedWarp(std::span<const WarpShare> warps);
/// Of two takes. \param weight  of the second, 0 … 1.
TakeWarp blendedWarp(const TakeWarp& a, const TakeWarp& b, double weight);

/// Where an ascending function of frames 0, 1, … takes the values first, first + 1, …: linear between its
/// frames, clamped at its ends. \return `count` frames. \pre At least two positions.
std::vector<double> inverseWarp(const std::vector<double>& positions, double first, std::int64_t count);

} // namespace quadrille
