// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/looparound.h"

#include "model/geometry/surfacedistances.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::uint32_t none = ~0U;

class FrontLoop
{
public:
    FrontLoop(const SurfaceGraph& graph, VertexIndex through)
        : m_graph(graph)
        , m_through(through)
        , m_distances(graph)
        , m_reached(graph.vertexCount())
        , m_worth(graph)
    {
        m_distances.add({through, 0}, 0);
    }

    std::optional<std::vector<VertexIndex>> find()
    {
        while (const auto reached = m_distances.next()) {
            const VertexIndex v = reached->vertex;
            if (m_reached[v.value])
                continue;
            m_reached[v.value] = true;
            if (auto loop = loopClosedAt(v))
                return loop;
        }
        return std::nullopt;
    }

private:
    /// The nearest vertex of each run of neighbours that the front has reached already.
    std::vector<VertexIndex> arrivalsAt(VertexIndex v) const
    {
        std::vector<VertexIndex> ring;
        for (const SurfaceGraph::Edge& edge : m_graph.edgesOf(v)) {
            if (m_reached[edge.to])
                ring.emplace_back(edge.to);
        }
        std::vector<std::size_t> run(ring.size());
        for (std::size_t i = 0; i < run.size(); ++i)
            run[i] = i;
        for (const std::uint32_t t : m_graph.trianglesOf(v)) {
            std::vector<std::size_t> joined;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                if (hasCorner(m_graph.topology().triangles()[t], ring[i]))
                    joined.push_back(i);
            }
            if (joined.size() == 2)
                std::ranges::replace(run, run[joined[0]], run[joined[1]]);
        }
        std::vector<VertexIndex> nearest;
        for (std::size_t r = 0; r < ring.size(); ++r) {
            std::optional<VertexIndex> best;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                if (run[i] == r && (!best || distance(ring[i]) < distance(*best)))
                    best = ring[i];
            }
            if (best)
                nearest.push_back(*best);
        }
        return nearest;
    }

    float distance(VertexIndex v) const { return m_distances.at({v, 0}); }

    std::vector<VertexIndex> wayBack(VertexIndex from) const
    {
        std::vector<VertexIndex> way{from};
        while (way.back() != m_through && way.size() <= m_graph.vertexCount())
            way.push_back(m_distances.before({way.back(), 0}));
        return way;
    }

    std::optional<std::vector<VertexIndex>> loopClosedAt(VertexIndex v)
    {
        const std::vector<VertexIndex> arrivals = arrivalsAt(v);
        for (std::size_t i = 0; i < arrivals.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                auto loop = joined(wayBack(arrivals[j]), v, wayBack(arrivals[i]));
                if (loop.size() >= 3 && m_worth.surroundsSomething(loop, 2 * distance(v)))
                    return loop;
            }
        }
        return std::nullopt;
    }

    /// Both ways up to where they meet; empty where they meet far from the start.
    std::vector<VertexIndex> joined(const std::vector<VertexIndex>& one, VertexIndex at,
                                    const std::vector<VertexIndex>& other) const
    {
        constexpr float farthestMeeting = 0.15F;
        std::size_t common = 0;
        while (common + 1 < std::min(one.size(), other.size()) &&
               one[one.size() - 2 - common] == other[other.size() - 2 - common])
            ++common;
        const VertexIndex meeting = one[one.size() - 1 - common];
        if (distance(meeting) > farthestMeeting * distance(at))
            return {};
        std::vector<VertexIndex> loop(one.rbegin() + static_cast<std::ptrdiff_t>(common), one.rend());
        loop.push_back(at);
        loop.insert(loop.end(), other.begin(), other.end() - static_cast<std::ptrdiff_t>(common + 1));
        return loop;
    }

    const SurfaceGraph& m_graph;
    VertexIndex m_through;
    SurfaceDistances m_distances;
    std::vector<bool> m_reached;
    CurveWorth m_worth;
};

} // namespace

CurveWorth::CurveWorth(const SurfaceGraph& graph)
    : m_graph(graph), m_next(graph.vertexCount(), none), m_visit(graph.topology().triangles().size())
{
}

bool CurveWorth::surroundsSomething(std::span<const VertexIndex> curve, float length)
{
    if (!isOpen(curve, length))
        return false;
    for (std::size_t i = 0; i < curve.size(); ++i)
        m_next[curve[i].value] = curve[(i + 1) % curve.size()].value;
    // A half ball has length² / 2π = 0.16 length².
    const float least = 0.13F * length * length;
    const bool isBetweenLarge = isLarge(curve, true, least) && isLarge(curve, false, least);
    for (const VertexIndex v : curve)
        m_next[v.value] = none;
    return isBetweenLarge && curveSides(m_graph.topology(), m_graph.around(), curve);
}

/// Seen from its best side, at least a third as large as a circle.
bool CurveWorth::isOpen(std::span<const VertexIndex> curve, float length) const
{
    Vec3f area = Vec3f::Zero();
    const Vec3f& first = m_graph.pose()[curve[0].value];
    for (std::size_t i = 1; i + 1 < curve.size(); ++i)
        area +=
            (m_graph.pose()[curve[i].value] - first).cross(m_graph.pose()[curve[i + 1].value] - first) / 2;
    return area.norm() > 0.027F * length * length;
}

/// Whether the surface on one side has some area; looks no farther than that.
bool CurveWorth::isLarge(std::span<const VertexIndex> curve, bool isLeft, float area)
{
    ++m_look;
    std::vector<std::uint32_t> left;
    const auto visit = [&](std::uint32_t t) {
        if (std::exchange(m_visit[t], m_look) != m_look)
            left.push_back(t);
    };
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const VertexIndex from = curve[isLeft ? i : (i + 1) % curve.size()];
        const VertexIndex to = curve[isLeft ? (i + 1) % curve.size() : i];
        for (const std::uint32_t t : m_graph.trianglesOf(from)) {
            if (hasDirectedEdge(m_graph.topology().triangles()[t], from, to))
                visit(t);
        }
    }
    while (!left.empty() && area > 0) {
        const std::uint32_t here = left.back();
        left.pop_back();
        area -= m_graph.area(TriangleIndex(here));
        const Triangle& t = m_graph.topology().triangles()[here];
        for (std::size_t c = 0; c < 3; ++c) {
            const VertexIndex a = t[c];
            const VertexIndex b = t[(c + 1) % 3];
            if (m_next[a.value] == b.value || m_next[b.value] == a.value)
                continue;
            m_graph.around().forEachBeside(here, c, visit);
        }
    }
    return area <= 0;
}

std::optional<std::vector<VertexIndex>> loopAround(const SurfaceGraph& graph, VertexIndex through)
{
    return FrontLoop(graph, through).find();
}

} // namespace quadrille
