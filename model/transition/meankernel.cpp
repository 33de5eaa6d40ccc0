// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/simd.h"
#include "model/transition/costgrid.h"
#include "model/transition/warpcell.h"
#include "model/transition/windowkernel.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace quadrille {

namespace {

/// The destination frames [frame, frame + windowLanes) of a search. Columns are those of the longest window
/// of each lane: the last is the destination frame itself.
struct PairBlock
{
    const WindowSearch& search;
    double* cells;        ///< out of reach beyond [first, last]
    double* bounds;       ///< what paths from each column add at least, windowLanes for each
    const double* minima; ///< least key of each frame of the destination sequence
    int frame;
    int firstColumn; ///< the first that lies in the sequence for any lane
    int first = 0;   ///< columns of the last row that paths may go on from
    int last = -1;
    // per lane
    alignas(64) double factor[windowLanes];  ///< L of the mean; keys become factor · key + offset
    alignas(64) double offset[windowLanes];  ///< 1 − L − c · 2^lengthBits
    alignas(64) double limit[windowLanes];   ///< no path with a greater sum of these keys counts
    alignas(64) double sum[windowLanes];     ///< least sum of these keys
    alignas(64) double rows[windowLanes];    ///< of the source window that has it
    alignas(64) double columns[windowLanes]; ///< of the destination window that has it

    [[gnu::always_inline]] inline Lanes keysAt(int row, int column) const
    {
        const double* from = search.keys + row * search.stride + frame - search.longest + 1 + column;
        return Lanes::load(factor) * Lanes::load(from) + Lanes::load(offset);
    }

    /// The least keys of a column.
    [[gnu::always_inline]] inline void loadLeast(int column, double* keys) const
    {
        const double* from = minima + frame - search.longest + 1 + column;
#pragma omp simd
        for (int l = 0; l < windowLanes; ++l)
            keys[l] = factor[l] * from[l] + offset[l];
    }

    /// Whether a path to a cell may yet be one that counts.
    template <int Slope>
    [[gnu::always_inline]] inline bool isAlive(int column) const
    {
        const double* sums = cells + column * WarpCell<Slope>::size;
        const double* rest = bounds + std::ptrdiff_t{column} * windowLanes;
        int any = 0;
#pragma omp simd reduction(| : any)
        for (int l = 0; l < windowLanes; ++l)
            any |= sums[l] + rest[l] <= limit[l] ? 1 : 0;
        return any != 0;
    }

    /// Leaves out the cells at both ends of a row from which no path counts.
    template <int Slope>
    [[gnu::always_inline]] inline void trim()
    {
        for (; last >= first && !isAlive<Slope>(last); --last)
            std::fill_n(cells + last * WarpCell<Slope>::size, WarpCell<Slope>::size, CostGrid::outOfReach);
        for (; first <= last && !isAlive<Slope>(first); ++first)
            std::fill_n(cells + first * WarpCell<Slope>::size, WarpCell<Slope>::size, CostGrid::outOfReach);
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

/// What paths that come to each column add at least: some more cells in it, and one or more in those up to
/// the last.
template <int Slope>
[[gnu::always_inline]] inline void setBoundsOfEnds(PairBlock& block)
{
    alignas(64) double least[windowLanes];
    alignas(64) double beyond[windowLanes] = {};
    for (int c = block.search.longest - 1; c >= block.firstColumn; --c) {
        block.loadLeast(c, least);
        double* rest = block.bounds + std::ptrdiff_t{c} * windowLanes;
#pragma omp simd
        for (int l = 0; l < windowLanes; ++l) {
            rest[l] = beyond[l] + Slope * lesser(least[l], 0.0);
            beyond[l] = rest[l] + least[l];
        }
    }
}

/// The same of paths backwards, which may end in any column.
template <int Slope>
[[gnu::always_inline]] inline void setBoundsOfStarts(PairBlock& block)
{
    alignas(64) double least[windowLanes];
    alignas(64) double beyond[windowLanes] = {};
    for (int c = block.firstColumn; c < block.search.longest; ++c) {
        block.loadLeast(c, least);
        double* rest = block.bounds + std::ptrdiff_t{c} * windowLanes;
#pragma omp simd
        for (int l = 0; l < windowLanes; ++l) {
            rest[l] = beyond[l] + Slope * lesser(least[l], 0.0);
            beyond[l] = lesser(rest[l] + least[l], 0.0);
        }
    }
}

/// Least sums from any start in the first row to any end in the last column, and the row of the end.
template <int Slope>
[[gnu::always_inline]] inline void findEnds(PairBlock& block)
{
    const int width = block.search.longest;
    clear<Slope>(block);
    setBoundsOfEnds<Slope>(block);
    block.first = block.firstColumn;
    block.last = width - 1;
    for (int row = 0; row < block.search.rows && block.first <= block.last; ++row) {
        WarpRow<Slope> state;
        // Paths from the columns before do not reach the last one.
        block.first = std::max(block.first, width - 1 - reachOf<Slope>(block.search.rows - 1 - row));
        if (block.first > block.firstColumn)
            state.diagonal = Lanes::load(block.cells + (block.first - 1) * WarpCell<Slope>::size);
        int c = block.first;
        for (; c < width && (c <= block.last + 1 || block.isAlive<Slope>(c - 1)); ++c) {
            if (row == 0)
                state.diagonal = Lanes::all(c <= width - block.search.shortest ? 0 : CostGrid::outOfReach);
            state.step(block.keysAt(row, c), block.cells + c * WarpCell<Slope>::size);
        }
        block.last = c - 1;
        if (row + 1 >= block.search.shortest) {
            const double* sums = block.cells + (width - 1) * WarpCell<Slope>::size;
#pragma omp simd
            for (int l = 0; l < windowLanes; ++l) {
                const bool better = sums[l] < block.sum[l];
                block.rows[l] = better ? row + 1.0 : block.rows[l];
                block.sum[l] = better ? sums[l] : block.sum[l];
            }
        }
        block.trim<Slope>();
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
    setBoundsOfStarts<Slope>(block);
    const int lastRow = static_cast<int>(*std::max_element(block.rows, block.rows + windowLanes)) - 1;
    block.first = width;
    block.last = width - 1;
    for (int row = lastRow; row >= 0; --row) {
        WarpRow<Slope> state;
        bool isEnd = false;
        for (const auto rows : std::span(block.rows, windowLanes))
            isEnd |= rows == row + 1;
        if (isEnd) {
            block.last = width - 1;
            double starts[windowLanes];
            for (int l = 0; l < windowLanes; ++l)
                starts[l] = block.rows[l] == row + 1 ? 0 : CostGrid::outOfReach;
            state.diagonal = Lanes::load(starts);
        }
        const int first = std::max(firstStart, width - 1 - reachOf<Slope>(lastRow - row));
        int c = block.last;
        for (; c >= first && (c >= block.first - 1 || block.isAlive<Slope>(c + 1)); --c) {
            state.step(block.keysAt(row, c), block.cells + c * WarpCell<Slope>::size);
        }
        block.first = c + 1;
        if (row > 0)
            block.trim<Slope>();
    }
    for (int c = firstStart; c <= width - block.search.shortest; ++c) {
        const double* sums = block.cells + c * WarpCell<Slope>::size;
        for (int l = 0; l < windowLanes; ++l) {
            if (sums[l] == block.sum[l])
                block.columns[l] = width - c;
        }
    }
}

/// More than what bounds of the sum are rounded by, which need not be exact as sums are.
[[gnu::always_inline]] inline double limitOf(double sum, double lengthOne)
{
    return sum + lengthOne;
}

template <int Slope>
[[gnu::always_inline]] inline void improveBlock(PairBlock& block, double lengthOne, const BestWindows* before,
                                                BestWindows& best)
{
    // Of the mean, and of the best path that is known: sums of steps, and cells.
    double steps[windowLanes];
    double lengths[windowLanes];
    double pathSteps[windowLanes];
    double pathLengths[windowLanes];
    bool isOver[windowLanes];
    double* known = best.key.data() + block.frame;
    bool any = false;
    for (int l = 0; l < windowLanes; ++l) {
        const double key = known[l];
        const bool found = key >= 0 && key < CostGrid::unknown;
        any = any || found;
        isOver[l] = !found;
        steps[l] = pathSteps[l] = found ? std::floor(key / lengthOne) : 0;
        lengths[l] = pathLengths[l] = found ? key - steps[l] * lengthOne : 1;
        const double near = before && block.frame + l > 0 ? before->key.data()[block.frame + l - 1] : -1;
        if (found && near >= 0 && near < CostGrid::unknown) {
            const double nearSteps = std::floor(near / lengthOne);
            const double nearLength = near - nearSteps * lengthOne;
            const bool isLess = nearSteps * lengths[l] < steps[l] * nearLength;
            steps[l] = isLess ? nearSteps : steps[l];
            lengths[l] = isLess ? nearLength : lengths[l];
        }
        block.factor[l] = 1;
        block.offset[l] = 0;
        block.sum[l] = CostGrid::unknown;
        block.rows[l] = 0;
        block.columns[l] = 0;
    }
    while (any) {
        for (int l = 0; l < windowLanes; ++l) {
            block.limit[l] = -CostGrid::outOfReach;
            if (isOver[l])
                continue;
            block.factor[l] = lengths[l];
            block.offset[l] = 1 - lengths[l] - steps[l] * lengthOne;
            block.limit[l] =
                limitOf((lengths[l] * pathSteps[l] - steps[l] * pathLengths[l]) * lengthOne + pathLengths[l],
                        lengthOne);
            block.sum[l] = CostGrid::unknown;
        }
        findEnds<Slope>(block);
        any = false;
        for (int l = 0; l < windowLanes; ++l) {
            if (isOver[l])
                continue;
            const double rest = std::floor(block.sum[l] / lengthOne);
            const double length = block.sum[l] - rest * lengthOne;
            isOver[l] = rest == 0;
            any = any || !isOver[l];
            steps[l] = pathSteps[l] = (rest + steps[l] * length) / lengths[l];
            lengths[l] = pathLengths[l] = length;
        }
    }
    int longest = 0;
    for (int l = 0; l < windowLanes; ++l) {
        const bool found = block.sum[l] < CostGrid::unknown;
        block.limit[l] = found ? limitOf(block.sum[l], lengthOne) : -CostGrid::outOfReach;
        longest = found ? std::max(longest, static_cast<int>(lengths[l])) : longest;
    }
    if (longest == 0)
        return;
    findStarts<Slope>(block, longest);
    for (int l = 0; l < windowLanes; ++l) {
        if (block.sum[l] >= CostGrid::unknown)
            continue;
        known[l] = steps[l] * lengthOne + lengths[l];
        best.sourceWindow.data()[block.frame + l] = static_cast<std::uint16_t>(block.rows[l]);
        best.destinationWindow.data()[block.frame + l] = static_cast<std::uint16_t>(block.columns[l]);
    }
}

/// Least keys of the columns, margins and all. \return that of the first frame of the destination sequence.
[[gnu::always_inline]] inline const double* setMinima(const WindowSearch& search, WindowScratch& scratch)
{
    scratch.columnMinima.resize(static_cast<std::size_t>(search.stride));
    double* minima = scratch.columnMinima.data();
    std::copy_n(search.keys - search.margin(), search.stride, minima);
    for (int row = 1; row < search.rows; ++row) {
        const double* keys = search.keys - search.margin() + row * search.stride;
#pragma omp simd
        for (std::ptrdiff_t x = 0; x < search.stride; ++x)
            minima[x] = lesser(minima[x], keys[x]);
    }
    return minima + search.margin();
}

template <int Slope>
[[gnu::always_inline]] inline void improveAll(const WindowSearch& search, double lengthOne,
                                              const BestWindows* before, BestWindows& best,
                                              WindowScratch& scratch)
{
    const double* minima = setMinima(search, scratch);
    for (int frame = 0; frame < search.columns; frame += windowLanes) {
        PairBlock block{.search = search,
                        .cells = scratch.cells.data(),
                        .bounds = scratch.bounds.data(),
                        .minima = minima,
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
    scratch.bounds.resize(
        std::max(scratch.bounds.size(), static_cast<std::size_t>(search.longest * windowLanes)));
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
