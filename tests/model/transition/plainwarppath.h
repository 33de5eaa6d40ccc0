// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille {

/// The warp path of the least sum from the first corner of some cells to the last, state by state: 0 after a
/// diagonal step, 1 … slope after so many steps down, then as many to the right. Of paths that are equal the
/// one whose states, from the end on, are the least.
inline std::vector<std::pair<int, int>> plainWarpPath(const Table<float>& cells, int slope)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    const auto rows = static_cast<int>(cells.rows());
    const auto columns = static_cast<int>(cells.cols());
    const int states = 1 + 2 * slope;
    const auto at = [&](int row, int column, int state) {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                static_cast<std::size_t>(column)) *
                   static_cast<std::size_t>(states) +
               static_cast<std::size_t>(state);
    };
    std::vector<double> sums(at(rows, 0, 0), none);
    std::vector<int> from(sums.size(), -1);
    const auto isDown = [&](int state) { return state >= 1 && state <= slope; };
    const auto mayFollow = [&](int before, int state) {
        if (state == 0)
            return true;
        if (state == 1)
            return !isDown(before);
        if (state == slope + 1)
            return before <= slope;
        return before == state - 1;
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            // Of equal sums the shorter path is better.
            const double here = static_cast<double>(cells(row, column)) + 0x1p-40;
            if (row == 0 && column == 0)
                sums[at(0, 0, 0)] = here;
            for (int state = 0; state < states; ++state) {
                const int above = row - (state <= slope ? 1 : 0);
                const int before = column - (isDown(state) ? 0 : 1);
                for (int last = 0; above >= 0 && before >= 0 && last < states; ++last) {
                    const double sum = sums[at(above, before, last)] + here;
                    if (mayFollow(last, state) && sum < sums[at(row, column, state)]) {
                        sums[at(row, column, state)] = sum;
                        from[at(row, column, state)] = last;
                    }
                }
            }
        }
    }
    std::vector<std::pair<int, int>> path;
    int row = rows - 1;
    int column = columns - 1;
    const auto* ends = sums.data() + at(row, column, 0);
    int state = static_cast<int>(std::min_element(ends, ends + states) - ends);
    if (ends[state] == none)
        return path;
    while (state >= 0) {
        path.emplace_back(row, column);
        const int before = from[at(row, column, state)];
        row -= state <= slope ? 1 : 0;
        column -= isDown(state) ? 0 : 1;
        state = before;
    }
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace quadrille
