// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/partoverlap.h"

#include "model/geometry/poseframes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

namespace quadrille {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Cost of a metre of seam where both instances are alike: a gradient that differs by 1 % costs as much.
constexpr double costOfLength = 1e-4;
/// Seams at a rim cost as many times more than in the middle.
constexpr double costOfRims = 10;

std::vector<std::uint32_t> placesIn(const std::vector<VertexIndex>& sorted,
                                    const std::vector<VertexIndex>& vertices)
{
    std::vector<std::uint32_t> places;
    for (const VertexIndex v : vertices) {
        const auto place = std::ranges::lower_bound(sorted, v);
        if (place != sorted.end() && *place == v)
            places.push_back(static_cast<std::uint32_t>(place - sorted.begin()));
    }
    return places;
}

std::vector<bool> marked(std::size_t count, std::span<const std::uint32_t> places)
{
    std::vector<bool> marks(count, false);
    for (const std::uint32_t place : places)
        marks[place] = true;
    return marks;
}

} // namespace

PartOverlap::PartOverlap(const Topology& topology, const BodyPart& part, Positions pose)
    : m_vertexCount(part.overlap.size()), m_end(placesIn(part.overlap, part.end))
{
    std::vector<Vec3f> places;
    for (const VertexIndex v : part.overlap)
        places.push_back(pose[v.value]);
    for (const TriangleIndex t : part.overlapTriangles) {
        const Triangle& triangle = topology.triangles()[t.value];
        const std::vector<std::uint32_t> corners =
            placesIn(part.overlap, {triangle[0], triangle[1], triangle[2]});
        m_triangles.push_back({VertexIndex(corners[0]), VertexIndex(corners[1]), VertexIndex(corners[2])});
    }
    const std::vector<std::uint32_t> parentEnd = placesIn(part.overlap, part.parentEnd);
    linkEdges(places, marked(m_vertexCount, m_end), marked(m_vertexCount, parentEnd));
    m_toEnd = distancesFrom(m_end);
    m_toParentEnd = distancesFrom(parentEnd);
    weighEdges();
    weighTriangles(places);
    cutAcross();
}

void PartOverlap::linkEdges(Positions places, const std::vector<bool>& isEnd,
                            const std::vector<bool>& isParentEnd)
{
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> known;
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
        std::array<std::uint32_t, 3> edges{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto [low, high] =
                std::minmax(m_triangles[t][(corner + 1) % 3].value, m_triangles[t][(corner + 2) % 3].value);
            const auto [place, isNew] =
                known.try_emplace({low, high}, static_cast<std::uint32_t>(m_edges.size()));
            if (isNew) {
                m_edges.push_back({.ends = {low, high}});
                m_lengths.push_back(static_cast<double>((places[low] - places[high]).norm()));
                m_edgeTriangles.emplace_back();
            }
            edges[corner] = place->second;
            std::vector<std::uint32_t>& around = m_edgeTriangles[place->second];
            if (around.empty() || around.back() != t)
                around.push_back(t);
        }
        m_triangleEdges.push_back(edges);
    }
    std::vector<std::vector<Neighbour>> neighbours(m_vertexCount);
    for (std::uint32_t e = 0; e < m_edges.size(); ++e) {
        Edge& edge = m_edges[e];
        const auto [a, b] = edge.ends;
        const bool isRim = m_edgeTriangles[e].size() == 1;
        edge.isEnd = isRim && isEnd[a] && isEnd[b];
        edge.isParentEnd = isRim && isParentEnd[a] && isParentEnd[b];
        if (a != b) {
            neighbours[a].push_back({b, e});
            neighbours[b].push_back({a, e});
        }
    }
    m_neighbourStarts.push_back(0);
    for (const std::vector<Neighbour>& own : neighbours) {
        m_neighbours.insert(m_neighbours.end(), own.begin(), own.end());
        m_neighbourStarts.push_back(static_cast<std::uint32_t>(m_neighbours.size()));
    }
}

void PartOverlap::weighEdges()
{
    double rims = 0;
    double all = 0;
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        rims += (m_edges[e].isEnd ? m_lengths[e] : 0) + (m_edges[e].isParentEnd ? m_lengths[e] : 0);
        all += m_lengths[e];
    }
    m_radius = rims > 0 ? rims / (4 * std::numbers::pi) : all > 0 ? all : 1.0;
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        const auto [a, b] = m_edges[e].ends;
        const double toEnd = m_toEnd[a] + m_toEnd[b];
        const double toParentEnd = m_toParentEnd[a] + m_toParentEnd[b];
        const double across = toEnd + toParentEnd;
        const double share = across > 0 && std::isfinite(across) ? toEnd / across : 0.5;
        const double middle = std::max(4 * share * (1 - share), 1 / costOfRims);
        m_edges[e].weight = std::max(m_lengths[e], 1e-9 * m_radius) / middle;
    }
}

void PartOverlap::weighTriangles(Positions places)
{
    const PoseFrames frames = poseFrames(m_triangles, places);
    m_areas.assign(m_vertexCount, 0.0);
    for (std::size_t m = 0; m < m_triangles.size(); ++m) {
        const bool hasArea = !std::ranges::binary_search(frames.degenerate, static_cast<int>(m));
        for (const VertexIndex v : m_triangles[m])
            m_areas[v.value] += hasArea ? 0.5 * frames.b11[m] * frames.b22[m] : 0;
    }
    if (std::ranges::all_of(m_areas, [](double area) { return area == 0; }))
        std::ranges::fill(m_areas, 1.0);
    for (std::size_t m = 0; m < m_triangles.size(); ++m) {
        const double b11 = frames.b11[m];
        const double b12 = frames.b12[m];
        const double b22 = frames.b22[m];
        const double scale = 1 / (b11 * b22 * b22);
        m_gradientWeights.push_back(
            {(b11 - b12) * scale, (b12 * (b12 - b11) + b22 * b22) / b11 * scale, b12 * scale});
    }
    for (const int m : frames.degenerate)
        m_gradientWeights[static_cast<std::size_t>(m)] = {0, 0, 0};
}

void PartOverlap::cutAcross()
{
    // A row of triangles from rim to rim: a curve goes round the band when it crosses the row's edges an odd
    // number of times.
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> cameOver(m_triangles.size(), none);
    std::vector<std::uint32_t> cameFrom(m_triangles.size(), none);
    std::vector<std::uint32_t> queue;
    for (std::uint32_t e = 0; e < m_edges.size(); ++e) {
        const std::uint32_t t = m_edgeTriangles[e].front();
        if (m_edges[e].isEnd && cameOver[t] == none) {
            cameOver[t] = e;
            queue.push_back(t);
        }
    }
    std::uint32_t last = none;
    std::uint32_t over = none;
    for (std::size_t i = 0; i < queue.size() && last == none; ++i) {
        const std::uint32_t t = queue[i];
        for (const std::uint32_t e : m_triangleEdges[t]) {
            if (m_edges[e].isParentEnd) {
                last = t;
                over = e;
            }
            for (const std::uint32_t next : m_edgeTriangles[e]) {
                if (cameOver[next] == none) {
                    cameOver[next] = e;
                    cameFrom[next] = t;
                    queue.push_back(next);
                }
            }
        }
    }
    if (last == none)
        return;
    std::vector<std::uint32_t> crossed{over};
    for (std::uint32_t t = last; t != none; t = cameFrom[t])
        crossed.push_back(cameOver[t]);
    // Edges that follow each other share a vertex; the other ends lie on the other side.
    std::array<std::uint32_t, 2> sides = m_edges[crossed.front()].ends;
    std::array<std::vector<std::uint32_t>, 2> sideVertices;
    for (const std::uint32_t e : crossed) {
        m_edges[e].isCrossing = true;
        const auto [a, b] = m_edges[e].ends;
        if (sides[0] == a || sides[1] == b)
            sides = {a, b};
        else
            sides = {b, a};
        for (std::size_t side = 0; side < 2; ++side) {
            if (sideVertices[side].empty() || sideVertices[side].back() != sides[side])
                sideVertices[side].push_back(sides[side]);
        }
    }
    m_sources = sideVertices[0].size() <= sideVertices[1].size() ? sideVertices[0] : sideVertices[1];
}

std::span<const PartOverlap::Neighbour> PartOverlap::neighboursOf(std::uint32_t vertex) const
{
    return std::span(m_neighbours)
        .subspan(m_neighbourStarts[vertex], m_neighbourStarts[vertex + 1] - m_neighbourStarts[vertex]);
}

std::vector<double> PartOverlap::distancesFrom(std::span<const std::uint32_t> vertices) const
{
    std::vector<double> distances(m_vertexCount, infinity);
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (const std::uint32_t v : vertices) {
        distances[v] = 0;
        queue.emplace(0.0, v);
    }
    while (!queue.empty()) {
        const auto [distance, v] = queue.top();
        queue.pop();
        if (distance > distances[v])
            continue;
        for (const Neighbour& next : neighboursOf(v)) {
            const double further = distance + m_lengths[next.edge];
            if (further < distances[next.vertex]) {
                distances[next.vertex] = further;
                queue.emplace(further, next.vertex);
            }
        }
    }
    return distances;
}

void PartOverlap::addCosts(std::span<const Vec3d> differences, std::span<double> costs) const
{
    std::vector<double> gradients(m_triangles.size());
    for (std::size_t t = 0; t < gradients.size(); ++t) {
        const auto& [v1, v2, v3] = m_triangles[t];
        const auto& [w1, w2, w3] = m_gradientWeights[t];
        gradients[t] = w1 * (differences[v2.value] - differences[v3.value]).squaredNorm() +
                       w2 * (differences[v3.value] - differences[v1.value]).squaredNorm() +
                       w3 * (differences[v1.value] - differences[v2.value]).squaredNorm();
    }
    const double perRadius = 0.5 / (m_radius * m_radius);
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        const auto [a, b] = m_edges[e].ends;
        double gradient = 0;
        for (const std::uint32_t t : m_edgeTriangles[e])
            gradient += gradients[t];
        gradient /= static_cast<double>(m_edgeTriangles[e].size());
        const double place = perRadius * (differences[a].squaredNorm() + differences[b].squaredNorm());
        costs[e] += m_edges[e].weight * (costOfLength + place + gradient);
    }
}

PartOverlap::Sides PartOverlap::sidesOf(std::span<const std::uint32_t> seam) const
{
    Sides sides{std::vector<bool>(m_edges.size(), false), std::vector<bool>(m_triangles.size(), false)};
    for (std::size_t i = 0; i < seam.size(); ++i) {
        const std::uint32_t next = seam[(i + 1) % seam.size()];
        for (const Neighbour& neighbour : neighboursOf(seam[i])) {
            if (neighbour.vertex == next)
                sides.isSeam[neighbour.edge] = true;
        }
    }
    std::vector<std::uint32_t> queue;
    const auto cross = [&](std::uint32_t edge) {
        if (sides.isSeam[edge])
            return;
        for (const std::uint32_t t : m_edgeTriangles[edge]) {
            if (!sides.isParents[t]) {
                sides.isParents[t] = true;
                queue.push_back(t);
            }
        }
    };
    for (std::uint32_t e = 0; e < m_edges.size(); ++e) {
        if (m_edges[e].isEnd)
            cross(e);
    }
    while (!queue.empty()) {
        const std::uint32_t t = queue.back();
        queue.pop_back();
        for (const std::uint32_t e : m_triangleEdges[t])
            cross(e);
    }
    return sides;
}

std::vector<double> PartOverlap::shares(std::span<const std::uint32_t> seam) const
{
    const std::vector<bool> isParents = sidesOf(seam).isParents;
    const std::vector<double> toSeam = distancesFrom(seam);
    // Vertices of the seam belong to both sides.
    std::vector<bool> isAtParents(m_vertexCount, false);
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
        for (const VertexIndex v : m_triangles[t]) {
            if (isParents[t])
                isAtParents[v.value] = true;
        }
    }
    const auto shareOf = [&](std::uint32_t v) {
        const double toRim = isAtParents[v] ? m_toEnd[v] : m_toParentEnd[v];
        const double across = toRim + toSeam[v];
        double part = 0; // of the way from the rim to the seam
        if (std::isfinite(across) && across > 0)
            part = toRim / across;
        else if (std::isfinite(toRim))
            part = 1;
        return isAtParents[v] ? 0.5 * part : 1 - 0.5 * part;
    };
    std::vector<double> shares;
    for (const Triangle& triangle : m_triangles)
        shares.push_back(
            (shareOf(triangle[0].value) + shareOf(triangle[1].value) + shareOf(triangle[2].value)) / 3);
    return shares;
}

} // namespace quadrille
