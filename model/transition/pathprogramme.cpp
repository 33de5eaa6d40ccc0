// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/pathprogramme.h"

#include "model/transition/costgrid.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr std::uint8_t startState = 255;

} // namespace

PathProgramme::PathProgramme(int slope, int rows, int columns)
    : m_slope(slope)
    , m_states(1 + 2 * slope)
    , m_rows(rows)
    , m_columns(columns)
    , m_keys(at(rows, 0))
    , m_values(at(rows, 0) * static_cast<std::size_t>(m_states))
    , m_from(m_values.size(), startState)
{
}

void PathProgramme::take(int row, int column, int state, int fromRow, int fromColumn, int fromState)
{
    Value candidate = value(fromRow, fromColumn, fromState);
    candidate.sum += m_keys[at(row, column)];
    Value& known = value(row, column, state);
    if (candidate.sum < CostGrid::unknown && isBetter(candidate, known)) {
        known = candidate;
        m_from[at(row, column) * static_cast<std::size_t>(m_states) + static_cast<std::size_t>(state)] =
            static_cast<std::uint8_t>(fromState);
    }
}

void PathProgramme::fillCell(int row, int column, int lastStart)
{
    for (int s = 0; s < m_states; ++s)
        value(row, column, s) = {.sum = CostGrid::outOfReach, .start = -1};
    if (row == 0 && column <= lastStart)
        value(0, column, 0) = {.sum = m_keys[at(0, column)], .start = column};
    if (row > 0 && column > 0) {
        for (int s = 0; s < m_states; ++s)
            take(row, column, 0, row - 1, column - 1, s);
    }
    if (row > 0) {
        take(row, column, 1, row - 1, column, 0);
        for (int s = 1; s <= m_slope; ++s)
            take(row, column, 1, row - 1, column, m_slope + s);
        for (int s = 2; s <= m_slope; ++s)
            take(row, column, s, row - 1, column, s - 1);
    }
    if (column > 0) {
        take(row, column, m_slope + 1, row, column - 1, 0);
        for (int s = 1; s <= m_slope; ++s)
            take(row, column, m_slope + 1, row, column - 1, s);
        for (int s = 2; s <= m_slope; ++s)
            take(row, column, m_slope + s, row, column - 1, m_slope + s - 1);
    }
}

PathProgramme::Best PathProgramme::solve(int shortestRows, int shortestColumns)
{
    std::fill(m_from.begin(), m_from.end(), startState);
    for (int row = 0; row < m_rows; ++row) {
        for (int column = 0; column < m_columns; ++column)
            fillCell(row, column, m_columns - shortestColumns);
    }
    int bestRow = shortestRows - 1;
    int bestState = 0;
    for (int row = shortestRows - 1; row < m_rows; ++row) {
        for (int s = 0; s < m_states; ++s) {
            const Value& known = value(bestRow, m_columns - 1, bestState);
            const Value& found = value(row, m_columns - 1, s);
            if (row == bestRow ? isBetter(found, known) : found.sum < known.sum) {
                bestRow = row;
                bestState = s;
            }
        }
    }
    return trace(bestRow, bestState);
}

PathProgramme::Best PathProgramme::trace(int row, int state)
{
    int column = m_columns - 1;
    Best best{.key = value(row, column, state).sum, .path = {}};
    for (;;) {
        best.path.push_back({.row = row, .column = column});
        const int from =
            m_from[at(row, column) * static_cast<std::size_t>(m_states) + static_cast<std::size_t>(state)];
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
