// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/vertextriangles.h"

#include <algorithm>

namespace quadrille {

VertexTriangles::VertexTriangles(const Topology& topology)
    : m_topology(&topology), m_starts(topology.vertexCount() + 1U)
{
    const std::vector<Triangle>& triangles = topology.triangles();
    for (const Triangle& t : triangles) {
        for (const VertexIndex v : t)
            ++m_starts[v.value + 1];
    }
    for (std::size_t v = 1; v < m_starts.size(); ++v)
        m_starts[v] += m_starts[v - 1];
    m_triangles.resize(m_starts.back());
    std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (const VertexIndex v : triangles[t])
            m_triangles[next[v.value]++] = t;
    }
    m_beside.resize(triangles.size(), {none, none, none});
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (const std::uint32_t other : of(triangles[t][c])) {
                if (other != t && hasCorner(triangles[other], triangles[t][(c + 1) % 3]))
                    m_beside[t][c] = m_beside[t][c] == none ? other : several;
            }
        }
    }
}

std::vector<std::uint32_t> VertexTriangles::besideEdge(std::uint32_t triangle, std::size_t corner) const
{
    const Triangle& t = m_topology->triangles()[triangle];
    std::vector<std::uint32_t> found;
    for (const std::uint32_t other : of(t[corner])) {
        if (other != triangle && hasCorner(m_topology->triangles()[other], t[(corner + 1) % 3]))
            found.push_back(other);
    }
    return found;
}

bool hasCorner(const Triangle& triangle, VertexIndex v)
{
    return std::ranges::find(triangle, v) != triangle.end();
}

bool hasDirectedEdge(const Triangle& triangle, VertexIndex from, VertexIndex to)
{
    for (std::size_t c = 0; c < 3; ++c) {
        if (triangle[c] == from && triangle[(c + 1) % 3] == to)
            return true;
    }
    return false;
}

bool haveEdge(const Topology& topology, const VertexTriangles& around, VertexIndex a, VertexIndex b)
{
    return a != b && std::ranges::any_of(around.of(a), [&](std::uint32_t t) {
               return hasCorner(topology.triangles()[t], b);
           });
}

namespace {

/// Grows over edges that are not the curve's.
class SideGrowth
{
public:
    SideGrowth(const Topology& topology, const VertexTriangles& around, std::span<const VertexIndex> curve)
        : m_topology(topology)
        , m_around(around)
        , m_sides(topology.triangles().size())
        , m_next(topology.vertexCount(), none)
    {
        for (std::size_t i = 0; i < curve.size(); ++i)
            m_next[curve[i].value] = curve[(i + 1) % curve.size()].value;
    }

    /// False where it meets the other side.
    bool growFrom(std::uint32_t seed, TriangleSide side)
    {
        if (m_sides[seed] != TriangleSide::Elsewhere)
            return m_sides[seed] == side;
        m_sides[seed] = side;
        std::vector<std::uint32_t> left{seed};
        while (!left.empty()) {
            const std::uint32_t here = left.back();
            const Triangle& t = m_topology.triangles()[here];
            left.pop_back();
            for (std::size_t c = 0; c < 3; ++c) {
                const VertexIndex a = t[c];
                const VertexIndex b = t[(c + 1) % 3];
                if (m_next[a.value] == b.value || m_next[b.value] == a.value)
                    continue;
                bool meetsOther = false;
                m_around.forEachBeside(here, c, [&](std::uint32_t neighbour) {
                    if (m_sides[neighbour] == side)
                        return;
                    meetsOther = meetsOther || m_sides[neighbour] != TriangleSide::Elsewhere;
                    m_sides[neighbour] = side;
                    left.push_back(neighbour);
                });
                if (meetsOther)
                    return false;
            }
        }
        return true;
    }

    std::vector<TriangleSide> take() { return std::move(m_sides); }

private:
    static constexpr std::uint32_t none = ~0U;
    const Topology& m_topology;
    const VertexTriangles& m_around;
    std::vector<TriangleSide> m_sides;
    std::vector<std::uint32_t> m_next; ///< of each vertex of the curve the following one
};

} // namespace

std::optional<std::vector<TriangleSide>> curveSides(const Topology& topology, const VertexTriangles& around,
                                                    std::span<const VertexIndex> curve)
{
    SideGrowth growth(topology, around, curve);
    bool hasLeft = false;
    bool hasRight = false;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const VertexIndex from = curve[i];
        const VertexIndex to = curve[(i + 1) % curve.size()];
        for (const std::uint32_t t : around.of(from)) {
            const Triangle& triangle = topology.triangles()[t];
            if (!hasCorner(triangle, to))
                continue;
            const bool isLeft = hasDirectedEdge(triangle, from, to);
            (isLeft ? hasLeft : hasRight) = true;
            if (!growth.growFrom(t, isLeft ? TriangleSide::Left : TriangleSide::Right))
                return std::nullopt;
        }
    }
    if (!hasLeft || !hasRight)
        return std::nullopt;
    return growth.take();
}

} // namespace quadrille
