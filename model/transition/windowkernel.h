// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// Destination frames that are computed together.
constexpr int windowLanes = 8;

/// All windows that start at one source frame, against one destination sequence.
struct WindowSearch
{
    /// Keys of CostGrid, rows × stride: row a is the source frame a after the start, column 0 the first frame
    /// of the destination sequence; before and after it there are margin() columns out of reach.
    const double* keys = nullptr;
    std::ptrdiff_t stride = 0;
    int rows = 0;    ///< source frames up to the end of their sequence, at most `longest`
    int columns = 0; ///< frames of the destination sequence
    int shortest = 1;
    int longest = 1;
    int slope = 3;

    /// Columns on either side of the destination sequence.
    int margin() const { return longest + windowLanes; }
};

/// The best windows for each destination frame; CostGrid::unknown where there are none.
struct BestWindows
{
    std::vector<double> key; ///< sum over the path
    std::vector<std::uint16_t> sourceWindow;
    std::vector<std::uint16_t> destinationWindow;
};

/// Memory that searches use again.
struct WindowScratch
{
    std::vector<double> cells;
    std::vector<double> bounds;
    std::vector<double> columnMinima;
};

/// Least sums of keys: one dynamic programme for each destination start gives all windows from there at once.
/// It follows only cells from which a path may still be as good as the best that is
/// known: destination starts go from last to first, so that the shortest windows of later starts bound the
/// longer ones of earlier starts.
void searchLeastSums(const WindowSearch& search, BestWindows& best, WindowScratch& scratch);

/// Least means of keys, from the least sums: Dinkelbach's method, for windowLanes pairs of frames at a time.
/// A mean c/L that is not far off is taken off every cell; the path of the least sum over all windows that
/// end in the two frames, by one dynamic programme, gives the next mean, until that sum is zero. Every step
/// is exact, so the last is the optimum; what follows cells from which no path can be the best is left out;
/// sums, lengths and windows become those of its path. \param before the least means of the source frame
/// before against the same destination sequence, where they are known: to begin with the mean of the pair of
/// frames before takes fewer programmes.
void improveToLeastMeans(const WindowSearch& search, double lengthOne, const BestWindows* before,
                         BestWindows& best, WindowScratch& scratch);

} // namespace quadrille
