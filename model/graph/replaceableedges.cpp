// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/replaceableedges.h"

#include <functional>
#include <queue>

namespace quadrille {
namespace {

/// Takes edges out of a graph one by one.
class EdgeRemoval
{
public:
    explicit EdgeRemoval(const Digraph& graph)
        : m_graph(graph)
        , m_isRemoved(graph.edges().size())
        , m_costs(static_cast<std::size_t>(graph.nodeCount()), unreachable)
    {
    }

    /// Removes an edge if the rest holds a walk between its ends that costs no more than `limit`.
    void removeIfReplaced(const Edge& edge, double limit)
    {
        m_isRemoved[indexOf(edge)] = true;
        m_isRemoved[indexOf(edge)] = isReachable(edge.from, edge.to, limit);
    }

    Digraph rest() const
    {
        std::vector<Edge> edges;
        for (const Edge& edge : m_graph.edges())
            if (!m_isRemoved[indexOf(edge)])
                edges.push_back(edge);
        return {m_graph.nodeCount(), std::move(edges)};
    }

private:
    std::size_t indexOf(const Edge& edge) const
    {
        return static_cast<std::size_t>(&edge - m_graph.edges().data());
    }

    bool isReachable(NodeIndex from, NodeIndex to, double limit)
    {
        using Entry = std::pair<double, NodeIndex>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        open.emplace(0, from);
        m_costs[static_cast<std::size_t>(from)] = 0;
        m_touched.assign(1, from);
        bool isFound = false;
        while (!open.empty() && !isFound) {
            const auto [cost, node] = open.top();
            open.pop();
            isFound = node == to;
            if (cost > m_costs[static_cast<std::size_t>(node)])
                continue;
            for (const Edge& edge : m_graph.edgesFrom(node)) {
                double& known = m_costs[static_cast<std::size_t>(edge.to)];
                const double reached = cost + edge.weight;
                if (reached > limit || reached >= known || m_isRemoved[indexOf(edge)])
                    continue;
                known = reached;
                m_touched.push_back(edge.to);
                open.emplace(reached, edge.to);
            }
        }
        for (const NodeIndex node : m_touched)
            m_costs[static_cast<std::size_t>(node)] = unreachable;
        return isFound;
    }

    const Digraph& m_graph;
    std::vector<bool> m_isRemoved;
    std::vector<double> m_costs;
    std::vector<NodeIndex> m_touched;
};

} // namespace

Digraph withoutReplaceable(const Digraph& graph, const std::vector<std::size_t>& doubtful,
                           const Progress& progress)
{
    EdgeRemoval removal(graph);
    for (std::size_t d = 0; d < doubtful.size(); ++d) {
        progress.report(static_cast<double>(d) / static_cast<double>(doubtful.size()));
        const Edge& edge = graph.edges()[doubtful[d]];
        removal.removeIfReplaced(edge, edge.weight * (1 + edgeTie));
    }
    return removal.rest();
}

} // namespace quadrille
