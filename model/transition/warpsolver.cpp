// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/warpsolver.h"

#include "model/transition/costgrid.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr std::uint8_t startState = 255;

} // namespace

WarpSolver::WarpSolver(int slope, int rows, int columns)
    : m_slope(slope)
    , m_states(1 + 2 * slope)
    , m_rows(rows)
    , m_columns(columns)
    , m_keys(at(rows, 0))
    , m_values(at(rows, 0) * static_cast<std::size_t>(m_states))
    , m_from(m_values.size(), startState)
    , m_origins(m_keys.size())
{
}

void WarpSolver::fillCell(int row, int column, int lastStart)
{
    const double key = m_keys[at(row, column)];
    Value* here = m_values.data() + firstStateAt(row, column);
    std::uint8_t* from = m_from.data() + firstStateAt(row, column);
    std::fill_n(here, m_states, Value{.sum = CostGrid::outOfReach, .start = -1});
    std::fill_n(from, m_states, startState);
    const auto take = [&](int state, const Value& value, int before) {
        here[state] = {.sum = value.sum + key, .start = value.start};
        from[state] = static_cast<std::uint8_t>(before);
    };
    if (row == 0 && column <= lastStart)
        here[0] = {.sum = key, .start = column};
    if (row > 0 && column > 0) {
        const Origin& origin = m_origins[at(row - 1, column - 1)].diagonal;
        take(0, origin.value, origin.state);
    }
    if (row > 0) {
        const Origin& origin = m_origins[at(row - 1, column)].down;
        const Value* above = m_values.data() + firstStateAt(row - 1, column);
        take(1, origin.value, origin.state);
        for (int s = 2; s <= m_slope; ++s)
            take(s, above[s - 1], s - 1);
    }
    if (column > 0) {
        const Origin& origin = m_origins[at(row, column - 1)].right;
        const Value* left = m_values.data() + firstStateAt(row, column - 1);
        take(m_slope + 1, origin.value, origin.state);
        for (int s = m_slope + 2; s < m_states; ++s)
            take(s, left[s - 1], s - 1);
    }
    setOrigins(row, column);
}

void WarpSolver::setOrigins(int row, int column)
{
    const Value* here = m_values.data() + firstStateAt(row, column);
    const auto best = [here](Origin origin, int first, int last) {
        for (int s = first; s <= last; ++s) {
            if (isBetter(here[s], origin.value))
                origin = {.value = here[s], .state = s};
        }
        return origin;
    };
    const Origin straight{.value = here[0], .state = 0};
    const Origin right = best(straight, 1, m_slope);
    m_origins[at(row, column)] = {.diagonal = best(right, m_slope + 1, m_states - 1),
                                  .down = best(straight, m_slope + 1, m_states - 1),
                                  .right = right};
}

WarpSolver::Best WarpSolver::solve(int shortestRows, int shortestColumns)
{
    for (int row = 0; row < m_rows; ++row) {
        for (int column = 0; column < m_columns; ++column)
            fillCell(row, column, m_columns - shortestColumns);
    }
    int bestRow = shortestRows - 1;
    const auto sumAt = [this](int row) { return m_origins[at(row, m_columns - 1)].diagonal.value.sum; };
    for (int row = shortestRows; row < m_rows; ++row) {
        if (sumAt(row) < sumAt(bestRow))
            bestRow = row;
    }
    return trace(bestRow, m_origins[at(bestRow, m_columns - 1)].diagonal.state);
}

WarpSolver::Best WarpSolver::trace(int row, int state)
{
    int column = m_columns - 1;
    Best best{.key = m_values[firstStateAt(row, column) + static_cast<std::size_t>(state)].sum, .path = {}};
    best.path.reserve(static_cast<std::size_t>(m_rows) + static_cast<std::size_t>(m_columns));
    for (;;) {
        best.path.push_back({.row = row, .column = column});
        const int from = m_from[firstStateAt(row, column) + static_cast<std::size_t>(state)];
        if (from == startState)
            break;
        if (state <= m_slope)
            --row;
        if (state == 0 || state > m_slope)
            --column;
        state = from;
    }
    std::reverse(best.path.begin(), best.path.end());
    return best;
}

} // namespace quadrille
