// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/sparsecholesky.h"

#include "model/geometry/indices.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>

namespace quadrille {

namespace {

constexpr int vectorLength = 8;

using Neighbours = std::vector<std::vector<int>>;

/// Of each row the place in an order of elimination with little fill.
std::vector<int> minimumDegreeOrder(int size, std::span<const std::array<int, 2>> edges)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(2 * edges.size() + at(size));
    for (int row = 0; row < size; ++row)
        entries.emplace_back(row, row, 1.0);
    for (const auto& [a, b] : edges) {
        entries.emplace_back(a, b, 1.0);
        entries.emplace_back(b, a, 1.0);
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(matrix, order);
    // The ordering gives the old row of each new one.
    std::vector<int> rowOf(at(size));
    for (int place = 0; place < size; ++place)
        rowOf[at(order.indices()[place])] = place;
    return rowOf;
}

Neighbours lowerNeighbours(const std::vector<int>& rowOf, std::span<const std::array<int, 2>> edges)
{
    Neighbours lower(rowOf.size());
    for (const auto& [a, b] : edges) {
        const auto [low, high] = std::minmax(rowOf[at(a)], rowOf[at(b)]);
        lower[at(low)].push_back(high);
    }
    return lower;
}

/// Rows of every column of the factor, the diagonal first, ascending.
Neighbours columnRows(const Neighbours& lower)
{
    const int size = static_cast<int>(lower.size());
    Neighbours rows(lower.size());
    Neighbours children(lower.size());
    std::vector<int> seenIn(lower.size(), -1);
    for (int column = 0; column < size; ++column) {
        std::vector<int>& own = rows[at(column)];
        own.push_back(column);
        seenIn[at(column)] = column;
        const auto add = [&](const std::vector<int>& others) {
            for (const int row : others) {
                if (row > column && seenIn[at(row)] != column) {
                    seenIn[at(row)] = column;
                    own.push_back(row);
                }
            }
        };
        add(lower[at(column)]);
        for (const int child : children[at(column)])
            add(rows[at(child)]);
        std::sort(own.begin(), own.end());
        if (own.size() > 1)
            children[at(own[1])].push_back(column);
    }
    return rows;
}

/// Numbers the columns so that each follows its subtree of the elimination tree.
std::vector<int> postorder(const Neighbours& rows)
{
    const int size = static_cast<int>(rows.size());
    Neighbours children(rows.size());
    std::vector<int> stack;
    for (int column = size - 1; column >= 0; --column) {
        if (rows[at(column)].size() > 1)
            children[at(rows[at(column)][1])].push_back(column);
        else
            stack.push_back(column);
    }
    // Depth first from the roots, parents before children; read backwards it is a postorder.
    std::vector<int> placeOf(rows.size());
    int place = size;
    while (!stack.empty()) {
        const int column = stack.back();
        stack.pop_back();
        placeOf[at(column)] = --place;
        stack.insert(stack.end(), children[at(column)].begin(), children[at(column)].end());
    }
    return placeOf;
}

/// Whether a child is worth joining with its parent though zeros have to be stored.
bool worthJoining(int childColumns, int parentColumns, std::size_t childRows, std::size_t parentRows)
{
    const int columns = childColumns + parentColumns;
    const auto trapezoid = [](std::size_t rows, int width) {
        return static_cast<double>(rows) * width - 0.5 * width * (width - 1);
    };
    const double joined = trapezoid(parentRows + at(childColumns), columns);
    const double apart = trapezoid(childRows, childColumns) + trapezoid(parentRows, parentColumns);
    const double zeros = (joined - apart) / joined;
    return columns <= 4 || (columns <= 16 && zeros < 0.4) || (columns <= 48 && zeros < 0.1) || zeros < 0.05;
}

/// Joins columns to supernodes: those with the same rows, then small children with their parents.
void joinColumns(Neighbours& rows, std::vector<int>& columns)
{
    Neighbours joined;
    for (std::vector<int>& own : rows) {
        joined.push_back(std::move(own));
        columns.push_back(1);
        while (joined.size() > 1) {
            const std::vector<int>& parent = joined.back();
            const std::vector<int>& child = joined[joined.size() - 2];
            const int childColumns = columns[columns.size() - 2];
            const std::size_t below = child.size() - at(childColumns);
            // The parent holds the first row below the child's columns.
            if (below == 0 || child[at(childColumns)] >= parent.front() + columns.back())
                break;
            if (below != parent.size() &&
                !worthJoining(childColumns, columns.back(), child.size(), parent.size()))
                break;
            std::vector<int> both(child.begin(), child.begin() + childColumns);
            both.insert(both.end(), parent.begin(), parent.end());
            joined.pop_back();
            joined.back() = std::move(both);
            columns[columns.size() - 2] += columns.back();
            columns.pop_back();
        }
    }
    rows = std::move(joined);
}

} // namespace

CholeskyPattern::CholeskyPattern(int size, std::span<const std::array<int, 2>> edges)
    : m_edgeCount(static_cast<int>(edges.size()))
{
    m_rowOf = minimumDegreeOrder(size, edges);
    const std::vector<int> placeOf = postorder(columnRows(lowerNeighbours(m_rowOf, edges)));
    for (int& row : m_rowOf)
        row = placeOf[at(row)];
    Neighbours rows = columnRows(lowerNeighbours(m_rowOf, edges));
    std::vector<int> columns;
    joinColumns(rows, columns);
    layOut(std::move(rows), columns);
    linkChildren();
    placeEntries(edges);
}

void CholeskyPattern::layOut(std::vector<std::vector<int>> rows, const std::vector<int>& columns)
{
    Supernode next;
    for (std::size_t s = 0; s < rows.size(); ++s) {
        next.columns = columns[s];
        next.rows = static_cast<int>(rows[s].size());
        next.stride = (next.rows + vectorLength - 1) / vectorLength * vectorLength;
        m_supernodes.push_back(next);
        m_supernodeOf.insert(m_supernodeOf.end(), at(next.columns), s);
        m_rows.insert(m_rows.end(), rows[s].begin(), rows[s].end());
        next.first += next.columns;
        next.rowsAt = m_rows.size();
        next.panelAt += at(next.stride) * at(next.columns);
        m_longestRows = std::max(m_longestRows, next.rows);
        m_trailingSize =
            std::max(m_trailingSize, at(next.stride) * at(next.rows - next.columns + vectorLength));
    }
    next.columns = next.rows = next.stride = 0;
    m_supernodes.push_back(next);
}

void CholeskyPattern::linkChildren()
{
    const std::size_t count = m_supernodes.size() - 1;
    Neighbours children(count);
    for (std::size_t s = 0; s < count; ++s) {
        Supernode& child = m_supernodes[s];
        child.relativeAt = m_relative.size();
        if (child.rows == child.columns)
            continue;
        const int* below = &m_rows[child.rowsAt + at(child.columns)];
        const std::size_t parentIndex = supernodeOf(*below);
        children[parentIndex].push_back(static_cast<int>(s));
        const Supernode& parent = m_supernodes[parentIndex];
        const auto begin = m_rows.begin() + static_cast<std::ptrdiff_t>(parent.rowsAt);
        for (int r = 0; r < child.rows - child.columns; ++r) {
            const auto found = std::lower_bound(begin, begin + parent.rows, below[r]);
            m_relative.push_back(static_cast<int>(found - begin));
        }
    }
    // What children add to their parents lies on a stack.
    std::size_t top = 0;
    for (std::size_t s = 0; s < count; ++s) {
        Supernode& parent = m_supernodes[s];
        parent.childrenAt = m_children.size();
        for (const int child : children[s]) {
            m_children.push_back(child);
            const Supernode& node = m_supernodes[at(child)];
            top -= at(node.rows - node.columns) * at(node.rows - node.columns);
        }
        parent.updateAt = m_trailingSize + top;
        top += at(parent.rows - parent.columns) * at(parent.rows - parent.columns);
        m_updatesSize = std::max(m_updatesSize, top);
    }
    m_supernodes.back().childrenAt = m_children.size();
    m_supernodes.back().relativeAt = m_relative.size();
}

void CholeskyPattern::placeEntries(std::span<const std::array<int, 2>> edges)
{
    std::vector<std::vector<Entry>> entries(m_supernodes.size() - 1);
    const auto place = [&](int value, int low, int high) {
        const std::size_t s = supernodeOf(low);
        const Supernode& node = m_supernodes[s];
        const auto begin = m_rows.begin() + static_cast<std::ptrdiff_t>(node.rowsAt);
        const auto row = std::lower_bound(begin, begin + node.rows, high) - begin;
        entries[s].push_back({value, (low - node.first) * node.stride + static_cast<int>(row)});
    };
    for (int row = 0; row < size(); ++row)
        place(row, row, row);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto [low, high] = std::minmax({rowOf(edges[e][0]), rowOf(edges[e][1])});
        place(size() + static_cast<int>(e), low, high);
    }
    for (std::size_t s = 0; s < entries.size(); ++s) {
        m_supernodes[s].entriesAt = m_entries.size();
        m_entries.insert(m_entries.end(), entries[s].begin(), entries[s].end());
    }
    m_supernodes.back().entriesAt = m_entries.size();
}

} // namespace quadrille
