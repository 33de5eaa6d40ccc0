// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/windowkernel.h"

#include "model/core/simd.h"
#include "model/transition/costgrid.h"
#include "model/transition/warpcell.h"

#include <algorithm>

namespace quadrille {

namespace {

/// The destination starts [start, start + windowLanes) of a search.
template <int Slope>
struct WindowBlock
{
    const WindowSearch& search;
    BestWindows& best;
    double* cells;        ///< of the row before, then of this one; out of reach beyond `last`
    const double* minima; ///< least key of each column
    double* bounds;       ///< see setBounds
    int start;
    int end;       ///< of the destination frames that windows may reach
    int width;     ///< columns that a window of the first lane may have
    int first = 0; ///< columns, from the start of each lane, from which paths may go on
    int last = -1;

    const double* keysAt(int row, int column) const
    {
        return search.keys + row * search.stride + start + column;
    }
    double* cellAt(int column) const { return cells + column * WarpCell<Slope>::size; }
};

[[gnu::always_inline]] inline bool anyNotAbove(const double* values, const double* limits)
{
    int any = 0;
#pragma omp simd reduction(| : any)
    for (int l = 0; l < windowLanes; ++l)
        any |= values[l] <= limits[l] ? 1 : 0;
    return any != 0;
}

/// What the sum of a path to destination frame x must not exceed, so that going on is worth while: the
/// greatest, over the frames j from x on, of the best sum known for j less the least that the columns up to j
/// add. \param last  the last frame whose best sum is new.
template <int Slope>
[[gnu::always_inline]] inline void setBounds(const WindowBlock<Slope>& block, int last)
{
    const int begin = block.start + block.search.shortest - 1;
    double bound = last + 1 < block.end ? block.bounds[last + 1] - block.minima[last + 1] : -1;
    for (int x = last; x >= block.start; --x) {
        if (x >= begin)
            bound = std::max(bound, block.best.key[static_cast<std::size_t>(x)]);
        block.bounds[x] = bound;
        bound -= block.minima[x];
    }
}

/// Takes the sums of the windows that end in this row where they are better than what is known.
template <int Slope>
[[gnu::always_inline]] inline void takeBest(const WindowBlock<Slope>& block, int row)
{
    int lastChanged = -1;
    const auto sourceWindow = static_cast<std::uint16_t>(row + 1);
    for (int c = std::max(block.first, block.search.shortest - 1); c <= block.last; ++c) {
        const double* sums = block.cellAt(c);
        double* known = block.best.key.data() + block.start + c;
        std::uint16_t* knownSource = block.best.sourceWindow.data() + block.start + c;
        std::uint16_t* knownDestination = block.best.destinationWindow.data() + block.start + c;
        if (!anyNotAbove(sums, known))
            continue;
        for (int l = 0; l < windowLanes; ++l) {
            // An equal sum from a later start has a shorter destination window.
            if (sums[l] > known[l] || (sums[l] == known[l] && sourceWindow >= knownSource[l]))
                continue;
            known[l] = sums[l];
            knownSource[l] = sourceWindow;
            knownDestination[l] = static_cast<std::uint16_t>(c + 1);
            lastChanged = std::max(lastChanged, block.start + c + l);
        }
    }
    if (lastChanged >= 0)
        setBounds(block, lastChanged);
}

/// One row of the dynamic programme, over the columns that the row before reached and as far as it goes on.
template <int Slope>
[[gnu::always_inline]] inline void advance(WindowBlock<Slope>& block, int row)
{
    WarpRow<Slope> state;
    int c = block.first;
    if (row == 0) {
        state.start(Lanes::load(block.keysAt(0, 0)), block.cellAt(0));
        c = 1;
    }
    const int reached = row == 0 ? 0 : block.last + 1;
    for (; c < block.width; ++c) {
        if (c > reached && !anyNotAbove(block.cellAt(c - 1), block.bounds + block.start + c - 1))
            break;
        state.step(Lanes::load(block.keysAt(row, c)), block.cellAt(c));
    }
    block.last = c - 1;
}

/// Leaves out the cells at both ends of the row from which no path is worth while.
template <int Slope>
[[gnu::always_inline]] inline void trim(WindowBlock<Slope>& block)
{
    for (; block.last >= block.first; --block.last) {
        double* cell = block.cellAt(block.last);
        if (anyNotAbove(cell, block.bounds + block.start + block.last))
            break;
        std::fill_n(cell, WarpCell<Slope>::size, CostGrid::outOfReach);
    }
    for (; block.first <= block.last; ++block.first) {
        double* cell = block.cellAt(block.first);
        if (anyNotAbove(cell, block.bounds + block.start + block.first))
            break;
        std::fill_n(cell, WarpCell<Slope>::size, CostGrid::outOfReach);
    }
}

template <int Slope>
[[gnu::always_inline]] inline void searchBlock(WindowBlock<Slope> block)
{
    std::fill_n(block.bounds + block.end, windowLanes, -1.0);
    setBounds(block, block.end - 1);
    for (int row = 0; row < block.search.rows && (row == 0 || block.first <= block.last); ++row) {
        advance(block, row);
        if (row + 1 >= block.search.shortest)
            takeBest(block, row);
        trim(block);
    }
    for (int c = block.first; c <= block.last; ++c)
        std::fill_n(block.cellAt(c), WarpCell<Slope>::size, CostGrid::outOfReach);
}

template <int Slope>
[[gnu::always_inline]] inline void searchAll(const WindowSearch& search, BestWindows& best,
                                             WindowScratch& scratch)
{
    double* minima = scratch.columnMinima.data();
    std::copy_n(search.keys, search.columns, minima);
    for (int row = 1; row < search.rows; ++row) {
        const double* keys = search.keys + row * search.stride;
#pragma omp simd
        for (int x = 0; x < search.columns; ++x)
            minima[x] = std::min(minima[x], keys[x]);
    }
    const int lastStart = search.columns - search.shortest;
    for (int start = lastStart / windowLanes * windowLanes; start >= 0; start -= windowLanes)
        searchBlock<Slope>({.search = search,
                            .best = best,
                            .cells = scratch.cells.data(),
                            .minima = minima,
                            .bounds = scratch.bounds.data(),
                            .start = start,
                            .end = std::min(search.columns, start + windowLanes - 1 + search.longest),
                            .width = std::min(search.longest, search.columns - start)});
}

} // namespace

QUADRILLE_SIMD_CLONES
void searchLeastSums(const WindowSearch& search, BestWindows& best, WindowScratch& scratch)
{
    const int columns = search.columns + search.margin();
    const auto wide = static_cast<std::size_t>(columns);
    best.key.assign(wide, -1);
    std::fill_n(best.key.begin(), search.columns, CostGrid::unknown);
    best.sourceWindow.assign(wide, 0);
    best.destinationWindow.assign(wide, 0);
    scratch.bounds.resize(wide);
    scratch.columnMinima.resize(wide);
    const int cells = search.longest * windowLanes * (search.slope + 1);
    scratch.cells.assign(static_cast<std::size_t>(cells), CostGrid::outOfReach);
    if (search.rows < search.shortest || search.columns < search.shortest)
        return;
    switch (search.slope) {
    case 2:
        return searchAll<2>(search, best, scratch);
    case 3:
        return searchAll<3>(search, best, scratch);
    case 4:
        return searchAll<4>(search, best, scratch);
    default:
        return searchAll<5>(search, best, scratch);
    }
}

} // namespace quadrille
