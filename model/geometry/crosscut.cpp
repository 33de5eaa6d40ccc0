// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/crosscut.h"

#include <algorithm>

namespace quadrille {

namespace {

VertexIndex thirdCorner(const Triangle& t, VertexIndex a, VertexIndex b)
{
    return *std::ranges::find_if(t, [&](VertexIndex v) { return v != a && v != b; });
}

/// The vertices that a turn around v meets, from one neighbour on until another or a hole; first those on the
/// left of the edge from v to `first`, or on the right.
std::vector<VertexIndex> fan(const SurfaceGraph& graph, VertexIndex v, VertexIndex first, VertexIndex last,
                             bool isLeft)
{
    std::vector<VertexIndex> found;
    for (VertexIndex spoke = first; found.size() <= graph.trianglesOf(v).size();) {
        const auto around = graph.trianglesOf(v);
        const auto next = std::ranges::find_if(around, [&](std::uint32_t t) {
            const Triangle& triangle = graph.topology().triangles()[t];
            return isLeft ? hasDirectedEdge(triangle, v, spoke) : hasDirectedEdge(triangle, spoke, v);
        });
        if (next == around.end())
            break;
        spoke = thirdCorner(graph.topology().triangles()[*next], v, spoke);
        if (spoke == last)
            break;
        found.push_back(spoke);
    }
    return found;
}

} // namespace

CrossCut::CrossCut(const SurfaceGraph& graph, std::vector<VertexIndex> path)
    : m_path(std::move(path)), m_isNear(graph.vertexCount())
{
    for (std::size_t i = 1; i + 1 < m_path.size(); ++i) {
        const VertexIndex v = m_path[i];
        for (const VertexIndex w : fan(graph, v, m_path[i + 1], m_path[i - 1], true))
            m_ups.push_back({v, w});
        // The rest, where a hole interrupts the turn.
        for (const VertexIndex w : fan(graph, v, m_path[i - 1], m_path[i + 1], false))
            m_ups.push_back({v, w});
    }
    std::ranges::sort(m_ups);
    m_ups.erase(std::unique(m_ups.begin(), m_ups.end()), m_ups.end());
    for (const auto& up : m_ups)
        m_isNear[up[0].value] = m_isNear[up[1].value] = true;
}

int CrossCut::lookUp(VertexIndex from, VertexIndex to) const
{
    const bool up = std::ranges::binary_search(m_ups, std::array{from, to});
    const bool down = std::ranges::binary_search(m_ups, std::array{to, from});
    return static_cast<int>(up) - static_cast<int>(down);
}

int CrossCut::climbOf(std::span<const VertexIndex> curve) const
{
    int climb = 0;
    for (std::size_t i = 0; i < curve.size(); ++i)
        climb += crossing(curve[i], curve[(i + 1) % curve.size()]);
    return climb;
}

std::vector<VertexIndex> fewestEdges(const SurfaceGraph& graph, VertexIndex from, VertexIndex to)
{
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> next(graph.vertexCount(), none);
    std::vector<std::uint32_t> reached{to.value};
    next[to.value] = to.value;
    for (std::size_t i = 0; i < reached.size() && next[from.value] == none; ++i) {
        for (const SurfaceGraph::Edge& edge : graph.edgesOf(VertexIndex(reached[i]))) {
            if (next[edge.to] == none) {
                next[edge.to] = reached[i];
                reached.push_back(edge.to);
            }
        }
    }
    if (next[from.value] == none)
        return {};
    std::vector<VertexIndex> path{from};
    while (path.back() != to)
        path.emplace_back(next[path.back().value]);
    return path;
}

} // namespace quadrille
