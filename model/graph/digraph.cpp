// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/digraph.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace quadrille {
namespace {

bool isBefore(const Edge& a, const Edge& b)
{
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
}

} // namespace

Digraph::Digraph(NodeIndex nodeCount, std::vector<Edge> edges)
{
    assert(std::adjacent_find(edges.begin(), edges.end(),
                              [](const Edge& a, const Edge& b) { return !isBefore(a, b); }) == edges.end());
    std::vector<std::size_t> firstOf(static_cast<std::size_t>(nodeCount) + 1, edges.size());
    std::size_t node = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Edge& edge = edges[e];
        assert(edge.from >= 0 && edge.to >= 0 && edge.from < nodeCount && edge.to < nodeCount);
        assert(edge.from != edge.to && std::isfinite(edge.weight) && edge.weight >= 0);
        for (; node <= static_cast<std::size_t>(edge.from); ++node)
            firstOf[node] = e;
    }
    m_content = std::make_shared<const Content>(Content{std::move(edges), std::move(firstOf)});
}

std::span<const Edge> Digraph::edgesFrom(NodeIndex node) const
{
    assert(node >= 0 && node < nodeCount());
    const auto n = static_cast<std::size_t>(node);
    const std::vector<std::size_t>& firstOf = m_content->firstOf;
    return edges().subspan(firstOf[n], firstOf[n + 1] - firstOf[n]);
}

const Edge* Digraph::find(NodeIndex from, NodeIndex to) const
{
    const auto edges = edgesFrom(from);
    const auto found = std::lower_bound(edges.begin(), edges.end(), to,
                                        [](const Edge& edge, NodeIndex node) { return edge.to < node; });
    return found != edges.end() && found->to == to ? &*found : nullptr;
}

std::int64_t Digraph::count(EdgeKind kind) const
{
    return std::ranges::count(edges(), kind, &Edge::kind);
}

double Digraph::density() const
{
    const double nodes = nodeCount();
    return nodes < 2 ? 0 : static_cast<double>(edges().size()) / (nodes * (nodes - 1));
}

Digraph thinned(const Digraph& graph, std::int64_t edgeCount)
{
    std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
    const auto transitions = std::stable_partition(
        edges.begin(), edges.end(), [](const Edge& edge) { return edge.kind == EdgeKind::Original; });
    const auto room = std::max<std::int64_t>(edgeCount - (transitions - edges.begin()), 0);
    if (room < edges.end() - transitions) {
        std::nth_element(transitions, transitions + room, edges.end(), [](const Edge& a, const Edge& b) {
            return std::tie(a.weight, a.from, a.to) < std::tie(b.weight, b.from, b.to);
        });
        edges.erase(transitions + room, edges.end());
    }
    std::sort(edges.begin(), edges.end(), isBefore);
    return {graph.nodeCount(), std::move(edges)};
}

Table<double> weightTable(const Digraph& graph)
{
    Table<double> weights = Table<double>::Constant(graph.nodeCount(), graph.nodeCount(), unreachable);
    for (const Edge& edge : graph.edges())
        weights(edge.from, edge.to) = edge.weight;
    return weights;
}

} // namespace quadrille
