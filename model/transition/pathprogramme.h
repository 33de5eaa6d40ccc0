// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// The dynamic programme of ALGORITHMS section 3 over one table of keys, with the way back. Paths start in
/// the first row and end in the last column.
class PathProgramme
{
public:
    struct Cell
    {
        int row;
        int column;
    };
    struct Best
    {
        double key = 0;
        std::vector<Cell> path;
    };

    PathProgramme(int slope, int rows, int columns);

    double& key(int row, int column) { return m_keys[at(row, column)]; }
    /// The path of the least sum of keys; ties: the earlier end, then the later start.
    /// \param shortestRows  of a path, at most `rows`. \param shortestColumns  likewise.
    Best solve(int shortestRows, int shortestColumns);

private:
    struct Value
    {
        double sum;
        int start; ///< column of the first cell
    };
    static bool isBetter(const Value& a, const Value& b)
    {
        return a.sum < b.sum || (a.sum == b.sum && a.start > b.start);
    }
    std::size_t at(int row, int column) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(column);
    }
    Value& value(int row, int column, int state)
    {
        return m_values[at(row, column) * static_cast<std::size_t>(m_states) +
                        static_cast<std::size_t>(state)];
    }
    void take(int row, int column, int state, int fromRow, int fromColumn, int fromState);
    void fillCell(int row, int column, int lastStart);
    Best trace(int row, int state);

    // States of a cell: 0 by a diagonal step or at the start, 1 … slope after so many steps down,
    // slope + 1 … 2 · slope after so many steps to the right.
    int m_slope;
    int m_states;
    int m_rows;
    int m_columns;
    std::vector<double> m_keys;
    std::vector<Value> m_values;
    std::vector<std::uint8_t> m_from; ///< state before each state; startState at the start
};

} // namespace quadrille
