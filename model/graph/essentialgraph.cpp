// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/essentialgraph.h"

#include "model/graph/detours.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

constexpr double tie = 1e-7;
/// Two edges can stand in for each other only where a round trip costs no more than the tolerance of their
/// ties; a chain of edges, that many times as much.
constexpr double nearlyFree = 1e-3;

struct Candidate
{
    Edge edge;
    bool isDoubtful = false; ///< ties with another walk that may need this very edge
};

/// Takes out the edges that are no cheaper than leaving later along the source's sequence, arriving earlier
/// in the destination's and playing on, or both: most of them, at the price of one pass. Each goes for an
/// edge that leaves later or arrives earlier, so that never two go for each other.
void removeDominated(Table<double>& weights, const FrameLayout& layout, double alpha)
{
    tbb::parallel_for(0, layout.sequenceCount(), [&](int source) {
        // Of the frame after i, then of i: the cheapest edge to each frame, with what is played around it.
        std::vector<double> cheapest(static_cast<std::size_t>(layout.frameCount()), unreachable);
        for (NodeIndex i = layout.lastOf(source); i >= layout.firstOf(source); --i) {
            for (int target = 0; target < layout.sequenceCount(); ++target) {
                double before = unreachable;
                for (NodeIndex j = layout.firstOf(target); j <= layout.lastOf(target); ++j) {
                    double& here = cheapest[static_cast<std::size_t>(j)];
                    const double other = std::min(here, before) + alpha;
                    double& weight = weights(i, j);
                    here = i == j ? unreachable : std::min(other, weight);
                    if (other <= weight)
                        weight = unreachable;
                    before = here;
                }
            }
        }
    });
}

/// Edges of one frame that are on a shortest path, or may be.
std::vector<Candidate> candidatesFrom(NodeIndex i, const TransitionCosts& costs, const Table<double>& weights,
                                      const Table<double>& detours)
{
    std::vector<Candidate> candidates;
    const FrameLayout& layout = costs.layout();
    const NodeIndex next = i < layout.lastOf(layout.sequenceOf(i)) ? i + 1 : -1;
    for (NodeIndex j = 0; j < layout.frameCount(); ++j) {
        const double weight = weights(i, j);
        const double detour = detours(i, j);
        if (weight == unreachable || (detour < weight * (1 - tie) && j != next))
            continue;
        const Edge edge{i, j, weight, j == next ? EdgeKind::Original : EdgeKind::Transition};
        if (j == next || detour > weight * (1 + tie))
            candidates.push_back({edge, false});
        else if (std::min(detours(i, i), detours(j, j)) <= nearlyFree * weight)
            candidates.push_back({edge, true});
    }
    return candidates;
}

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

Digraph withoutReplaceable(const Digraph& graph, const std::vector<std::size_t>& doubtful,
                           const Progress& progress)
{
    EdgeRemoval removal(graph);
    for (std::size_t d = 0; d < doubtful.size(); ++d) {
        progress.report(static_cast<double>(d) / static_cast<double>(doubtful.size()));
        const Edge& edge = graph.edges()[doubtful[d]];
        removal.removeIfReplaced(edge, edge.weight * (1 + tie));
    }
    return removal.rest();
}

} // namespace

EssentialGraph essentialGraph(const TransitionCosts& costs, double alpha, const Progress& progress)
{
    Table<double> weights = completeWeights(costs, alpha);
    removeDominated(weights, costs.layout(), alpha);
    EssentialGraph essential{.pathCosts = cheapestDetours(weights, progress.part(0, 0.9))};
    Table<double>& detours = essential.pathCosts;
    const NodeIndex frames = costs.layout().frameCount();
    std::vector<std::vector<Candidate>> candidates(static_cast<std::size_t>(frames));
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        candidates[static_cast<std::size_t>(i)] = candidatesFrom(i, costs, weights, detours);
    });
    std::vector<Edge> edges;
    std::vector<std::size_t> doubtful;
    for (const auto& row : candidates) {
        for (const Candidate& candidate : row) {
            if (candidate.isDoubtful)
                doubtful.push_back(edges.size());
            edges.push_back(candidate.edge);
        }
    }
    essential.graph = Digraph(frames, std::move(edges));
    if (!doubtful.empty())
        essential.graph = withoutReplaceable(essential.graph, doubtful, progress.part(0.9, 1));
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        detours.row(i) = detours.row(i).min(weights.row(i));
        detours(i, i) = 0;
    });
    progress.report(1);
    return essential;
}

} // namespace quadrille
