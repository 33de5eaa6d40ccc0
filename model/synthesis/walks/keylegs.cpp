// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/keylegs.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace quadrille {

LegBounds::LegBounds(const WalkGraph& graph, NodeIndex target, double beta) : m_target(target)
{
    // Weights must not become negative; more values of θ make the bounds tighter, and cost a search each.
    const double most = std::min(beta, graph.leastWeightPerFrame());
    std::vector<double> thetas{-most, -most / 2, 0, beta / 2, beta};
    thetas.erase(std::unique(thetas.begin(), thetas.end()), thetas.end());
    for (const double theta : thetas)
        m_all.push_back({theta, graph.waysTo(target, theta)});
}

double LegBounds::operator()(NodeIndex node, double time) const
{
    double best = 0;
    for (const Weighted& weighted : m_all)
        best = std::max(best, weighted.ways.costs[static_cast<std::size_t>(node)] - weighted.theta * time);
    return best;
}

double LegBounds::ofSign(bool isNegative, NodeIndex node, double time) const
{
    double best = -unreachable;
    for (const Weighted& weighted : m_all) {
        if (isNegative ? weighted.theta <= 0 : weighted.theta >= 0)
            best =
                std::max(best, weighted.ways.costs[static_cast<std::size_t>(node)] - weighted.theta * time);
    }
    return best;
}

LegSearch::LegSearch(const WalkGraph& graph, std::vector<NodeIndex> sources, NodeIndex target)
    : m_graph(graph), m_sources(std::move(sources)), m_target(target)
{
}

LegSearch::Layer& LegSearch::layer(std::int32_t elapsed)
{
    Layer& layer = m_layers[elapsed];
    if (layer.costs.empty()) {
        layer.costs.assign(static_cast<std::size_t>(m_graph.nodeCount()), unreachable);
        layer.moves.assign(static_cast<std::size_t>(m_graph.nodeCount()), noMove);
    }
    return layer;
}

void LegSearch::expand(NodeIndex node, std::int32_t elapsed, double cost)
{
    // Layers that lie next to each other are looked up once.
    constexpr std::size_t near = 128;
    std::array<Layer*, near> known{};
    const auto [begin, end] = m_graph.from(node);
    for (MoveIndex index = begin; index < end; ++index) {
        const WalkMove& move = m_graph.move(index);
        const auto e = static_cast<std::size_t>(move.elapsed);
        Layer* there = e < near ? known[e] : nullptr;
        if (!there) {
            there = &layer(elapsed + move.elapsed);
            if (e < near)
                known[e] = there;
        }
        const auto to = static_cast<std::size_t>(move.to);
        if (cost + move.weight < there->costs[to]) {
            there->costs[to] = cost + move.weight;
            there->moves[to] = index;
        }
    }
}

WalkRoute LegSearch::route(std::int32_t elapsed) const
{
    WalkRoute route{.start = m_target, .moves = {}};
    while (true) {
        const auto found = m_layers.find(elapsed);
        assert(found != m_layers.end());
        const MoveIndex index = found->second.moves[static_cast<std::size_t>(route.start)];
        if (index == noMove)
            break;
        route.moves.push_back(index);
        route.start = m_graph.move(index).from;
        elapsed -= m_graph.move(index).elapsed;
    }
    std::reverse(route.moves.begin(), route.moves.end());
    return route;
}

} // namespace quadrille
