// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/partoverlap.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace quadrille {

/// The shortest closed walk that crosses the cut an odd number of times. That through one vertex consists of
/// two shortest paths from it and an edge between their ends.
class PartOverlap::SeamSearch
{
public:
    SeamSearch(const PartOverlap& overlap, std::span<const double> costs)
        : m_overlap(overlap), m_costs(costs), m_nodes(overlap.vertexCount())
    {
    }

    void searchFrom(std::uint32_t source);
    const std::vector<std::uint32_t>& best() const { return m_best; }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    struct Node
    {
        double distance = std::numeric_limits<double>::infinity();
        std::uint32_t from = none;
        bool isOdd = false; ///< the path crosses the cut an odd number of times
        bool isSettled = false;
    };

    void settle(std::uint32_t vertex);
    void close(std::uint32_t a, std::uint32_t b);
    void push(double distance, std::uint32_t vertex)
    {
        m_heap.emplace_back(distance, vertex);
        std::ranges::push_heap(m_heap, std::greater{});
    }

    const PartOverlap& m_overlap;
    std::span<const double> m_costs;
    std::vector<Node> m_nodes;
    std::vector<std::pair<double, std::uint32_t>> m_heap;
    std::vector<std::uint32_t> m_best;
    double m_bestLength = std::numeric_limits<double>::infinity();
};

void PartOverlap::SeamSearch::searchFrom(std::uint32_t source)
{
    std::ranges::fill(m_nodes, Node{});
    m_heap.clear();
    m_nodes[source].distance = 0;
    push(0, source);
    while (!m_heap.empty()) {
        const auto [distance, vertex] = m_heap.front();
        if (2 * distance >= m_bestLength)
            break;
        std::ranges::pop_heap(m_heap, std::greater{});
        m_heap.pop_back();
        if (!m_nodes[vertex].isSettled)
            settle(vertex);
    }
}

void PartOverlap::SeamSearch::settle(std::uint32_t vertex)
{
    Node& node = m_nodes[vertex];
    node.isSettled = true;
    for (const Neighbour& next : m_overlap.neighboursOf(vertex)) {
        Node& other = m_nodes[next.vertex];
        const bool isOdd = node.isOdd != m_overlap.m_edges[next.edge].isCrossing;
        const double distance = node.distance + m_costs[next.edge];
        if (other.isSettled) {
            const double length = distance + other.distance;
            if (isOdd != other.isOdd && length < m_bestLength) {
                m_bestLength = length;
                close(vertex, next.vertex);
            }
        } else if (distance < other.distance) {
            other = {distance, vertex, isOdd, false};
            push(distance, next.vertex);
        }
    }
}

void PartOverlap::SeamSearch::close(std::uint32_t a, std::uint32_t b)
{
    const auto pathTo = [this](std::uint32_t vertex) {
        std::vector<std::uint32_t> path;
        for (std::uint32_t v = vertex; v != none; v = m_nodes[v].from)
            path.push_back(v);
        return path;
    };
    m_best = pathTo(a);
    std::vector<std::uint32_t> back = pathTo(b);
    // What both paths have in common at their beginnings is no part of the curve.
    std::uint32_t fork = m_best.back();
    while (!m_best.empty() && !back.empty() && m_best.back() == back.back()) {
        fork = m_best.back();
        m_best.pop_back();
        back.pop_back();
    }
    m_best.push_back(fork);
    m_best.insert(m_best.end(), back.rbegin(), back.rend());
}

std::vector<std::uint32_t> PartOverlap::cheapestSeam(std::span<const double> costs) const
{
    SeamSearch search(*this, costs);
    for (const std::uint32_t source : m_sources)
        search.searchFrom(source);
    if (search.best().empty())
        return m_end;
    const Sides sides = sidesOf(search.best());
    for (std::size_t e = 0; e < m_edges.size(); ++e) {
        if (m_edges[e].isParentEnd && !sides.isSeam[e] && sides.isParents[m_edgeTriangles[e].front()])
            return m_end;
    }
    return search.best();
}

} // namespace quadrille
