// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// The dynamic programme of SMCAS §3.3 over one table of keys, with the way back. Paths start in
/// the first row and end in the last column.
class WarpSolver
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

    WarpSolver(int slope, int rows, int columns);

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
    /// A state of a cell that a path goes on from.
    struct Origin
    {
        Value value;
        int state;
    };
    /// The best of the states of a cell that each kind of step may follow.
    struct Origins
    {
        Origin diagonal; ///< any state
        Origin down;     ///< not after a step down
        Origin right;    ///< not after a step to the right
    };
    std::size_t firstStateAt(int row, int column) const
    {
        return at(row, column) * static_cast<std::size_t>(m_states);
    }
    void setOrigins(int row, int column);
    void fillCell(int row, int column, int lastStart);
    Best trace(int row, int state);

    // States of a cell: 0 by a diagonal step or at the start, 1 … slope after so many steps down,
    // slope + 1 … 2 · slope after so many steps to the right.
    int m_slope;
    int m_states;
    int m_rows;
    int m_columns;
    std::vector<double> m_keys;
    std::vector<Value> m_values;      ///< of each state of each cell
    std::vector<std::uint8_t> m_from; ///< state before each state; startState at the start
    std::vector<Origins> m_origins;   ///< of each cell
};

} // namespace quadrille
