// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/components.h"

#include <algorithm>

namespace quadrille {
namespace {

/// Tarjan's algorithm, with a stack of its own: walks may be as long as the graph has nodes.
class ComponentSearch
{
public:
    explicit ComponentSearch(const Digraph& graph)
        : m_graph(graph), m_nodes(static_cast<std::size_t>(graph.nodeCount()))
    {
    }

    std::vector<std::vector<NodeIndex>> run()
    {
        for (NodeIndex node = 0; node < m_graph.nodeCount(); ++node)
            if (stateOf(node).order == unseen)
                visitFrom(node);
        for (auto& component : m_components)
            std::sort(component.begin(), component.end());
        std::sort(m_components.begin(), m_components.end(), [](const auto& a, const auto& b) {
            return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
        });
        return std::move(m_components);
    }

private:
    static constexpr int unseen = -1;
    struct State
    {
        int order = unseen;       ///< in which the node was first seen
        int lowest = unseen;      ///< order of the earliest node of its component known to be reached from it
        std::size_t nextEdge = 0; ///< of those that leave it
        bool isOpen = false;      ///< its component is not complete yet
    };

    State& stateOf(NodeIndex node) { return m_nodes[static_cast<std::size_t>(node)]; }

    void enter(NodeIndex node)
    {
        stateOf(node) = {m_seen, m_seen, 0, true};
        ++m_seen;
        m_walk.push_back(node);
        m_open.push_back(node);
    }

    void visitFrom(NodeIndex start)
    {
        enter(start);
        while (!m_walk.empty()) {
            const NodeIndex node = m_walk.back();
            State& state = stateOf(node);
            const auto edges = m_graph.edgesFrom(node);
            if (state.nextEdge == edges.size()) {
                leave(node);
                continue;
            }
            const NodeIndex target = edges[state.nextEdge++].to;
            if (stateOf(target).order == unseen)
                enter(target);
            else if (stateOf(target).isOpen)
                state.lowest = std::min(state.lowest, stateOf(target).order);
        }
    }

    void leave(NodeIndex node)
    {
        m_walk.pop_back();
        const State& state = stateOf(node);
        if (!m_walk.empty())
            stateOf(m_walk.back()).lowest = std::min(stateOf(m_walk.back()).lowest, state.lowest);
        if (state.lowest != state.order)
            return;
        const auto first = std::find(m_open.rbegin(), m_open.rend(), node).base() - 1;
        for (auto member = first; member != m_open.end(); ++member)
            stateOf(*member).isOpen = false;
        m_components.emplace_back(first, m_open.end());
        m_open.erase(first, m_open.end());
    }

    const Digraph& m_graph;
    std::vector<State> m_nodes;
    int m_seen = 0;
    std::vector<NodeIndex> m_walk; ///< from the start to the node being visited
    std::vector<NodeIndex> m_open;
    std::vector<std::vector<NodeIndex>> m_components;
};

/// The frames that cannot be reached from some along edges, or against them.
std::vector<NodeIndex> outOfReach(const Digraph& graph, const std::vector<NodeIndex>& starts, bool against)
{
    const auto nodes = static_cast<std::size_t>(graph.nodeCount());
    std::vector<std::vector<NodeIndex>> neighbours(nodes);
    for (const Edge& edge : graph.edges())
        neighbours[static_cast<std::size_t>(against ? edge.to : edge.from)].push_back(against ? edge.from
                                                                                              : edge.to);
    std::vector<bool> isReached(nodes);
    std::vector<NodeIndex> open = starts;
    for (const NodeIndex node : starts)
        isReached[static_cast<std::size_t>(node)] = true;
    while (!open.empty()) {
        const auto node = static_cast<std::size_t>(open.back());
        open.pop_back();
        for (const NodeIndex neighbour : neighbours[node]) {
            if (!isReached[static_cast<std::size_t>(neighbour)]) {
                isReached[static_cast<std::size_t>(neighbour)] = true;
                open.push_back(neighbour);
            }
        }
    }
    std::vector<NodeIndex> left;
    for (NodeIndex node = 0; node < graph.nodeCount(); ++node)
        if (!isReached[static_cast<std::size_t>(node)])
            left.push_back(node);
    return left;
}

} // namespace

Connectivity connectivity(const Digraph& graph)
{
    Connectivity result{.components = ComponentSearch(graph).run()};
    std::vector<NodeIndex> largest;
    if (!result.components.empty() && result.components.front().size() > 1)
        largest = result.components.front();
    result.unreachable = outOfReach(graph, largest, false);
    result.deadEnds = outOfReach(graph, largest, true);
    return result;
}

} // namespace quadrille
