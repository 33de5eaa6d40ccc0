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

constexpr float infinite = std::numeric_limits<float>::infinity();

/// What an edge costs, in its length: more, the farther it lies from where the way should be; beyond four
/// times its own length it makes no difference any more, so that detours around obstacles stay short.
float costOf(const SurfaceGraph::Edge& edge, float deviation, float creases)
{
    constexpr float stiffness = 4;
    constexpr float farthest = 16;
    const float ratio =
        edge.length > 0 ? std::min(deviation / (edge.length * edge.length), farthest) : farthest;
    return edge.length * (1 + stiffness * ratio) * (1 - creases * edge.crease);
}

class Search
{
public:
    Search(const OpenedSurface& surface, const std::function<float(std::size_t)>& deviation,
           const RouteRules& rules)
        : m_surface(surface)
        , m_deviation(deviation)
        , m_rules(rules)
        , m_costs(surface.places(), infinite)
        , m_before(surface.places())
    {
    }

    std::optional<std::vector<VertexIndex>> route(SheetVertex from, SheetVertex to)
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
        return std::nullopt;
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

    /// Nothing where it meets itself.
    std::optional<std::vector<VertexIndex>> traced(SheetVertex from) const
    {
        std::vector<VertexIndex> way;
        std::unordered_set<VertexIndex> seen;
        for (SheetVertex v = m_to; v != from; v = m_before[m_surface.place(v)]) {
            if (!seen.insert(v.vertex).second)
                return std::nullopt;
            way.push_back(v.vertex);
        }
        // A loop ends where it began.
        if (from.vertex != m_to.vertex && seen.contains(from.vertex))
            return std::nullopt;
        way.push_back(from.vertex);
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

} // namespace

std::optional<std::vector<VertexIndex>> routeNear(const OpenedSurface& surface, SheetVertex from,
                                                  SheetVertex to,
                                                  const std::function<float(std::size_t)>& deviation,
                                                  const RouteRules& rules)
{
    return Search(surface, deviation, rules).route(from, to);
}

std::optional<std::vector<VertexIndex>> shortestRoute(const OpenedSurface& surface, SurfaceDistances& forward,
                                                      SheetVertex from, SheetVertex to,
                                                      const RouteRules& rules)
{
    const float length = forward.growUntil(to, infinite);
    SurfaceDistances backward(surface);
    backward.add(to, 0);
    backward.growUntil(from, infinite);
    if (!(length < infinite))
        return std::nullopt;
    // Beside the shortest way the distances from both ends sum to more than its length: to what a triangle
    // of this height would have.
    const auto deviation = [&](std::size_t place) {
        const float from0 = forward.at(place);
        const float excess = from0 + backward.at(place) - length;
        if (!(excess < infinite))
            return infinite;
        if (excess <= 0 || length <= 0)
            return 0.0F;
        return 2 * excess * std::max(from0 * (length - from0) / length, excess / 2);
    };
    return routeNear(surface, from, to, deviation, rules);
}

} // namespace quadrille
