// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"
#include "model/core/progress.h"
#include "model/core/sharedtable.h"
#include "model/transition/framelayout.h"
#include "model/transition/framepair.h"
#include "model/transition/transitionsettings.h"

#include <cstdint>
#include <limits>

namespace quadrille {

/// What is known of a transition without its warp path, see TransitionTable.
struct KnownTransition
{
    float cost = std::numeric_limits<float>::infinity();
    std::uint16_t length = 0;
    std::uint16_t sourceWindow = 0;
    std::uint16_t destinationWindow = 0;
};

/// The best transition from every frame (row) to every frame (column) of a character. All tables are frames ×
/// frames, but the windows. From i to j the source window is [i, i + sourceWindow − 1], the destination
/// window [j − destinationWindow + 1, j].
struct TransitionTable
{
    /// D: cost of the warp path, in the unit of the pose distances; infinite where no windows fit and on the
    /// diagonal. Not symmetric.
    SharedTable<float> cost;
    /// L: frames that the transition lasts, by TransitionSettings::length; 0 where the cost is infinite, as
    /// are the two windows.
    SharedTable<std::uint16_t> length;
    /// Both windows, frames: frames × 2 · frames, lᵢ and lⱼ of each pair side by side.
    SharedTable<std::uint16_t> windows;

    std::uint16_t sourceWindow(NodeIndex i, NodeIndex j) const { return windows(i, Eigen::Index{2} * j); }
    std::uint16_t destinationWindow(NodeIndex i, NodeIndex j) const
    {
        return windows(i, Eigen::Index{2} * j + 1);
    }
    KnownTransition at(const FramePair& pair) const
    {
        const auto [i, j] = pair;
        return {cost(i, j), length(i, j), sourceWindow(i, j), destinationWindow(i, j)};
    }

    static constexpr float none = std::numeric_limits<float>::infinity();
};

/// Transitions of least cost over all windows and warp paths between all pairs of frames (SMCAS eq. 8):
/// a path goes from the first cell of the windows to the last by steps (1,1), (1,0)
/// and (0,1) with at most `slope` equal non-diagonal steps in a row. Ties: the shorter path, then the smaller
/// lᵢ, then the smaller lⱼ. No transition leaves its two sequences; both may be the same. A sequence of fewer
/// frames than the shortest window has no transitions.
/// Sums are exact: distances are rounded to a grid (see CostGrid), at 25 fps of 2⁻³⁹ of the largest of them
/// (2⁻³² for mean costs), so that results depend on neither threads nor vector width.
/// \param distances  frames × frames, finite and not negative.
/// \throws Error BadArgument from checkSettings, Cancelled. Cost: at most O(frames² · l_max²); beside the
/// tables, 12 bytes × frames × 16 and the distances of l_max + 16 frames for each thread.
TransitionTable transitionTable(TableView<float> distances, const FrameLayout& layout,
                                const TransitionSettings& settings, const Progress& progress = {},
                                const Executor& executor = localExecutor());

/// Transitions without warp, for comparison (SMCAS Fig. 7, "linear"): both windows have l_min frames and
/// advance together; the cost is the sum of their distances, or the mean.
/// \throws Error as transitionTable.
TransitionTable linearTransitionTable(TableView<float> distances, const FrameLayout& layout,
                                      const TransitionSettings& settings, const Progress& progress = {});

} // namespace quadrille
