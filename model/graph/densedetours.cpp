// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// Floyd–Warshall in rounds of `pivots` junctions. The table holds only walks with a node between; a walk of
// any kind is the smaller of weight and table. A node is never a pivot for its own row or column (its entry
// with itself counts as infinite), so that no edge passes as its own detour. Each round
//   1. closes the square of the pivots,
//   2. extends it to the pivots' rows: from a pivot, through pivots and earlier nodes, to any node,
//   3. joins, for every pair, the walk to the first pivot with the pivot's row.
#include "model/core/simd.h"
#include "model/graph/detours.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <limits>
#include <memory>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace quadrille {
namespace {

using Index = Eigen::Index;

constexpr double none = std::numeric_limits<double>::infinity();
constexpr Index pivots = 64;
/// A tile fills half of the 32 vector registers of AVX-512 and all 16 of AVX2.
constexpr Index tileRows = 4;
constexpr Index tileColumns = 16;
constexpr Index bandRows = 32;

/// Lowers the tile at a column of four rows to the sums of `left` (depth × tileRows) and `right`
/// (depth × tileColumns), the smallest over the depth.
inline __attribute__((always_inline)) void lowerTile(double* const* rows, Index column, const double* left,
                                                     const double* right, Index depth)
{
    double tile[tileRows][tileColumns];
    for (Index r = 0; r < tileRows; ++r)
        for (Index c = 0; c < tileColumns; ++c)
            tile[r][c] = rows[r][column + c];
    for (Index k = 0; k < depth; ++k) {
#pragma GCC unroll 4
        for (Index r = 0; r < tileRows; ++r) {
            const double toPivot = left[k * tileRows + r];
#pragma omp simd
            for (Index c = 0; c < tileColumns; ++c) {
                const double sum = toPivot + right[k * tileColumns + c];
                tile[r][c] = sum < tile[r][c] ? sum : tile[r][c];
            }
        }
    }
    for (Index r = 0; r < tileRows; ++r)
        for (Index c = 0; c < tileColumns; ++c)
            rows[r][column + c] = tile[r][c];
}

/// The same for `groups` groups of four rows (with their parts of `left` one after the other), in columns
/// `first` … `end`; `right` holds the tiles of those columns one after the other.
QUADRILLE_SIMD_CLONES
void lowerRows(double* const* rows, Index groups, Index first, Index end, const double* left,
               const double* right, Index depth)
{
    for (Index column = first; column < end; column += tileColumns, right += depth * tileColumns) {
        const Index width = std::min(tileColumns, end - column);
        for (Index group = 0; group < groups; ++group) {
            double* const* groupRows = rows + group * tileRows;
            const double* groupLeft = left + group * tileRows * depth;
            if (width == tileColumns) {
                lowerTile(groupRows, column, groupLeft, right, depth);
                continue;
            }
            double edge[tileRows][tileColumns] = {};
            double* edgeRows[tileRows];
            for (Index r = 0; r < tileRows; ++r) {
                edgeRows[r] = edge[r];
                std::copy_n(groupRows[r] + column, width, edge[r]);
            }
            lowerTile(edgeRows, 0, groupLeft, right, depth);
            for (Index r = 0; r < tileRows; ++r)
                std::copy_n(edge[r], width, groupRows[r] + column);
        }
    }
}

struct PivotSquare
{
    double walks[pivots][pivots];   ///< of any kind; infinite on the diagonal
    double detours[pivots][pivots]; ///< with a node between
};

QUADRILLE_SIMD_CLONES
void close(PivotSquare& square, Index depth)
{
    for (Index k = 0; k < depth; ++k) {
        for (Index i = 0; i < depth; ++i) {
            if (i == k)
                continue;
            const double toPivot = square.walks[i][k];
            const double own = square.walks[i][i];
#pragma omp simd
            for (Index j = 0; j < depth; ++j) {
                const double sum = toPivot + square.walks[k][j];
                square.detours[i][j] = sum < square.detours[i][j] ? sum : square.detours[i][j];
                square.walks[i][j] = sum < square.walks[i][j] ? sum : square.walks[i][j];
            }
            square.walks[i][i] = own;
        }
    }
}

/// One computation; its rounds run one after the other, each on all cores.
class DetourSearch
{
public:
    DetourSearch(const Table<double>& weights, std::span<const NodeIndex> junctions, Table<double>& detours)
        : m_weights(weights)
        , m_junctions(junctions)
        , m_detours(detours)
        , m_count(weights.rows())
        , m_right(static_cast<std::size_t>((m_count + tileColumns) * pivots))
        , m_unusedRow(static_cast<std::size_t>(m_count))
    {
    }

    void run(const Progress& progress)
    {
        const Index rounds = (std::ssize(m_junctions) + pivots - 1) / pivots;
        const Index bands = (m_count + bandRows - 1) / bandRows;
        const Index tiles = (m_count + tileColumns - 1) / tileColumns;
        std::atomic<Index> done = 0;
        for (Index round = 0; round < rounds; ++round) {
            const Index first = round * pivots;
            m_depth = std::min(pivots, std::ssize(m_junctions) - first);
            m_pivots =
                m_junctions.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(m_depth));
            closePivots();
            tbb::parallel_for(tbb::blocked_range<Index>(0, tiles, 4),
                              [&](const auto& range) { extendPivotRows(range.begin(), range.end()); });
            tbb::parallel_for(Index{0}, bands, [&](Index band) {
                joinBand(band * bandRows);
                progress.report(++done, rounds * bands);
            });
        }
    }

private:
    double walk(Index i, Index j) const { return i == j ? none : std::min(m_weights(i, j), m_detours(i, j)); }
    Index pivot(Index k) const { return m_pivots[static_cast<std::size_t>(k)]; }
    double* row(Index i) { return i < m_count ? &m_detours(i, 0) : m_unusedRow.data(); }

    void closePivots()
    {
        for (Index i = 0; i < m_depth; ++i) {
            for (Index j = 0; j < m_depth; ++j) {
                m_square.walks[i][j] = walk(pivot(i), pivot(j));
                m_square.detours[i][j] = m_detours(pivot(i), pivot(j));
            }
        }
        close(m_square, m_depth);
        for (Index i = 0; i < m_depth; ++i)
            for (Index j = 0; j < m_depth; ++j)
                m_detours(pivot(i), pivot(j)) = m_square.detours[i][j];
        for (Index i = 0; i < pivots; ++i)
            for (Index k = 0; k < m_depth; ++k)
                m_left[(i / tileRows * m_depth + k) * tileRows + i % tileRows] =
                    i < m_depth ? m_square.walks[i][k] : none;
    }

    /// The walks from the pivots to the columns of some tiles; leaves them in m_right.
    void extendPivotRows(Index firstTile, Index endTile)
    {
        const Index first = firstTile * tileColumns;
        const Index end = std::min(endTile * tileColumns, m_count);
        double* const right = &m_right[static_cast<std::size_t>(first * m_depth)];
        std::array<double*, pivots> rows{};
        for (Index i = 0; i < pivots; ++i)
            rows[static_cast<std::size_t>(i)] = row(i < m_depth ? pivot(i) : m_count);
        packPivotRows(first, end, right);
        lowerRows(rows.data(), (m_depth + tileRows - 1) / tileRows, first, end, m_left.data(), right,
                  m_depth);
        packPivotRows(first, end, right);
    }

    void packPivotRows(Index first, Index end, double* right) const
    {
        for (Index tile = first; tile < end; tile += tileColumns)
            for (Index k = 0; k < m_depth; ++k)
                for (Index j = tile; j < tile + tileColumns; ++j)
                    *right++ = j < end ? walk(pivot(k), j) : none;
    }

    /// Every pair from the rows of one band.
    void joinBand(Index firstRow)
    {
        std::array<double, bandRows * pivots> left;
        std::array<double*, bandRows> rows{};
        for (Index r = 0; r < bandRows; ++r) {
            const Index i = firstRow + r;
            rows[static_cast<std::size_t>(r)] = row(i);
            double* const target = left.data() + r / tileRows * m_depth * tileRows + r % tileRows;
            for (Index k = 0; k < m_depth; ++k)
                target[k * tileRows] = i < m_count ? walk(i, pivot(k)) : none;
        }
        const Index rowCount = std::min(bandRows, m_count - firstRow);
        lowerRows(rows.data(), (rowCount + tileRows - 1) / tileRows, 0, m_count, left.data(), m_right.data(),
                  m_depth);
    }

    const Table<double>& m_weights;
    std::span<const NodeIndex> m_junctions;
    Table<double>& m_detours;
    Index m_count;
    std::span<const NodeIndex> m_pivots; ///< junctions of this round
    Index m_depth = 0;                   ///< their number
    PivotSquare m_square{};
    std::array<double, pivots * pivots> m_left{}; ///< walks between pivots, in groups of four rows
    std::vector<double> m_right;                  ///< walks from pivots to all nodes, in tiles
    std::vector<double> m_unusedRow;              ///< stands for rows past the last; zeros are never lowered
};

} // namespace

void lowerDetoursDensely(const Table<double>& weights, std::span<const NodeIndex> junctions,
                         Table<double>& detours, const Progress& progress)
{
    assert(weights.rows() == weights.cols());
    assert(detours.rows() == weights.rows() && detours.cols() == weights.cols());
    if (weights.size() > 0)
        std::make_unique<DetourSearch>(weights, junctions, detours)->run(progress);
}

} // namespace quadrille
