// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/poissonsystem.h"

#include "model/core/simd.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Half the cotangent of 60 degrees.
constexpr double equilateralWeight = 0.28867513459481287;

using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

/// Adds GᵀD·G̃ to the rows of x.
QUADRILLE_SIMD_CLONES void addDivergence(const PoissonSystem& system,
                                         const std::vector<std::array<double, 3>>& weights,
                                         std::span<const TriangleEdges> edges, double* x)
{
    for (std::size_t m = 0; m < edges.size(); ++m) {
        const auto& [r1, r2, r3] = system.triangleRows()[m];
        const auto& [w1, w2, w3] = weights[m];
        const Four first = *reinterpret_cast<const Four*>(edges[m].first.data());
        const Four second = *reinterpret_cast<const Four*>(edges[m].second.data());
        const Four across = (first - second) * w3;
        const Four at1 = across + first * w2;
        const Four at2 = second * w1 - across;
        *reinterpret_cast<Four*>(x + std::ptrdiff_t{4} * r1) += at1;
        *reinterpret_cast<Four*>(x + std::ptrdiff_t{4} * r2) += at2;
        *reinterpret_cast<Four*>(x + std::ptrdiff_t{4} * r3) -= at1 + at2;
    }
}

} // namespace

/// Rows and edges before the elimination reorders them.
struct PoissonSystem::Numbering
{
    explicit Numbering(const Topology& topology);

    std::vector<int> rows; ///< per vertex; −1 where there is none
    int rowCount = 0;
    std::vector<std::array<int, 3>>
        triangleEdges; ///< opposite the corners; −1 where both ends are one vertex
    std::size_t edgeCount = 0;
    std::vector<std::array<int, 2>> entries; ///< rows of the edges between two rows
    std::vector<int> entryOf;                ///< per edge; −1 at pinned vertices
};

PoissonSystem::Numbering::Numbering(const Topology& topology) : rows(topology.vertexCount(), -1)
{
    std::vector<bool> pinned(static_cast<std::size_t>(topology.statistics().components), false);
    for (std::size_t v = 0; v < rows.size(); ++v) {
        const std::int32_t component = topology.components()[v];
        if (component < 0)
            continue;
        if (pinned[static_cast<std::size_t>(component)])
            rows[v] = rowCount++;
        pinned[static_cast<std::size_t>(component)] = true;
    }
    struct Side
    {
        std::uint32_t low;
        std::uint32_t high;
        std::size_t triangle;
        std::size_t corner;
    };
    std::vector<Side> sides;
    triangleEdges.assign(topology.triangles().size(), {-1, -1, -1});
    for (std::size_t m = 0; m < triangleEdges.size(); ++m) {
        const Triangle& triangle = topology.triangles()[m];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto [low, high] =
                std::minmax(triangle[(corner + 1) % 3].value, triangle[(corner + 2) % 3].value);
            if (low != high)
                sides.push_back({low, high, m, corner});
        }
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    for (std::size_t s = 0; s < sides.size(); ++s) {
        const Side& side = sides[s];
        if (s == 0 || side.low != sides[s - 1].low || side.high != sides[s - 1].high) {
            const std::array<int, 2> ends{rows[side.low], rows[side.high]};
            const bool inMatrix = ends[0] >= 0 && ends[1] >= 0;
            entryOf.push_back(inMatrix ? static_cast<int>(entries.size()) : -1);
            if (inMatrix)
                entries.push_back(ends);
            ++edgeCount;
        }
        triangleEdges[side.triangle][side.corner] = static_cast<int>(edgeCount) - 1;
    }
}

PoissonSystem::PoissonSystem(const std::shared_ptr<const Topology>& topology)
    : PoissonSystem(topology, Numbering(*topology))
{
}

PoissonSystem::PoissonSystem(std::shared_ptr<const Topology> topology, const Numbering& numbering)
    : m_topology(std::move(topology))
    , m_pattern(numbering.rowCount, numbering.entries)
    , m_componentSizes(static_cast<std::size_t>(m_topology->statistics().components), 0)
{
    for (const int row : numbering.rows)
        m_rows.push_back(row < 0 ? rowCount() : m_pattern.rowOf(row));
    for (const std::int32_t component : m_topology->components()) {
        if (component >= 0)
            ++m_componentSizes[static_cast<std::size_t>(component)];
    }
    const int noValue = rowCount() + m_pattern.edgeCount();
    for (std::size_t m = 0; m < triangleCount(); ++m) {
        const Triangle& triangle = m_topology->triangles()[m];
        std::array<int, 3> rows{};
        std::array<int, 3> values{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            rows[corner] = m_rows[triangle[corner].value];
            const int edge = numbering.triangleEdges[m][corner];
            const int entry = edge < 0 ? -1 : numbering.entryOf[static_cast<std::size_t>(edge)];
            values[corner] = entry < 0 ? noValue : rowCount() + entry;
        }
        m_triangleRows.push_back(rows);
        m_triangleValues.push_back(values);
    }
    linkTriangles(numbering.triangleEdges, numbering.edgeCount);
}

void PoissonSystem::linkTriangles(const std::vector<std::array<int, 3>>& triangleEdges, std::size_t edgeCount)
{
    std::vector<int> lastAt(edgeCount, -1);
    for (std::size_t m = 0; m < triangleEdges.size(); ++m) {
        for (const int edge : triangleEdges[m]) {
            if (edge < 0)
                continue;
            int& last = lastAt[static_cast<std::size_t>(edge)];
            if (last >= 0 && last != static_cast<int>(m))
                m_dualEdges.push_back({last, static_cast<int>(m)});
            last = static_cast<int>(m);
        }
    }
    std::vector<std::vector<int>> neighbours(triangleCount());
    for (const auto& [a, b] : m_dualEdges) {
        neighbours[static_cast<std::size_t>(a)].push_back(b);
        neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    m_neighbourStarts.push_back(0);
    for (const std::vector<int>& own : neighbours) {
        m_neighbours.insert(m_neighbours.end(), own.begin(), own.end());
        m_neighbourStarts.push_back(static_cast<int>(m_neighbours.size()));
    }
}

PoissonPose::PoissonPose(const PoissonSystem& system, const PoseFrames& frames)
    : m_system(&system), m_weights(frames.size())
{
    for (std::size_t m = 0; m < m_weights.size(); ++m) {
        const double b11 = frames.b11[m];
        const double b12 = frames.b12[m];
        const double perHeight = 0.5 / frames.b22[m];
        m_weights[m] = {(b11 - b12) * perHeight,
                        (b12 * (b12 - b11) + frames.b22[m] * frames.b22[m]) / b11 * perHeight,
                        b12 * perHeight};
    }
    for (const int m : frames.degenerate) {
        const std::array<int, 3>& rows = system.triangleRows()[static_cast<std::size_t>(m)];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const bool isEdge = rows[(corner + 1) % 3] != rows[(corner + 2) % 3];
            m_weights[static_cast<std::size_t>(m)][corner] = isEdge ? equilateralWeight : 0.0;
        }
    }

    const auto rowCount = static_cast<std::size_t>(system.rowCount());
    // The diagonal, the edges, and one value for edges that end at a pinned vertex.
    std::vector<double> values(rowCount + static_cast<std::size_t>(system.pattern().edgeCount()) + 1, 0.0);
    std::vector<double> diagonal(rowCount + 1, 0.0);
    for (std::size_t m = 0; m < m_weights.size(); ++m) {
        const auto& [w1, w2, w3] = m_weights[m];
        const auto& [e1, e2, e3] = system.triangleValues()[m];
        const auto& [r1, r2, r3] = system.triangleRows()[m];
        values[static_cast<std::size_t>(e1)] -= w1;
        values[static_cast<std::size_t>(e2)] -= w2;
        values[static_cast<std::size_t>(e3)] -= w3;
        diagonal[static_cast<std::size_t>(r1)] += w2 + w3;
        diagonal[static_cast<std::size_t>(r2)] += w3 + w1;
        diagonal[static_cast<std::size_t>(r3)] += w1 + w2;
    }
    std::copy_n(diagonal.begin(), rowCount, values.begin());
    m_factor.factorise(system.pattern(), values);
}

void PoissonPose::solve(std::span<const TriangleEdges> edges, std::vector<double>& x) const
{
    constexpr std::size_t lanes = CholeskyFactor::lanes;
    const auto rowCount = static_cast<std::size_t>(m_system->rowCount());
    x.assign((rowCount + 1) * lanes, 0.0);
    addDivergence(*m_system, m_weights, edges, x.data());
    std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(rowCount * lanes), lanes, 0.0);
    m_factor.solve(x);
}

} // namespace quadrille
