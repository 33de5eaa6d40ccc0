// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// Most edges fall to one pass over all pairs: playing on before or after another transition is as cheap. Of
// those that are left an edge is safe where it weighs less than the cheapest transition that can be taken
// from its frame and the cheapest that comes to its destination together. For the others some sources in a
// row walk through the graph at once (see EdgeWalks).
#include "model/graph/essentialedges.h"

#include "model/core/freememory.h"
#include "model/graph/edgewalks.h"

#include <algorithm>
#include <atomic>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

/// More than sums of walks are rounded by, and less than a tie.
constexpr double rounding = 1e-9;

class EdgeSearch
{
public:
    EdgeSearch(const TransitionCosts& costs, double alpha)
        : m_costs(costs)
        , m_layout(costs.layout())
        , m_alpha(alpha)
        , m_frames(m_layout.frameCount())
        , m_graph(m_layout, alpha)
        , m_roundTrips(static_cast<std::size_t>(m_frames), unreachable)
    {
    }

    Digraph run(const Progress& progress, const std::function<void(Digraph)>& certain)
    {
        std::atomic<NodeIndex> done = 0;
        tbb::parallel_for(0, m_layout.sequenceCount(), [&](int sequence) {
            leaveOutDominated(sequence);
            progress.part(0, 0.2).report(done += m_layout.countOf(sequence), m_frames);
        });
        m_costs.unloadLengths();
        decideByLeast();
        if (certain)
            certain(keptEdges());
        tbb::parallel_for(NodeIndex{0}, m_frames, [this](NodeIndex i) { m_graph.sort(i); });
        m_graph.nearlyFree = nearlyFree();
        const NodeIndex blocks = (m_frames + EdgeWalks::lanes - 1) / EdgeWalks::lanes;
        tbb::enumerable_thread_specific<EdgeWalks> workspaces(m_frames);
        done = 0;
        tbb::parallel_for(NodeIndex{0}, blocks, [&](NodeIndex block) {
            decide(block * EdgeWalks::lanes, workspaces.local());
            progress.part(0.2, 0.9).report(++done, blocks);
        });
        m_graph.excesses = {};
        workspaces.clear();
        std::vector<std::size_t> doubtful;
        Digraph graph = join(doubtful);
        if (!doubtful.empty())
            graph = withoutReplaceable(graph, doubtful, progress.part(0.9, 1));
        progress.report(1);
        return graph;
    }

private:
    bool isOriginal(NodeIndex from, NodeIndex to) const
    {
        return to == from + 1 && to <= m_layout.lastOf(m_layout.sequenceOf(from));
    }

    /// The edges from one sequence that are cheaper than the detours which leave later along it, arrive
    /// earlier in the destination's and play on, or both, with one transition between. Each edge that goes
    /// goes for one that leaves later or arrives earlier, so that never two go for each other.
    void leaveOutDominated(int source)
    {
        std::vector<double> weights(static_cast<std::size_t>(m_frames));
        // Of the frame after i, then of i: the cheapest edge to each frame, with what is played around it.
        std::vector<double> cheapest(weights.size(), unreachable);
        OutEdges edges;
        for (NodeIndex i = m_layout.lastOf(source); i >= m_layout.firstOf(source); --i) {
            completeWeightsFrom(m_costs, i, m_alpha, weights.data());
            edges.clear();
            for (int target = 0; target < m_layout.sequenceCount(); ++target) {
                double before = unreachable;
                for (NodeIndex j = m_layout.firstOf(target); j <= m_layout.lastOf(target); ++j) {
                    double& here = cheapest[static_cast<std::size_t>(j)];
                    const double detour = std::min(here, before) + m_alpha;
                    const double weight = weights[static_cast<std::size_t>(j)];
                    here = i == j ? unreachable : std::min(detour, weight);
                    if (detour > weight)
                        edges.push_back({weight, j,
                                         detour > weight * (1 + edgeTie) || isOriginal(i, j)
                                             ? EdgeState::Kept
                                             : EdgeState::Undecided});
                    before = here;
                }
            }
            m_graph.from(i) = edges; // without the room that a growing list has
        }
    }

    /// Any walk with two transitions costs at least as much as the cheapest that leaves and the cheapest that
    /// arrives.
    void decideByLeast()
    {
        std::vector<double>& leaving = m_graph.leaving;
        std::vector<double>& arriving = m_graph.arriving;
        for (NodeIndex i = 0; i < m_frames; ++i) {
            for (const OutEdge& edge : m_graph.from(i)) {
                if (isOriginal(i, edge.to))
                    continue;
                double& leaves = leaving[static_cast<std::size_t>(i)];
                double& arrives = arriving[static_cast<std::size_t>(edge.to)];
                leaves = std::min(leaves, edge.weight);
                arrives = std::min(arrives, edge.weight);
                m_least = std::min(m_least, edge.weight);
                m_greatest = std::max(m_greatest, edge.weight);
            }
        }
        for (int s = 0; s < m_layout.sequenceCount(); ++s) {
            const auto first = static_cast<std::size_t>(m_layout.firstOf(s));
            const auto last = static_cast<std::size_t>(m_layout.lastOf(s));
            for (std::size_t i = last; i > first; --i)
                leaving[i - 1] = std::min(leaving[i - 1], leaving[i] + m_alpha);
            for (std::size_t j = first; j < last; ++j)
                arriving[j + 1] = std::min(arriving[j + 1], arriving[j] + m_alpha);
        }
        tbb::parallel_for(NodeIndex{0}, m_frames, [&](NodeIndex i) {
            for (OutEdge& edge : m_graph.from(i)) {
                const double least =
                    leaving[static_cast<std::size_t>(i)] + arriving[static_cast<std::size_t>(edge.to)];
                if (!isOriginal(i, edge.to) && edge.weight * (1 + edgeTie) >= least * (1 - rounding))
                    edge.state = EdgeState::Undecided;
            }
        });
    }

    Edge edgeOf(NodeIndex from, const OutEdge& edge) const
    {
        return {from, edge.to, edge.weight,
                isOriginal(from, edge.to) ? EdgeKind::Original : EdgeKind::Transition};
    }

    /// \pre The edges of each frame are in the order of their destinations.
    Digraph keptEdges() const
    {
        const auto isKept = [](const OutEdge& edge) { return edge.state == EdgeState::Kept; };
        std::size_t count = 0;
        for (const OutEdges& own : m_graph.edges)
            count += static_cast<std::size_t>(std::ranges::count_if(own, isKept));
        std::vector<Edge> edges;
        edges.reserve(count);
        for (NodeIndex i = 0; i < m_frames; ++i)
            for (const OutEdge& edge : m_graph.from(i))
                if (isKept(edge))
                    edges.push_back(edgeOf(i, edge));
        return {m_frames, std::move(edges)};
    }

    /// The round trips that two edges which tie can stand in for each other by; 0: there are none.
    double nearlyFree() const
    {
        const double free = nearlyFreeTrip * m_greatest;
        return m_least <= free ? free * (1 + edgeTie) : 0;
    }

    void decide(NodeIndex first, EdgeWalks& walks)
    {
        if (!walks.run(m_graph, first))
            return;
        for (NodeIndex i = first; i < std::min(first + EdgeWalks::lanes, m_frames); ++i) {
            m_roundTrips[static_cast<std::size_t>(i)] = walks.detour(i - first, i);
            for (OutEdge& edge : m_graph.from(i)) {
                if (edge.state != EdgeState::Undecided)
                    continue;
                const double detour = walks.detour(i - first, edge.to);
                if (detour > edge.weight * (1 + edgeTie))
                    edge.state = EdgeState::Kept;
                else
                    edge.state = detour < edge.weight * (1 - edgeTie) ? EdgeState::Removed : EdgeState::Tied;
            }
        }
    }

    bool isDoubtful(NodeIndex from, const OutEdge& edge) const
    {
        const double trip = std::min(m_roundTrips[static_cast<std::size_t>(from)],
                                     m_roundTrips[static_cast<std::size_t>(edge.to)]);
        return edge.state == EdgeState::Tied && trip <= nearlyFreeTrip * edge.weight;
    }

    /// \param doubtful  out: positions of the edges that are.
    Digraph join(std::vector<std::size_t>& doubtful)
    {
        const auto goes = [this](NodeIndex from, const OutEdge& edge) {
            return edge.state != EdgeState::Kept && !isDoubtful(from, edge);
        };
        std::size_t count = 0;
        for (NodeIndex i = 0; i < m_frames; ++i)
            count += static_cast<std::size_t>(
                std::ranges::count_if(m_graph.from(i), [&](const OutEdge& edge) { return !goes(i, edge); }));
        constexpr std::size_t manyEdges = 1 << 20;
        const auto returnMemoryOfMany = [count] {
            if (count > manyEdges)
                returnFreeMemory();
        };
        returnMemoryOfMany();
        std::vector<Edge> edges;
        edges.reserve(count);
        // Some frames after the others, whose own edges go then: of large graphs both take much.
        constexpr NodeIndex most = 1024;
        for (NodeIndex first = 0; first < m_frames; first += most) {
            const NodeIndex end = std::min(first + most, m_frames);
            tbb::parallel_for(first, end, [&](NodeIndex i) {
                OutEdges& own = m_graph.from(i);
                std::erase_if(own, [&](const OutEdge& edge) { return goes(i, edge); });
                std::ranges::sort(own, {}, &OutEdge::to);
            });
            for (NodeIndex i = first; i < end; ++i) {
                for (const OutEdge& edge : m_graph.from(i)) {
                    if (edge.state == EdgeState::Tied)
                        doubtful.push_back(edges.size());
                    edges.push_back(edgeOf(i, edge));
                }
                m_graph.from(i) = {};
            }
            returnMemoryOfMany();
        }
        return {m_frames, std::move(edges)};
    }

    const TransitionCosts& m_costs;
    const FrameLayout& m_layout;
    double m_alpha;
    NodeIndex m_frames;
    OutEdgeGraph m_graph;
    std::vector<double> m_roundTrips; ///< from each frame back to it, where they are nearly free
    double m_least = unreachable;     ///< weight of a transition
    double m_greatest = 0;
};

} // namespace

Digraph essentialEdges(const TransitionCosts& costs, double alpha, const Progress& progress,
                       const std::function<void(Digraph)>& certain)
{
    requireAlpha(alpha);
    return EdgeSearch(costs, alpha).run(progress, certain);
}

} // namespace quadrille
