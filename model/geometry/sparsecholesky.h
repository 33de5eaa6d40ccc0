// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// Several columns of a Cholesky factor with the same rows below them: one dense panel, rows × columns,
/// stored by columns of `stride` numbers.
struct Supernode
{
    int first = 0;   ///< first column
    int columns = 0; ///< how many; they are also the first rows
    int rows = 0;
    int stride = 0;             ///< rows, rounded up to whole vectors
    std::size_t rowsAt = 0;     ///< of the row numbers in CholeskyPattern::rows
    std::size_t panelAt = 0;    ///< of the panel in CholeskyFactor
    std::size_t updateAt = 0;   ///< of what it adds to its parent, in the working memory
    std::size_t relativeAt = 0; ///< of its lower rows' places in the parent, in CholeskyPattern::relative
    std::size_t entriesAt = 0;  ///< of the matrix entries in its columns, in CholeskyPattern::entries
    std::size_t childrenAt = 0; ///< in CholeskyPattern::children
};

/// The symbolic part of a sparse Cholesky factorisation: order of elimination (approximate minimum degree),
/// elimination tree, supernodes. Made once for all matrices with entries at the same places; immutable.
/// Rows are renumbered: `rowOf` tells where a row of the matrix went.
///
/// Why not Eigen's SimplicialLDLT: for surfaces of 3,000 and 10,000 vertices (bench_cholesky) it factorises
/// in 3.3 to 3.8 times and solves for three right-hand sides in 2.6 times the time. Its analysis of the
/// pattern, which is done once for a surface, takes a quarter of ours.
class CholeskyPattern
{
public:
    /// \param size  rows of the matrix.
    /// \param edges  pairs of different rows with an entry off the diagonal, each pair once.
    /// \pre The edges are within the rows.
    CholeskyPattern(int size, std::span<const std::array<int, 2>> edges);

    struct Entry
    {
        int value = 0; ///< renumbered row for the diagonal, size + edge for the others
        int place = 0; ///< in the panel
    };

    int size() const { return static_cast<int>(m_rowOf.size()); }
    int edgeCount() const { return m_edgeCount; }
    int rowOf(int row) const { return m_rowOf[static_cast<std::size_t>(row)]; }
    /// Children before parents; a last empty one ends the lists of the one before it.
    const std::vector<Supernode>& supernodes() const { return m_supernodes; }
    const std::vector<int>& rows() const { return m_rows; }
    const std::vector<int>& relative() const { return m_relative; }
    const std::vector<Entry>& entries() const { return m_entries; }
    const std::vector<int>& children() const { return m_children; }
    /// Numbers in all panels together.
    std::size_t panelSize() const { return m_supernodes.back().panelAt; }
    /// Numbers of working memory for a factorisation.
    std::size_t workSize() const { return m_trailingSize + m_updatesSize; }
    std::size_t trailingSize() const { return m_trailingSize; }
    int longestRows() const { return m_longestRows; }

private:
    void layOut(std::vector<std::vector<int>> rows, const std::vector<int>& columns);
    void linkChildren();
    void placeEntries(std::span<const std::array<int, 2>> edges);
    std::size_t supernodeOf(int column) const { return m_supernodeOf[static_cast<std::size_t>(column)]; }

    int m_edgeCount = 0;
    int m_longestRows = 0;
    std::size_t m_trailingSize = 0;
    std::size_t m_updatesSize = 0;
    std::vector<int> m_rowOf;
    std::vector<std::size_t> m_supernodeOf;
    std::vector<Supernode> m_supernodes;
    std::vector<int> m_rows;
    std::vector<int> m_relative;
    std::vector<Entry> m_entries;
    std::vector<int> m_children;
};

/// The numeric part: a multifrontal factorisation L·Lᵀ in dense panels, vectorised.
class CholeskyFactor
{
public:
    /// Factorises a matrix with the entries of a pattern. Pivots that rounding made vanish are raised to
    /// 1e-13 of their diagonal entry, so the factorisation of a positive semi-definite matrix always ends.
    /// \param values  diagonal entries by renumbered rows, then the others by edges.
    /// \pre The pattern outlives the factor.
    void factorise(const CholeskyPattern& pattern, std::span<const double> values);

    /// Solves for several right-hand sides at once, in place: twelve take far less time than three times
    /// four. \param x  (rows + 1) × 4 · groups in the order of `CholeskyPattern::rowOf`; the last row is not
    /// touched. \param groups  of four right-hand sides each. \pre It is 1 or 3.
    void solve(std::span<double> x, std::size_t groups = 1) const;

    /// Right-hand sides of a group.
    static constexpr int lanes = 4;

private:
    const CholeskyPattern* m_pattern = nullptr;
    std::vector<double> m_panels;
};

} // namespace quadrille
