// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// Most edges fall to one pass over all pairs: playing on before or after another transition is as cheap. Of
// those that are left an edge is safe where it weighs less than the cheapest transition that can be taken
// from its frame and the cheapest that comes to its destination together. For the others `lanes` sources in a
// row walk through the graph at once, no farther than the dearest edge of theirs that is not decided.
#include "model/graph/essentialedges.h"

#include "model/core/simd.h"
#include "model/graph/replaceableedges.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

constexpr NodeIndex lanes = 32;
/// More than sums of walks are rounded by, and less than a tie.
constexpr double rounding = 1e-9;

enum class EdgeState : std::uint8_t
{
    Kept,
    Undecided,
    Tied,
    Removed,
};

/// An edge from a frame that is known.
struct OutEdge
{
    double weight;
    NodeIndex to;
    EdgeState state;
};
using OutEdges = std::vector<OutEdge>;

/// What is known from some sources in a row; by node, sources side by side.
struct SourceBlock
{
    explicit SourceBlock(NodeIndex nodes)
        : direct(static_cast<std::size_t>(nodes) * lanes, unreachable)
        , detours(direct.size(), unreachable)
        , isTouched(static_cast<std::size_t>(nodes), 0)
        , waiting((static_cast<std::size_t>(nodes) + 63) / 64, 0)
    {
    }

    void touch(NodeIndex node)
    {
        if (!isTouched[static_cast<std::size_t>(node)]) {
            isTouched[static_cast<std::size_t>(node)] = 1;
            touched.push_back(node);
        }
    }

    void wait(NodeIndex node)
    {
        waiting[static_cast<std::size_t>(node) / 64] |= std::uint64_t{1} << (node % 64);
    }

    void clear()
    {
        for (const NodeIndex node : touched) {
            const auto at = static_cast<std::ptrdiff_t>(node) * lanes;
            std::fill_n(direct.begin() + at, lanes, unreachable);
            std::fill_n(detours.begin() + at, lanes, unreachable);
            isTouched[static_cast<std::size_t>(node)] = 0;
        }
        touched.clear();
    }

    std::vector<double> direct;  ///< weights of the sources' own edges, as far as they count
    std::vector<double> detours; ///< with a node between
    std::vector<std::uint8_t> isTouched;
    std::vector<NodeIndex> touched;
    std::vector<std::uint64_t> waiting; ///< a bit for each node whose edges are to be followed
    std::array<double, lanes> bounds{}; ///< no walk of a source that costs more counts
};

/// Lowers the detours to the ends of the edges of one node. \param edges  by weight. \param costs  of walks
/// to the node. \param lowered  out: the nodes that became cheaper. \return their number.
QUADRILLE_SIMD_CLONES
NodeIndex follow(const OutEdge* edges, std::size_t count, double longest, const double* costs,
                 double* detours, NodeIndex* lowered)
{
    NodeIndex found = 0;
    for (std::size_t e = 0; e < count && edges[e].weight <= longest; ++e) {
        const double weight = edges[e].weight;
        double* const known = detours + static_cast<std::ptrdiff_t>(edges[e].to) * lanes;
        int isLower = 0;
#pragma omp simd reduction(| : isLower)
        for (NodeIndex l = 0; l < lanes; ++l) {
            const double sum = costs[l] + weight;
            isLower |= sum < known[l];
            known[l] = sum < known[l] ? sum : known[l];
        }
        lowered[found] = edges[e].to;
        found += isLower != 0;
    }
    return found;
}

class EdgeSearch
{
public:
    EdgeSearch(const TransitionCosts& costs, double alpha)
        : m_costs(costs)
        , m_layout(costs.layout())
        , m_alpha(alpha)
        , m_frames(m_layout.frameCount())
        , m_edges(static_cast<std::size_t>(m_frames))
        , m_roundTrips(static_cast<std::size_t>(m_frames), unreachable)
    {
    }

    Digraph run(const Progress& progress)
    {
        std::atomic<NodeIndex> done = 0;
        tbb::parallel_for(0, m_layout.sequenceCount(), [&](int sequence) {
            leaveOutDominated(sequence);
            progress.part(0, 0.2).report(done += m_layout.countOf(sequence), m_frames);
        });
        decideByLeast();
        const NodeIndex blocks = (m_frames + lanes - 1) / lanes;
        tbb::enumerable_thread_specific<SourceBlock> workspaces(m_frames);
        done = 0;
        tbb::parallel_for(NodeIndex{0}, blocks, [&](NodeIndex block) {
            decide(block * lanes, workspaces.local());
            progress.part(0.2, 0.9).report(++done, blocks);
        });
        std::vector<std::size_t> doubtful;
        Digraph graph = join(doubtful);
        if (!doubtful.empty())
            graph = withoutReplaceable(graph, doubtful, progress.part(0.9, 1));
        progress.report(1);
        return graph;
    }

private:
    OutEdges& edgesOf(NodeIndex node) { return m_edges[static_cast<std::size_t>(node)]; }

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
        for (NodeIndex i = m_layout.lastOf(source); i >= m_layout.firstOf(source); --i) {
            completeWeightsFrom(m_costs, i, m_alpha, weights.data());
            OutEdges& edges = edgesOf(i);
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
            std::sort(edges.begin(), edges.end(), [](const OutEdge& a, const OutEdge& b) {
                return a.weight != b.weight ? a.weight < b.weight : a.to < b.to;
            });
        }
    }

    /// Any walk with two transitions costs at least as much as the cheapest that leaves and the cheapest that
    /// arrives.
    void decideByLeast()
    {
        std::vector<double> leaving(static_cast<std::size_t>(m_frames), unreachable);
        std::vector<double> arriving = leaving;
        for (NodeIndex i = 0; i < m_frames; ++i) {
            for (const OutEdge& edge : edgesOf(i)) {
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
            for (OutEdge& edge : edgesOf(i)) {
                const double least =
                    leaving[static_cast<std::size_t>(i)] + arriving[static_cast<std::size_t>(edge.to)];
                if (!isOriginal(i, edge.to) && edge.weight * (1 + edgeTie) >= least * (1 - rounding))
                    edge.state = EdgeState::Undecided;
            }
        });
    }

    /// The round trips that two edges which tie can stand in for each other by; 0: there are none.
    double nearlyFree() const
    {
        const double free = nearlyFreeTrip * m_greatest;
        return m_least <= free ? free * (1 + edgeTie) : 0;
    }

    void decide(NodeIndex first, SourceBlock& block)
    {
        const NodeIndex end = std::min(first + lanes, m_frames);
        block.bounds.fill(-1);
        for (NodeIndex i = first; i < end; ++i) {
            double& bound = block.bounds[static_cast<std::size_t>(i - first)];
            bound = nearlyFree() > 0 ? nearlyFree() : bound;
            for (const OutEdge& edge : edgesOf(i)) // by weight
                if (edge.state == EdgeState::Undecided)
                    bound = std::max(bound, edge.weight * (1 + 2 * edgeTie));
        }
        if (*std::max_element(block.bounds.begin(), block.bounds.end()) < 0)
            return;
        walk(first, end, block);
        for (NodeIndex i = first; i < end; ++i) {
            const auto detourTo = [&](NodeIndex node) {
                return block
                    .detours[static_cast<std::size_t>(node) * lanes + static_cast<std::size_t>(i - first)];
            };
            m_roundTrips[static_cast<std::size_t>(i)] = detourTo(i);
            for (OutEdge& edge : edgesOf(i)) {
                if (edge.state != EdgeState::Undecided)
                    continue;
                const double detour = detourTo(edge.to);
                if (detour > edge.weight * (1 + edgeTie))
                    edge.state = EdgeState::Kept;
                else
                    edge.state = detour < edge.weight * (1 - edgeTie) ? EdgeState::Removed : EdgeState::Tied;
            }
        }
        block.clear();
    }

    /// Nodes take their turns in order, so that runs of original edges are done in one sweep.
    void walk(NodeIndex first, NodeIndex end, SourceBlock& block)
    {
        for (NodeIndex i = first; i < end; ++i) {
            const auto lane = static_cast<std::size_t>(i - first);
            for (const OutEdge& edge : edgesOf(i)) {
                if (edge.weight > block.bounds[lane])
                    break;
                block.direct[static_cast<std::size_t>(edge.to) * lanes + lane] = edge.weight;
                block.touch(edge.to);
                block.wait(edge.to);
            }
        }
        std::vector<NodeIndex> lowered(m_edges.size());
        for (bool isAny = true; isAny;) {
            isAny = false;
            for (std::size_t word = 0; word < block.waiting.size(); ++word) {
                while (block.waiting[word] != 0) {
                    isAny = true;
                    const int bit = std::countr_zero(block.waiting[word]);
                    block.waiting[word] &= block.waiting[word] - 1;
                    pass(static_cast<NodeIndex>(word * 64) + bit, first, end, block, lowered);
                }
            }
        }
    }

    void pass(NodeIndex node, NodeIndex first, NodeIndex end, SourceBlock& block,
              std::vector<NodeIndex>& lowered)
    {
        std::array<double, lanes> costs{};
        const auto at = static_cast<std::size_t>(node) * lanes;
        for (std::size_t l = 0; l < lanes; ++l)
            costs[l] = std::min(block.direct[at + l], block.detours[at + l]);
        if (node >= first && node < end)
            costs[static_cast<std::size_t>(node - first)] = unreachable;
        double longest = -1;
        for (std::size_t l = 0; l < lanes; ++l)
            longest = std::max(longest, block.bounds[l] - costs[l]);
        const OutEdges& edges = edgesOf(node);
        const NodeIndex count =
            follow(edges.data(), edges.size(), longest, costs.data(), block.detours.data(), lowered.data());
        for (NodeIndex n = 0; n < count; ++n) {
            const NodeIndex to = lowered[static_cast<std::size_t>(n)];
            block.touch(to);
            if (isNearer(to, block))
                block.wait(to);
        }
    }

    /// Whether a detour to a node is a source's cheapest walk there, and counts.
    static bool isNearer(NodeIndex node, const SourceBlock& block)
    {
        const auto at = static_cast<std::size_t>(node) * lanes;
        int isAny = 0;
        for (std::size_t l = 0; l < lanes; ++l)
            isAny |= static_cast<int>(block.detours[at + l] < block.direct[at + l]) &
                     static_cast<int>(block.detours[at + l] <= block.bounds[l]);
        return isAny != 0;
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
        std::vector<std::size_t> firstOf{0};
        for (NodeIndex i = 0; i < m_frames; ++i) {
            std::erase_if(edgesOf(i), [&](const OutEdge& edge) {
                return edge.state != EdgeState::Kept && !isDoubtful(i, edge);
            });
            firstOf.push_back(firstOf.back() + edgesOf(i).size());
        }
        std::vector<Edge> edges(firstOf.back());
        tbb::parallel_for(NodeIndex{0}, m_frames, [&](NodeIndex i) {
            OutEdges own = std::move(edgesOf(i));
            std::sort(own.begin(), own.end(), [](const OutEdge& a, const OutEdge& b) { return a.to < b.to; });
            std::transform(own.begin(), own.end(), edges.data() + firstOf[static_cast<std::size_t>(i)],
                           [&](const OutEdge& edge) {
                               const auto kind =
                                   isOriginal(i, edge.to) ? EdgeKind::Original : EdgeKind::Transition;
                               return Edge{i, edge.to, edge.weight, kind};
                           });
            edgesOf(i) = std::move(own);
        });
        for (NodeIndex i = 0; i < m_frames; ++i)
            for (std::size_t e = 0; e < edgesOf(i).size(); ++e)
                if (edgesOf(i)[e].state == EdgeState::Tied)
                    doubtful.push_back(firstOf[static_cast<std::size_t>(i)] + e);
        m_edges.clear();
        return {m_frames, std::move(edges)};
    }

    const TransitionCosts& m_costs;
    const FrameLayout& m_layout;
    double m_alpha;
    NodeIndex m_frames;
    std::vector<OutEdges> m_edges;    ///< of each frame, by weight
    std::vector<double> m_roundTrips; ///< from each frame back to it, where they are nearly free
    double m_least = unreachable;     ///< weight of a transition
    double m_greatest = 0;
};

} // namespace

Digraph essentialEdges(const TransitionCosts& costs, double alpha, const Progress& progress)
{
    requireAlpha(alpha);
    return EdgeSearch(costs, alpha).run(progress);
}

} // namespace quadrille
