// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfaceroute.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_set>

namespace quadrille {

namespace {

/// What an edge costs, in its length: more, the farther it lies from where the way should be; beyond four
/// times its own length it makes no difference any more, so that detours around obstacles stay short.
float costOf(const SurfaceGraph::Edge& edge, float deviation, float creases)
{
    constexpr float stiffness = 0.5F;
    constexpr float farthest = 16;
    const float ratio =
        edge.length > 0 ? std::min(deviation / (edge.length * edge.length), farthest) : farthest;
    return edge.length * (1 + stiffness * ratio) * (1 - creases * edge.crease);
}

using Way = std::vector<SheetVertex>;

class Search
{
public:
    Search(const OpenedSurface& surface, const std::function<float(std::size_t)>& deviation,
           const RouteRules& rules)
        : m_surface(surface)
        , m_deviation(deviation)
        , m_rules(rules)
        , m_costs(surface.places(), noWay)
        , m_before(surface.places())
    {
    }

    /// Empty where there is none.
    Way route(SheetVertex from, SheetVertex to)
    {
        m_to = to;
        m_costs[m_surface.place(from)] = 0;
        m_queue.push({0, from});
        while (!m_queue.empty()) {
            const Waiting nearest = m_queue.top();
            m_queue.pop();
            if (nearest.vertex == to)
                return traced(from);
            if (nearest.cost <= m_costs[m_surface.place(nearest.vertex)])
                spread(nearest.vertex);
        }
        return {};
    }

private:
    struct Waiting
    {
        float cost;
        SheetVertex vertex;
        bool operator<(const Waiting& other) const { return cost > other.cost; }
    };

    void spread(SheetVertex from)
    {
        const std::size_t here = m_surface.place(from);
        const float deviationHere = m_deviation(here);
        for (const SurfaceGraph::Edge& edge : m_surface.graph->edgesOf(from.vertex)) {
            const auto to = m_surface.step(from, VertexIndex(edge.to));
            if (!to || (*to != m_to && m_rules.blocked && (*m_rules.blocked)[edge.to]))
                continue;
            const std::size_t there = m_surface.place(*to);
            const float cost =
                m_costs[here] + costOf(edge, (deviationHere + m_deviation(there)) / 2,
                                       static_cast<float>(std::clamp(m_rules.creases, 0.0, 0.95)));
            if (cost < m_costs[there]) {
                m_costs[there] = cost;
                m_before[there] = from;
                m_queue.push({cost, *to});
            }
        }
    }

    Way traced(SheetVertex from) const
    {
        Way way{m_to};
        while (way.back() != from)
            way.push_back(m_before[m_surface.place(way.back())]);
        std::ranges::reverse(way);
        return way;
    }

    const OpenedSurface& m_surface;
    const std::function<float(std::size_t)>& m_deviation;
    const RouteRules& m_rules;
    SheetVertex m_to;
    std::vector<float> m_costs;
    std::vector<SheetVertex> m_before;
    std::priority_queue<Waiting> m_queue;
};

/// Whether some vertex is passed twice; a loop ends where it began.
bool meetsItself(const Way& way)
{
    std::unordered_set<VertexIndex> seen;
    for (std::size_t i = 1; i < way.size(); ++i) {
        if (!seen.insert(way[i].vertex).second)
            return true;
    }
    return way.front().vertex != way.back().vertex && seen.contains(way.front().vertex);
}

std::vector<VertexIndex> verticesOf(const Way& way)
{
    std::vector<VertexIndex> vertices;
    for (const SheetVertex& v : way)
        vertices.push_back(v.vertex);
    return vertices;
}

} // namespace

std::optional<std::vector<VertexIndex>> routeNear(const OpenedSurface& surface, SheetVertex from,
                                                  SheetVertex to,
                                                  const std::function<float(std::size_t)>& deviation,
                                                  const RouteRules& rules)
{
    Way way = Search(surface, deviation, rules).route(from, to);
    if (way.empty())
        return std::nullopt;
    if (!meetsItself(way))
        return verticesOf(way);
    // Two sheets of one place were used: the second half has to go around the first.
    way.resize(way.size() / 2 + 1);
    while (way.size() > 1 && meetsItself(way))
        way.pop_back();
    if (way.size() < 2)
        return std::nullopt;
    std::vector<bool> blocked =
        rules.blocked ? *rules.blocked : std::vector<bool>(surface.graph->vertexCount());
    for (const SheetVertex& v : way)
        blocked[v.vertex.value] = true;
    const RouteRules around{.blocked = &blocked, .creases = rules.creases};
    const Way rest = Search(surface, deviation, around).route(way.back(), to);
    if (rest.empty() || meetsItself(rest))
        return std::nullopt;
    way.insert(way.end(), rest.begin() + 1, rest.end());
    return verticesOf(way);
}

std::optional<std::vector<VertexIndex>> shortestRoute(const OpenedSurface& surface, SurfaceDistances& forward,
                                                      SheetVertex from, SheetVertex to,
                                                      const RouteRules& rules)
{
    const float length = forward.growUntil(to, noWay);
    SurfaceDistances backward(surface);
    backward.add(to, 0);
    backward.growUntil(from, noWay);
    if (!(length < noWay))
        return std::nullopt;
    // Beside the shortest way the distances from both ends sum to more than its length: to what a triangle
    // of this height would have.
    const auto deviation = [&](std::size_t place) {
        const float from0 = forward.at(place);
        const float excess = from0 + backward.at(place) - length;
        if (!(excess < noWay))
            return noWay;
        if (excess <= 0 || length <= 0)
            return 0.0F;
        return 2 * excess * std::max(from0 * (length - from0) / length, excess / 2);
    };
    return routeNear(surface, from, to, deviation, rules);
}

} // namespace quadrille
