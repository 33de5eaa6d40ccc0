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
    : m_edges(std::move(edges)), m_firstOf(static_cast<std::size_t>(nodeCount) + 1, m_edges.size())
{
    assert(std::adjacent_find(m_edges.begin(), m_edges.end(),
                              [](const Edge& a, const Edge& b) { return !isBefore(a, b); }) == m_edges.end());
    std::size_t node = 0;
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        const Edge& edge = m_edges[e];
        assert(edge.from >= 0 && edge.to >= 0 && edge.from < nodeCount && edge.to < nodeCount);
        assert(edge.from != edge.to && std::isfinite(edge.weight) && edge.weight >= 0);
        for (; node <= static_cast<std::size_t>(edge.from); ++node)
            m_firstOf[node] = e;
    }
}

std::span<const Edge> Digraph::edgesFrom(NodeIndex node) const
{
    assert(node >= 0 && node < nodeCount());
    const auto n = static_cast<std::size_t>(node);
    return std::span(m_edges).subspan(m_firstOf[n], m_firstOf[n + 1] - m_firstOf[n]);
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
    return std::count_if(m_edges.begin(), m_edges.end(), [&](const Edge& edge) { return edge.kind == kind; });
}

double Digraph::density() const
{
    const double nodes = nodeCount();
    return nodes < 2 ? 0 : static_cast<double>(m_edges.size()) / (nodes * (nodes - 1));
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
