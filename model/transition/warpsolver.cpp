// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/warpsolver.h"

#include "model/core/simd.h"
#include "model/transition/costgrid.h"
#include "model/transition/warpcell.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Pointers to the same row of each table, at its first column.
struct SolverRow
{
    const double* cells;
    double* keys;
    double* all;
    double* notDown;
    double* notRight;
    std::ptrdiff_t stride;
    int columns;
    int slope;
};

QUADRILLE_SIMD_CLONES
void roundToGrid(const float* distances, int count, double unit, double* cells)
{
    const double perStep = 1 / unit;
#pragma omp simd
    for (int c = 0; c < count; ++c)
        cells[c] = std::rint(static_cast<double>(distances[c]) * perStep);
}

/// A row of the programme. Runs of steps down or to the right begin where the last step was another, so that
/// a cell needs the sums of the `Slope` cells above and before it only, and the columns of a row do not wait
/// for each other.
template <int Slope>
[[gnu::always_inline]] inline void fillRowOf(const SolverRow& row, double factor, double offset, bool isFirst)
{
    double* const keys = row.keys;
    double* const notDown = row.notDown;
    double* const notRight = row.notRight;
    const double* const before = row.all - row.stride - 1;
    // notDown keeps the diagonal steps until rights are known.
#pragma omp simd
    for (int c = 0; c < row.columns; ++c) {
        keys[c] = factor * row.cells[c] + offset;
        notDown[c] = before[c] + keys[c];
    }
    if (isFirst)
        notDown[0] = keys[0];
#pragma omp simd
    for (int c = 0; c < row.columns; ++c) {
        double run = 0;
        double least = notDown[c];
        for (std::ptrdiff_t s = 1; s <= Slope; ++s) {
            run += keys[c - (s - 1) * row.stride];
            least = lesser(least, notDown[c - s * row.stride] + run);
        }
        notRight[c] = least;
    }
#pragma omp simd
    for (int c = 0; c < row.columns; ++c) {
        double run = 0;
        double rights = CostGrid::outOfReach;
        for (std::ptrdiff_t s = 1; s <= Slope; ++s) {
            run += keys[c - s + 1];
            rights = lesser(rights, notRight[c - s] + run);
        }
        notDown[c] = lesser(notDown[c], rights);
        row.all[c] = lesser(notRight[c], rights);
    }
}

QUADRILLE_SIMD_CLONES
void fillRow(const SolverRow& row, double factor, double offset, bool isFirst)
{
    switch (row.slope) {
    case 2:
        return fillRowOf<2>(row, factor, offset, isFirst);
    case 3:
        return fillRowOf<3>(row, factor, offset, isFirst);
    case 4:
        return fillRowOf<4>(row, factor, offset, isFirst);
    default:
        return fillRowOf<5>(row, factor, offset, isFirst);
    }
}

} // namespace

WarpSolver::WarpSolver(int slope, int rows, int columns)
    : m_slope(slope)
    , m_rows(rows)
    , m_columns(columns)
    , m_stride(static_cast<std::size_t>(columns + slope))
    , m_cells(static_cast<std::size_t>(rows + slope) * m_stride)
    , m_keys(m_cells.size())
    , m_all(m_cells.size(), CostGrid::outOfReach)
    , m_notDown(m_all)
    , m_notRight(m_all)
{
}

void WarpSolver::setRow(int row, const float* distances, double unit)
{
    roundToGrid(distances, m_columns, unit, m_cells.data() + at(row, 0));
}

WarpSolver::Best WarpSolver::solve(double factor, double offset)
{
    for (int row = 0; row < m_rows; ++row) {
        const std::size_t first = at(row, 0);
        fillRow({.cells = m_cells.data() + first,
                 .keys = m_keys.data() + first,
                 .all = m_all.data() + first,
                 .notDown = m_notDown.data() + first,
                 .notRight = m_notRight.data() + first,
                 .stride = static_cast<std::ptrdiff_t>(m_stride),
                 .columns = m_columns,
                 .slope = m_slope},
                factor, offset, row == 0);
    }
    Best best{.key = m_all[at(m_rows - 1, m_columns - 1)], .path = {}};
    if (best.key >= CostGrid::unknown)
        return best;
    best.path.reserve(static_cast<std::size_t>(m_rows) + static_cast<std::size_t>(m_columns));
    Place place{.cell = {.row = m_rows - 1, .column = m_columns - 1}, .kind = Kind::Any};
    while (place.cell.row >= 0)
        place = goBack(place, best.path);
    std::reverse(best.path.begin(), best.path.end());
    return best;
}

WarpSolver::Place WarpSolver::goBack(const Place& place, std::vector<Cell>& path) const
{
    const auto [row, column] = place.cell;
    const std::vector<double>& sums = place.kind == Kind::Any       ? m_all
                                      : place.kind == Kind::NotDown ? m_notDown
                                                                    : m_notRight;
    const double sum = sums[at(row, column)];
    const bool isStart = row == 0 && column == 0;
    if (isStart || m_all[at(row - 1, column - 1)] + m_keys[at(row, column)] == sum) {
        path.push_back(place.cell);
        return {.cell = {.row = row - 1, .column = column - 1}, .kind = Kind::Any};
    }
    if (place.kind != Kind::NotDown) {
        double run = 0;
        for (int s = 1; s <= m_slope; ++s) {
            run += m_keys[at(row - s + 1, column)];
            if (m_notDown[at(row - s, column)] + run != sum)
                continue;
            for (int step = 0; step < s; ++step)
                path.push_back({.row = row - step, .column = column});
            return {.cell = {.row = row - s, .column = column}, .kind = Kind::NotDown};
        }
    }
    double run = 0;
    int s = 1;
    for (; s < m_slope; ++s) {
        run += m_keys[at(row, column - s + 1)];
        if (m_notRight[at(row, column - s)] + run == sum)
            break;
    }
    for (int step = 0; step < s; ++step)
        path.push_back({.row = row, .column = column - step});
    return {.cell = {.row = row, .column = column - s}, .kind = Kind::NotRight};
}

} // namespace quadrille
