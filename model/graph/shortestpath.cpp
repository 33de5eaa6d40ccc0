// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/shortestpath.h"

#include "model/graph/detours.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace quadrille {
namespace {

/// The last edge of the cheapest path from a node to each that is no farther than `to`; null where unknown.
std::vector<const Edge*> lastEdges(const Digraph& graph, NodeIndex from, NodeIndex to)
{
    const auto nodes = static_cast<std::size_t>(graph.nodeCount());
    std::vector<const Edge*> last(nodes, nullptr);
    std::vector<double> costs(nodes, unreachable);
    using Entry = std::pair<double, NodeIndex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    costs[static_cast<std::size_t>(from)] = 0;
    open.emplace(0, from);
    while (!open.empty()) {
        const auto [cost, node] = open.top();
        open.pop();
        if (node == to)
            break;
        if (cost > costs[static_cast<std::size_t>(node)])
            continue;
        for (const Edge& edge : graph.edgesFrom(node)) {
            const auto target = static_cast<std::size_t>(edge.to);
            if (cost + edge.weight < costs[target]) {
                costs[target] = cost + edge.weight;
                last[target] = &edge;
                open.emplace(costs[target], edge.to);
            }
        }
    }
    return last;
}

} // namespace

std::optional<GraphPath> shortestPath(const Digraph& graph, NodeIndex from, NodeIndex to)
{
    GraphPath path;
    if (from == to)
        return path;
    const auto last = lastEdges(graph, from, to);
    for (NodeIndex node = to; node != from; node = path.edges.back().from) {
        const Edge* const edge = last[static_cast<std::size_t>(node)];
        if (!edge)
            return std::nullopt;
        path.edges.push_back(*edge);
    }
    std::reverse(path.edges.begin(), path.edges.end());
    for (const Edge& edge : path.edges)
        path.cost += edge.weight;
    return path;
}

Table<double> shortestPathCosts(const Digraph& graph, const Progress& progress)
{
    const Table<double> weights = weightTable(graph);
    Table<double> costs = cheapestDetours(weights, progress).min(weights);
    costs.matrix().diagonal().setZero();
    return costs;
}

} // namespace quadrille
