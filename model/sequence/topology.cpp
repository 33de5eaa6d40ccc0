// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/topology.h"

#include "model/core/error.h"
#include "model/sequence/lazyhalfedges.h"

#include <algorithm>
#include <numeric>

namespace quadrille {

namespace {

void checkIndices(const TopologyData& data, const std::filesystem::path& file)
{
    const auto fail = [&file](const char* what, std::size_t index, std::size_t count) {
        throw Error(
            ErrorCode::IndexOutOfRange,
            {file, {}, {{"what", what}, {"index", std::to_string(index)}, {"count", std::to_string(count)}}});
    };
    if (data.vertexCount == 0)
        throw Error(ErrorCode::NoVertices, {file, {}, {}});
    if (data.triangles.empty())
        throw Error(ErrorCode::NoFaces, {file, {}, {}});
    for (const Triangle& triangle : data.triangles) {
        for (const VertexIndex v : triangle) {
            if (v.value >= data.vertexCount)
                fail("vertex", v.value, data.vertexCount);
        }
    }
    if (!data.triangleUvs.empty() && data.triangleUvs.size() != data.triangles.size())
        fail("UV triangle", data.triangleUvs.size(), data.triangles.size());
    for (const auto& corners : data.triangleUvs) {
        for (const std::uint32_t uv : corners) {
            if (uv >= data.uvs.size())
                fail("UV", uv, data.uvs.size());
        }
    }
    if (!data.triangleMaterials.empty() && data.triangleMaterials.size() != data.triangles.size())
        fail("material triangle", data.triangleMaterials.size(), data.triangles.size());
    for (const std::uint16_t material : data.triangleMaterials) {
        if (material >= data.materials.size())
            fail("material", material, data.materials.size());
    }
}

/// Disjoint sets with path halving.
class DisjointSets
{
public:
    explicit DisjointSets(std::size_t count) : m_parents(count)
    {
        std::iota(m_parents.begin(), m_parents.end(), 0U);
    }
    std::uint32_t root(std::uint32_t item)
    {
        while (m_parents[item] != item)
            item = m_parents[item] = m_parents[m_parents[item]];
        return item;
    }
    /// The root of a set is its least item.
    void join(std::uint32_t a, std::uint32_t b)
    {
        const auto [low, high] = std::minmax({root(a), root(b)});
        m_parents[high] = low;
    }

private:
    std::vector<std::uint32_t> m_parents;
};

struct EdgeUse
{
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
};

std::vector<EdgeUse> sortedEdgeUses(const std::vector<Triangle>& triangles)
{
    std::vector<EdgeUse> uses;
    uses.reserve(triangles.size() * 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto [low, high] = std::minmax(triangles[t][c].value, triangles[t][(c + 1) % 3].value);
            uses.push_back({low, high, t});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return uses;
}

/// Counts vertices whose triangles do not form one fan: they hang together by the vertex only.
std::int64_t countNonManifoldVertices(const std::vector<Triangle>& triangles,
                                      const std::vector<EdgeUse>& uses, std::uint32_t vertexCount)
{
    DisjointSets corners(triangles.size() * 3);
    const auto corner = [&triangles](std::uint32_t triangle, std::uint32_t vertex) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            if (triangles[triangle][c].value == vertex)
                return triangle * 3 + c;
        }
        return triangle * 3;
    };
    for (std::size_t i = 1; i < uses.size(); ++i) {
        const EdgeUse& a = uses[i - 1];
        const EdgeUse& b = uses[i];
        if (a.low != b.low || a.high != b.high)
            continue;
        corners.join(corner(a.triangle, a.low), corner(b.triangle, b.low));
        corners.join(corner(a.triangle, a.high), corner(b.triangle, b.high));
    }
    std::vector<std::uint32_t> fans(vertexCount, 0);
    for (std::uint32_t c = 0; c < triangles.size() * 3; ++c) {
        if (corners.root(c) == c)
            ++fans[triangles[c / 3][c % 3].value];
    }
    return std::count_if(fans.begin(), fans.end(), [](std::uint32_t n) { return n > 1; });
}

std::int64_t countLoops(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& boundary,
                        std::uint32_t vertexCount)
{
    DisjointSets sets(vertexCount);
    std::vector<bool> onBoundary(vertexCount, false);
    for (const auto& [a, b] : boundary) {
        sets.join(a, b);
        onBoundary[a] = onBoundary[b] = true;
    }
    std::int64_t loops = 0;
    for (std::uint32_t v = 0; v < vertexCount; ++v)
        loops += onBoundary[v] && sets.root(v) == v;
    return loops;
}

std::vector<std::int32_t> labelComponents(const TopologyData& data, TopologyStatistics& statistics)
{
    DisjointSets sets(data.vertexCount);
    std::vector<bool> used(data.vertexCount, false);
    for (const Triangle& triangle : data.triangles) {
        for (const VertexIndex v : triangle) {
            sets.join(triangle[0].value, v.value);
            used[v.value] = true;
        }
    }
    std::vector<std::int32_t> components(data.vertexCount, -1);
    for (std::uint32_t v = 0; v < data.vertexCount; ++v) {
        if (!used[v]) {
            ++statistics.unusedVertices;
            continue;
        }
        const std::uint32_t root = sets.root(v);
        if (root == v)
            components[v] = static_cast<std::int32_t>(statistics.components++);
        else
            components[v] = components[root];
    }
    return components;
}

} // namespace

Topology::Topology(TopologyData data, const std::filesystem::path& file)
    : m_data(std::move(data)), m_halfEdges(std::make_unique<LazyHalfEdges>())
{
    checkIndices(m_data, file);
    m_components = labelComponents(m_data, m_statistics);
    const auto uses = sortedEdgeUses(m_data.triangles);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> boundary;
    for (std::size_t i = 0; i < uses.size();) {
        std::size_t end = i + 1;
        while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high)
            ++end;
        ++m_statistics.edges;
        if (end - i == 1)
            boundary.emplace_back(uses[i].low, uses[i].high);
        m_statistics.nonManifoldEdges += end - i > 2;
        i = end;
    }
    m_statistics.boundaryEdges = static_cast<std::int64_t>(boundary.size());
    m_statistics.boundaryLoops = countLoops(boundary, m_data.vertexCount);
    m_statistics.nonManifoldVertices = countNonManifoldVertices(m_data.triangles, uses, m_data.vertexCount);
    m_statistics.eulerCharacteristic = static_cast<std::int64_t>(m_data.vertexCount) -
                                       m_statistics.unusedVertices - m_statistics.edges +
                                       static_cast<std::int64_t>(m_data.triangles.size());
}

Topology::~Topology() = default;

bool Topology::isPolygonSoup() const
{
    const auto triangles = static_cast<std::int64_t>(m_data.triangles.size());
    return triangles > 1 && m_statistics.components == triangles;
}

} // namespace quadrille
