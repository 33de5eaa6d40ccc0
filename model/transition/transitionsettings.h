// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace quadrille {

/// What the cost of a warp path is.
enum class TransitionCost
{
    Sum,  ///< sum of the pose distances of its cells (SMCAS eq. 8); favours short windows
    Mean, ///< sum divided by the number of cells
};

/// What the costs of transitions weigh against each other, once they are found.
enum class CostScale
{
    None,       ///< pose distances as they are (SMCAS eq. 10)
    Liveliness, ///< over how lively their two sequences are: between calm takes less goes unnoticed
};

/// How many frames a transition lasts, L.
enum class TransitionLength
{
    Path,    ///< as many as its warp path has cells (SMCAS §4.1): both takes together slow down
    Windows, ///< the mean of its two windows, rounded up: both takes together keep their pace
};

/// How transitions are sought; the defaults are the paper's (SMCAS §3.3).
struct TransitionSettings
{
    static constexpr int leastSlope = 2;
    static constexpr int greatestSlope = 5;
    static constexpr int greatestWindow = 4095;

    double fps = 25; ///< frames per second of all sequences
    /// l_min, frames: the shortest source or destination window; empty: a third of a second, rounded up.
    std::optional<int> shortestWindow;
    /// l_max, frames: the longest window; empty: two seconds, rounded down.
    std::optional<int> longestWindow;
    /// Where the shortest window is more than three tenths of one of the two takes, so many do.
    bool shortensInShortTakes = false;
    /// Steps in a row in which only one of the two sequences goes on, 2 … 5: more bend time further.
    int slope = 3;
    TransitionCost cost = TransitionCost::Sum;
    TransitionLength length = TransitionLength::Path;

    /// l_min in frames, at least 1.
    int shortest() const;
    /// Between takes of so many frames.
    int shortestBetween(int sourceFrames, int destinationFrames) const;
    /// l_max in frames, at least l_min where it is not given.
    int longest() const;
    /// L of a warp path of so many cells: at least 1, at most `cells`.
    int lengthOf(int cells, int sourceWindow, int destinationWindow) const;
    bool operator==(const TransitionSettings&) const = default;
};

/// \throws Error BadArgument with the setting that cannot be.
void checkSettings(const TransitionSettings& settings);

} // namespace quadrille
