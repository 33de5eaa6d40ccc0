// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/simd.h"
#include "model/transition/costgrid.h"
#include "model/transition/warpcell.h"
#include "model/transition/windowkernel.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// The destination frames [frame, frame + windowLanes) of a search. Columns are those of the longest window
/// of each lane: the last is the destination frame itself.
struct PairBlock
{
    const WindowSearch& search;
    double* cells;
    int frame;
    int firstColumn; ///< the first that lies in the sequence for any lane
    // per lane
    alignas(64) double factor[windowLanes];  ///< L of the mean; keys become factor · key + offset
    alignas(64) double offset[windowLanes];  ///< 1 − L − c · 2^lengthBits
    alignas(64) double sum[windowLanes];     ///< least sum of these keys
    alignas(64) double rows[windowLanes];    ///< of the source window that has it
    alignas(64) double columns[windowLanes]; ///< of the destination window that has it

    [[gnu::always_inline]] inline void loadKeys(int row, int column, double* keys) const
    {
        const double* from = search.keys + row * search.stride + frame - search.longest + 1 + column;
#pragma omp simd
        for (int l = 0; l < windowLanes; ++l)
            keys[l] = factor[l] * from[l] + offset[l];
    }
};

/// Columns that a path can cross within so many rows after its own.
template <int Slope>
constexpr int reachOf(int rows)
{
    return rows * (Slope + 1) + Slope;
}

template <int Slope>
[[gnu::always_inline]] inline void clear(PairBlock& block)
{
    std::fill_n(block.cells, block.search.longest * WarpCell<Slope>::size, CostGrid::outOfReach);
}

/// Least sums from any start in the first row to any end in the last column, and the row of the end.
template <int Slope>
[[gnu::always_inline]] inline void findEnds(PairBlock& block)
{
    const int width = block.search.longest;
    clear<Slope>(block);
    std::fill_n(block.sum, windowLanes, CostGrid::unknown);
    alignas(64) double keys[windowLanes];
    for (int row = 0; row < block.search.rows; ++row) {
        WarpRow<Slope> state;
        state.begin();
        // Paths from the columns before do not reach the last one.
        const int first =
            std::max(block.firstColumn, width - 1 - reachOf<Slope>(block.search.rows - 1 - row));
        if (first > block.firstColumn)
            std::copy_n(block.cells + (first - 1) * WarpCell<Slope>::size, windowLanes, state.diagonal);
        for (int c = first; c < width; ++c) {
            if (row == 0)
                std::fill_n(state.diagonal, windowLanes,
                            c <= width - block.search.shortest ? 0.0 : CostGrid::outOfReach);
            block.loadKeys(row, c, keys);
            state.step(keys, block.cells + c * WarpCell<Slope>::size);
        }
        if (row + 1 < block.search.shortest)
            continue;
        const double* sums = block.cells + (width - 1) * WarpCell<Slope>::size;
#pragma omp simd
        for (int l = 0; l < windowLanes; ++l) {
            const bool better = sums[l] < block.sum[l];
            block.rows[l] = better ? row + 1.0 : block.rows[l];
            block.sum[l] = better ? sums[l] : block.sum[l];
        }
    }
}

/// The shortest destination windows whose paths to the ends found have the least sums: the same programme
/// backwards. \param longest  of these paths, cells.
template <int Slope>
[[gnu::always_inline]] inline void findStarts(PairBlock& block, int longest)
{
    const int width = block.search.longest;
    const int firstStart = std::max(block.firstColumn, width - longest);
    clear<Slope>(block);
    alignas(64) double keys[windowLanes];
    const int last = static_cast<int>(*std::max_element(block.rows, block.rows + windowLanes)) - 1;
    for (int row = last; row >= 0; --row) {
        WarpRow<Slope> state;
        state.begin();
        for (int l = 0; l < windowLanes; ++l)
            state.diagonal[l] = block.rows[l] == row + 1 ? 0 : CostGrid::outOfReach;
        const int first = std::max(firstStart, width - 1 - reachOf<Slope>(last - row));
        for (int c = width - 1; c >= first; --c) {
            block.loadKeys(row, c, keys);
            state.step(keys, block.cells + c * WarpCell<Slope>::size);
        }
    }
    for (int c = firstStart; c <= width - block.search.shortest; ++c) {
        const double* sums = block.cells + c * WarpCell<Slope>::size;
        for (int l = 0; l < windowLanes; ++l) {
            if (sums[l] == block.sum[l])
                block.columns[l] = width - c;
        }
    }
}

template <int Slope>
[[gnu::always_inline]] inline void improveBlock(PairBlock& block, double lengthOne, const BestWindows* before,
                                                BestWindows& best)
{
    double steps[windowLanes];
    double lengths[windowLanes];
    double* known = best.key.data() + block.frame;
    bool any = false;
    for (int l = 0; l < windowLanes; ++l) {
        const double key = known[l];
        const bool found = key >= 0 && key < CostGrid::unknown;
        any = any || found;
        steps[l] = found ? std::floor(key / lengthOne) : 0;
        lengths[l] = found ? key - steps[l] * lengthOne : 1;
        const double near = before && block.frame + l > 0 ? before->key.data()[block.frame + l - 1] : -1;
        if (found && near >= 0 && near < CostGrid::unknown) {
            const double nearSteps = std::floor(near / lengthOne);
            const double nearLength = near - nearSteps * lengthOne;
            const bool isLess = nearSteps * lengths[l] < steps[l] * nearLength;
            steps[l] = isLess ? nearSteps : steps[l];
            lengths[l] = isLess ? nearLength : lengths[l];
        }
        block.rows[l] = 0;
        block.columns[l] = 0;
    }
    if (!any)
        return;
    for (bool better = true; better;) {
        better = false;
        for (int l = 0; l < windowLanes; ++l) {
            block.factor[l] = lengths[l];
            block.offset[l] = 1 - lengths[l] - steps[l] * lengthOne;
        }
        findEnds<Slope>(block);
        for (int l = 0; l < windowLanes; ++l) {
            if (block.sum[l] >= CostGrid::unknown)
                continue;
            const double rest = std::floor(block.sum[l] / lengthOne);
            const double length = block.sum[l] - rest * lengthOne;
            better = better || rest != 0;
            steps[l] = (rest + steps[l] * length) / lengths[l];
            lengths[l] = length;
        }
    }
    findStarts<Slope>(block, static_cast<int>(*std::max_element(lengths, lengths + windowLanes)));
    for (int l = 0; l < windowLanes; ++l) {
        if (block.sum[l] >= CostGrid::unknown)
            continue;
        known[l] = steps[l] * lengthOne + lengths[l];
        best.sourceWindow.data()[block.frame + l] = static_cast<std::uint16_t>(block.rows[l]);
        best.destinationWindow.data()[block.frame + l] = static_cast<std::uint16_t>(block.columns[l]);
    }
}

template <int Slope>
[[gnu::always_inline]] inline void improveAll(const WindowSearch& search, double lengthOne,
                                              const BestWindows* before, BestWindows& best,
                                              WindowScratch& scratch)
{
    for (int frame = 0; frame < search.columns; frame += windowLanes) {
        PairBlock block{.search = search,
                        .cells = scratch.cells.data(),
                        .frame = frame,
                        .firstColumn = std::max(0, search.longest - windowLanes - frame)};
        improveBlock<Slope>(block, lengthOne, before, best);
    }
}

} // namespace

QUADRILLE_SIMD_CLONES
void improveToLeastMeans(const WindowSearch& search, double lengthOne, const BestWindows* before,
                         BestWindows& best, WindowScratch& scratch)
{
    switch (search.slope) {
    case 2:
        return improveAll<2>(search, lengthOne, before, best, scratch);
    case 3:
        return improveAll<3>(search, lengthOne, before, best, scratch);
    case 4:
        return improveAll<4>(search, lengthOne, before, best, scratch);
    default:
        return improveAll<5>(search, lengthOne, before, best, scratch);
    }
}

} // namespace quadrille
