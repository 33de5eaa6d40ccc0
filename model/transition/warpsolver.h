// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace quadrille {

/// The dynamic programme of SMCAS §3.3 over one table of cells, from its first corner to its last, with the
/// way back: which windows are best is known before (see windowkernel.h). Cells hold whole numbers, as sums
/// along paths do, so that the way back is found by comparing them.
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
        double key = 0;         ///< sum over the path; at least CostGrid::unknown where there is none
        std::vector<Cell> path; ///< empty where there is none
    };

    WarpSolver(int slope, int rows, int columns);

    /// Sets the cells of a row. \param distances  one for each column. \param unit  of CostGrid.
    void setRow(int row, const float* distances, double unit);
    /// The path with the least sum of keys, factor · cell + offset; of several the one with its diagonal
    /// steps latest. \pre All rows are set; keys and their sums are whole numbers below 2^53.
    /// Cost: O(rows · columns · slope).
    Best solve(double factor, double offset);

private:
    std::size_t at(int row, int column) const
    {
        return static_cast<std::size_t>(row + m_slope) * m_stride +
               static_cast<std::size_t>(column + m_slope);
    }
    /// Steps that may lead to a cell.
    enum class Kind
    {
        Any,
        NotDown,
        NotRight,
    };
    struct Place
    {
        Cell cell;
        Kind kind;
    };
    /// How the best path of a kind comes to a cell: adds the cells of its last run of steps, last first.
    /// \return where that run begins.
    Place goBack(const Place& place, std::vector<Cell>& path) const;

    // Tables of rows and columns, with `slope` of them before the first, out of reach.
    int m_slope;
    int m_rows;
    int m_columns;
    std::size_t m_stride;
    std::vector<double> m_cells;
    std::vector<double> m_keys;
    std::vector<double> m_all;      ///< least sums of paths to each cell
    std::vector<double> m_notDown;  ///< of those whose last step is not down
    std::vector<double> m_notRight; ///< of those whose last step is not to the right
};

} // namespace quadrille
