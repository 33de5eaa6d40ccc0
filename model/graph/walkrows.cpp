// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// As lowerDetoursSparsely, from a graph and without detours.
#include "model/graph/walkrows.h"

#include "model/core/simd.h"

#include <algorithm>
#include <atomic>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace quadrille {
namespace {

constexpr NodeIndex sourcesAtOnce = 32;

/// The edges that lead to each node, in the order of their sources.
struct EdgesTo
{
    explicit EdgesTo(const Digraph& graph)
        : firstOf(static_cast<std::size_t>(graph.nodeCount()) + 1, 0)
        , sources(graph.edges().size())
        , weights(graph.edges().size())
    {
        for (const Edge& edge : graph.edges())
            ++firstOf[static_cast<std::size_t>(edge.to) + 1];
        for (std::size_t node = 1; node < firstOf.size(); ++node)
            firstOf[node] += firstOf[node - 1];
        std::vector<std::int64_t> next = firstOf;
        for (const Edge& edge : graph.edges()) {
            const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(edge.to)]++);
            sources[at] = edge.from;
            weights[at] = edge.weight;
        }
    }

    std::vector<std::int64_t> firstOf; ///< of each node, and the number of edges
    std::vector<NodeIndex> sources;
    std::vector<double> weights;
};

struct WalkBlock
{
    explicit WalkBlock(NodeIndex nodes)
        : costs(static_cast<std::size_t>(nodes) * sourcesAtOnce)
        , changed(static_cast<std::size_t>(nodes))
        , visited(static_cast<std::size_t>(nodes))
    {
    }

    /// Nothing is known but that each source is where it is.
    void start(NodeIndex first, NodeIndex count)
    {
        std::fill(costs.begin(), costs.end(), unreachable);
        std::fill(changed.begin(), changed.end(), -1);
        std::fill(visited.begin(), visited.end(), 0);
        for (std::size_t s = 0; s < static_cast<std::size_t>(count); ++s) {
            const std::size_t source = static_cast<std::size_t>(first) + s;
            costs[source * sourcesAtOnce + s] = 0;
            changed[source] = 1;
        }
        now = 1;
    }

    std::vector<double> costs;         ///< by node, sources side by side
    std::vector<std::int64_t> changed; ///< when a walk to the node last became cheaper
    std::vector<std::int64_t> visited; ///< when its incoming edges were last looked at
    std::int64_t now = 1;              ///< turns of nodes so far
};

/// Gives every node a turn. Returns whether any walk became cheaper.
QUADRILLE_SIMD_CLONES
bool sweepWalks(const EdgesTo& edges, WalkBlock& block)
{
    const std::int64_t* const firstOf = edges.firstOf.data();
    const NodeIndex* const sources = edges.sources.data();
    const double* const weights = edges.weights.data();
    double* const costs = block.costs.data();
    std::int64_t* const changed = block.changed.data();
    bool isAnyLowered = false;
    for (std::ptrdiff_t node = 0; node < std::ssize(block.changed); ++node) {
        const std::int64_t visited = block.visited[static_cast<std::size_t>(node)];
        block.visited[static_cast<std::size_t>(node)] = ++block.now;
        double* const own = costs + node * sourcesAtOnce;
        double least[sourcesAtOnce];
        for (NodeIndex s = 0; s < sourcesAtOnce; ++s)
            least[s] = own[s];
        for (std::int64_t e = firstOf[node]; e < firstOf[node + 1]; ++e) {
            if (changed[sources[e]] <= visited)
                continue;
            const double weight = weights[e];
            const double* const toSource = costs + std::ptrdiff_t{sources[e]} * sourcesAtOnce;
#pragma omp simd
            for (NodeIndex s = 0; s < sourcesAtOnce; ++s) {
                const double sum = toSource[s] + weight;
                least[s] = sum < least[s] ? sum : least[s];
            }
        }
        int lowered = 0;
#pragma omp simd reduction(| : lowered)
        for (NodeIndex s = 0; s < sourcesAtOnce; ++s) {
            lowered |= least[s] < own[s];
            own[s] = least[s];
        }
        if (lowered) {
            changed[node] = block.now;
            isAnyLowered = true;
        }
    }
    return isAnyLowered;
}

} // namespace

void forEachWalkRows(const Digraph& graph, const WalkRowsUser& use, const Progress& progress)
{
    const NodeIndex nodes = graph.nodeCount();
    const NodeIndex blocks = (nodes + sourcesAtOnce - 1) / sourcesAtOnce;
    const EdgesTo edges(graph);
    tbb::enumerable_thread_specific<WalkBlock> workspaces(nodes);
    std::atomic<NodeIndex> done = 0;
    tbb::parallel_for(NodeIndex{0}, blocks, [&](NodeIndex b) {
        WalkBlock& block = workspaces.local();
        const NodeIndex first = b * sourcesAtOnce;
        const NodeIndex count = std::min(sourcesAtOnce, nodes - first);
        block.start(first, count);
        do
            progress.report(done, blocks);
        while (sweepWalks(edges, block));
        Table<double> rows(count, nodes);
        for (NodeIndex s = 0; s < count; ++s)
            for (NodeIndex node = 0; node < nodes; ++node)
                rows(s, node) =
                    block.costs[static_cast<std::size_t>(node) * sourcesAtOnce + static_cast<std::size_t>(s)];
        use(first, rows);
        progress.report(++done, blocks);
    });
}

} // namespace quadrille
