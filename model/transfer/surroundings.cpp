// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/surroundings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// How far what is about a mark reaches at most, of the root of the body's area.
constexpr double reachShare = 0.06;
/// So much of the way to the next mark is about one.
constexpr float ownShare = 0.45F;
/// Instead of a marked triangle, of vertices that are corners of none or of several.
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr std::size_t several = none - 1;

} // namespace

Surroundings::Surroundings(const SurfaceGraph& graph, std::span<const std::size_t> marks, PatchReach reach)
    : m_graph(&graph)
    , m_marks(marks.begin(), marks.end())
    , m_patchReach(reach)
    , m_markedAt(graph.vertexCount(), none)
{
    double area = 0;
    for (std::size_t t = 0; t < graph.topology().triangles().size(); ++t)
        area += static_cast<double>(graph.area(TriangleIndex(t)));
    m_reach = static_cast<float>(reachShare * std::sqrt(area));
    for (std::size_t m = 0; reach == PatchReach::NextMark && m < m_marks.size(); ++m) {
        const std::size_t mark = m_marks[m];
        for (const VertexIndex v : graph.topology().triangles()[mark]) {
            std::size_t& at = m_markedAt[v.value];
            at = at == none || at == mark ? mark : several;
        }
    }
}

Surroundings::Reached Surroundings::grow(std::size_t mark) const
{
    Reached reached{.distances = SurfaceDistances(*m_graph)};
    for (const VertexIndex v : m_graph->topology().triangles()[m_marks[mark]]) {
        reached.distances.add({v, 0}, 0);
        if (m_markedAt[v.value] == several)
            return reached;
    }
    reached.reach = m_reach;
    const float limit = m_patchReach == PatchReach::NextMark ? m_reach / ownShare : m_reach;
    while (const auto next = reached.distances.next()) {
        const float way = reached.distances.at(*next);
        if (way > limit)
            break;
        const std::size_t marked = m_markedAt[next->vertex.value];
        if (marked != none && marked != m_marks[mark]) {
            reached.reach = ownShare * way;
            break;
        }
        const auto at = m_graph->trianglesOf(next->vertex);
        reached.triangles.insert(reached.triangles.end(), at.begin(), at.end());
    }
    std::ranges::sort(reached.triangles);
    reached.triangles.erase(std::unique(reached.triangles.begin(), reached.triangles.end()),
                            reached.triangles.end());
    return reached;
}

std::vector<Surroundings::Near> Surroundings::triangles(std::size_t mark) const
{
    const auto [distances, about, reach] = grow(mark);
    std::vector<Near> near{{m_marks[mark], static_cast<double>(m_graph->area(TriangleIndex(m_marks[mark])))}};
    for (const std::uint32_t t : about) {
        if (t == m_marks[mark])
            continue;
        float way = 0;
        for (const VertexIndex v : m_graph->topology().triangles()[t])
            way += distances.at({v, 0}) / 3;
        const double left = 1 - static_cast<double>((way * way) / (reach * reach));
        const auto area = static_cast<double>(m_graph->area(TriangleIndex(t)));
        if (left > 0 && area > 0)
            near.push_back({t, left * left * area});
    }
    double sum = 0;
    for (const Near& each : near)
        sum += each.weight;
    if (!(sum > 0))
        return {{m_marks[mark], 1}};
    for (Near& each : near)
        each.weight /= sum;
    return near;
}

std::vector<std::uint32_t> Surroundings::vertices(std::size_t mark) const
{
    const Reached reached = grow(mark);
    std::vector<std::uint32_t> held;
    for (const std::uint32_t t : reached.triangles) {
        const Triangle& corners = m_graph->topology().triangles()[t];
        if (!std::ranges::all_of(corners, [&](VertexIndex v) {
                return reached.distances.at({v, 0}) <= reached.reach;
            }))
            continue;
        for (const VertexIndex v : corners) {
            if (m_markedAt[v.value] == none)
                held.push_back(v.value);
        }
    }
    std::ranges::sort(held);
    held.erase(std::unique(held.begin(), held.end()), held.end());
    return held;
}

MarkPatches singleTriangles(std::vector<Triangle> triangles)
{
    MarkPatches patches{.triangles = std::move(triangles), .near = {}};
    for (std::size_t m = 0; m < patches.triangles.size(); ++m)
        patches.near.push_back({{m, 1}});
    return patches;
}

MarkPatches patchesAbout(const PosedSurface& reference, std::span<const TrianglePair> pairs, PatchReach reach)
{
    const SurfaceGraph& graph = reference.graph();
    const std::vector<Triangle>& mesh = reference.mesh().topology->triangles();
    std::vector<std::size_t> ofMesh(graph.topology().triangles().size()); // of each triangle of the surface
    for (std::size_t t = 0; t < mesh.size(); ++t) {
        if (const auto onSurface = reference.onGraph(TriangleIndex(t)))
            ofMesh[*onSurface] = t;
    }
    std::vector<std::size_t> marks;
    for (const TrianglePair& pair : pairs) {
        if (const auto mark = reference.onGraph(pair.onTemplate))
            marks.push_back(*mark);
    }
    const Surroundings surroundings(graph, marks, reach);
    MarkPatches patches;
    std::vector<std::size_t> placeOf(mesh.size(), mesh.size());
    const auto add = [&](std::size_t triangle) {
        if (placeOf[triangle] == mesh.size()) {
            placeOf[triangle] = patches.triangles.size();
            patches.triangles.push_back(mesh[triangle]);
        }
        return placeOf[triangle];
    };
    std::size_t next = 0;
    for (const TrianglePair& pair : pairs) {
        std::vector<Surroundings::Near>& near = patches.near.emplace_back();
        if (!reference.onGraph(pair.onTemplate)) {
            near.push_back({add(pair.onTemplate.value), 1});
            continue;
        }
        for (const Surroundings::Near& each : surroundings.triangles(next))
            near.push_back({add(ofMesh[each.triangle]), each.weight});
        ++next;
    }
    return patches;
}

} // namespace quadrille
