// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/walkgraph.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

namespace quadrille {

namespace {

std::string toString(const FramePair& pair)
{
    return "from frame " + std::to_string(pair.source) + " to frame " + std::to_string(pair.destination);
}

WalkMove moveOf(const Edge& edge, const TransitionCosts& costs, const MoveCharges& charges)
{
    WalkMove move{.from = edge.from, .to = edge.to, .weight = edge.weight, .kind = edge.kind};
    const auto from = static_cast<std::size_t>(edge.from);
    const auto to = static_cast<std::size_t>(edge.to);
    if (edge.kind == EdgeKind::Original) {
        if (!charges.frames.empty())
            move.weight = charges.frames[from];
        return move;
    }
    move.elapsed = std::max(1, static_cast<int>(costs.length()(edge.from, edge.to)) - 1);
    if (!charges.inAir.empty() && charges.inAir[from] != charges.inAir[to])
        move.weight += charges.flight;
    if (!charges.paces.empty())
        move.weight += charges.pace * std::abs(charges.paces[from] - charges.paces[to]);
    return move;
}

bool exists(const FramePair& pair, const TransitionCosts& costs)
{
    const NodeIndex count = costs.layout().frameCount();
    const auto isFrame = [count](NodeIndex node) { return node >= 0 && node < count; };
    return isFrame(pair.source) && isFrame(pair.destination) &&
           costs.hasTransition(pair.source, pair.destination);
}

/// Positions in `order` at which each node's moves begin, and the end.
template <typename NodeOf>
std::vector<MoveIndex> firstPositions(NodeIndex nodes, std::size_t count, const NodeOf& nodeOf)
{
    std::vector<MoveIndex> first(static_cast<std::size_t>(nodes) + 1, 0);
    for (std::size_t i = 0; i < count; ++i)
        ++first[static_cast<std::size_t>(nodeOf(i)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

} // namespace

WalkGraph::WalkGraph(const Digraph& graph, const TransitionCosts& costs, double alpha,
                     const Junctions& junctions, const MoveCharges& charges)
    : m_layout(costs.layout()), m_alpha(alpha)
{
    requireAlpha(alpha);
    const auto isBanned = [&](const FramePair& pair) {
        return std::find(junctions.banned.begin(), junctions.banned.end(), pair) != junctions.banned.end();
    };
    for (const Edge& edge : graph.edges()) {
        if (edge.kind == EdgeKind::Transition && isBanned({edge.from, edge.to}))
            continue;
        m_moves.push_back(moveOf(edge, costs, charges));
    }
    for (std::size_t r = 0; r < junctions.required.size(); ++r) {
        const FramePair& pair = junctions.required[r];
        if (!exists(pair, costs))
            refuse("There is no transition " + toString(pair) + ", which is required",
                   "Choose another junction.");
        if (isBanned(pair))
            refuse("The transition " + toString(pair) + " is both required and banned",
                   "Decide for one of them.");
        auto found = std::find_if(m_moves.begin(), m_moves.end(), [&](const WalkMove& move) {
            return move.from == pair.source && move.to == pair.destination &&
                   move.kind == EdgeKind::Transition;
        });
        if (found == m_moves.end()) {
            const Edge edge{pair.source, pair.destination, costs.weight(pair.source, pair.destination, alpha),
                            EdgeKind::Transition};
            found = m_moves.insert(m_moves.end(), moveOf(edge, costs, charges));
        }
        found->required = static_cast<std::int32_t>(r);
    }
    std::sort(m_moves.begin(), m_moves.end(), [](const WalkMove& a, const WalkMove& b) {
        return std::tie(a.from, a.weight, a.to, a.kind) < std::tie(b.from, b.weight, b.to, b.kind);
    });
    const NodeIndex nodes = m_layout.frameCount();
    m_hasRequired = !junctions.required.empty();
    m_playedOn.assign(static_cast<std::size_t>(nodes), noMove);
    for (std::size_t i = 0; i < m_moves.size(); ++i) {
        if (m_moves[i].kind == EdgeKind::Original)
            m_playedOn[static_cast<std::size_t>(m_moves[i].from)] = static_cast<MoveIndex>(i);
    }
    m_firstOf = firstPositions(nodes, m_moves.size(), [this](std::size_t i) { return m_moves[i].from; });
    m_firstInto = firstPositions(nodes, m_moves.size(), [this](std::size_t i) { return m_moves[i].to; });
    m_into.resize(m_moves.size());
    std::iota(m_into.begin(), m_into.end(), 0);
    std::stable_sort(m_into.begin(), m_into.end(),
                     [this](MoveIndex a, MoveIndex b) { return move(a).to < move(b).to; });
    m_leastWeightPerFrame = m_moves.empty() ? 0 : unreachable;
    for (const WalkMove& move : m_moves)
        m_leastWeightPerFrame = std::min(m_leastWeightPerFrame, move.weight / move.elapsed);
}

std::pair<MoveIndex, MoveIndex> WalkGraph::from(NodeIndex node) const
{
    const auto n = static_cast<std::size_t>(node);
    return {m_firstOf[n], m_firstOf[n + 1]};
}

MoveIndex WalkGraph::transition(const FramePair& pair) const
{
    const auto [begin, end] = from(pair.source);
    for (MoveIndex index = begin; index < end; ++index) {
        if (move(index).to == pair.destination && move(index).kind == EdgeKind::Transition)
            return index;
    }
    return noMove;
}

WalkGraph::Ways WalkGraph::waysTo(std::vector<double> goal, double perFrame) const
{
    Ways ways{.costs = std::move(goal), .moves = std::vector<MoveIndex>(m_firstOf.size() - 1, noMove)};
    using Entry = std::pair<double, NodeIndex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (NodeIndex node = 0; node < nodeCount(); ++node) {
        if (ways.costs[static_cast<std::size_t>(node)] < unreachable)
            open.emplace(ways.costs[static_cast<std::size_t>(node)], node);
    }
    while (!open.empty()) {
        const auto [cost, node] = open.top();
        open.pop();
        const auto n = static_cast<std::size_t>(node);
        if (cost > ways.costs[n])
            continue;
        for (MoveIndex i = m_firstInto[n]; i < m_firstInto[n + 1]; ++i) {
            const MoveIndex index = m_into[static_cast<std::size_t>(i)];
            const WalkMove& way = move(index);
            const auto source = static_cast<std::size_t>(way.from);
            // A sum that rounding leaves below zero is zero.
            const double longer = cost + std::max(0.0, way.weight + perFrame * way.elapsed);
            if (longer < ways.costs[source]) {
                ways.costs[source] = longer;
                ways.moves[source] = index;
                open.emplace(longer, way.from);
            }
        }
    }
    return ways;
}

WalkGraph::Ways WalkGraph::waysTo(NodeIndex goal, double perFrame) const
{
    std::vector<double> costs(m_firstOf.size() - 1, unreachable);
    costs[static_cast<std::size_t>(goal)] = 0;
    return waysTo(std::move(costs), perFrame);
}

WalkRoute WalkGraph::route(const Ways& ways, NodeIndex from) const
{
    WalkRoute route{.start = from, .moves = {}};
    for (NodeIndex node = from; ways.moves[static_cast<std::size_t>(node)] != noMove;
         node = move(route.moves.back()).to)
        route.moves.push_back(ways.moves[static_cast<std::size_t>(node)]);
    return route;
}

Walk WalkGraph::walk(const WalkRoute& route) const
{
    Walk walk{.spans = {{route.start, route.start}}};
    for (const MoveIndex index : route.moves) {
        const WalkMove& next = move(index);
        if (next.kind == EdgeKind::Original)
            walk.spans.back().last = next.to;
        else
            walk.spans.push_back({next.to, next.to});
    }
    return walk;
}

} // namespace quadrille
