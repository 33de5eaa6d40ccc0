// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/edgecosts.h"

#include "model/synthesis/clips/walk.h"

#include <algorithm>
#include <atomic>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// What some source frames differ in from all frames.
class StepRows
{
public:
    StepRows(const EdgePaths& paths, NodeIndex first, NodeIndex last)
        : m_first(first), m_steps(paths.distances.middleRows(first, last - first + 1))
    {
        for (NodeIndex i = first; i <= last; ++i)
            for (NodeIndex j = 0; j < paths.layout.frameCount(); ++j)
                m_steps(i - first, j) = paths.differences.step(m_steps(i - first, j), paths.weights, i, j);
    }

    const float& at(NodeIndex i, NodeIndex j) const { return m_steps(i - m_first, j); }

private:
    NodeIndex m_first;
    Table<float> m_steps;
};

void splitCostsFrom(NodeIndex first, NodeIndex last, const std::vector<const Digraph*>& graphs,
                    const EdgePaths& paths, std::vector<std::vector<EdgeCost>>& costs)
{
    const NodeIndex end = paths.layout.lastOf(paths.layout.sequenceOf(last));
    const StepRows rows(paths, first, std::min(last + paths.settings.longest() - 1, end));
    const WarpPaths warps(
        [&rows](NodeIndex source, NodeIndex destination, std::span<float> row) {
            std::copy_n(&rows.at(source, destination), row.size(), row.begin());
        },
        paths.greatestStep, paths.layout, paths.settings);
    const CostSplit::StepOf step = [&rows](NodeIndex i, NodeIndex j) { return rows.at(i, j); };
    const CostSplit split{.distances = paths.distances,
                          .step = step,
                          .stances = paths.stances,
                          .contactWeight = paths.weights.contacts};
    for (std::size_t g = 0; g < graphs.size(); ++g) {
        const Edge* const edges = graphs[g]->edges().data();
        for (NodeIndex node = first; node <= last; ++node) {
            for (const Edge& edge : graphs[g]->edgesFrom(node)) {
                if (edge.kind == EdgeKind::Original)
                    continue;
                const auto e = static_cast<std::size_t>(&edge - edges);
                const EdgePaths::Known known = paths.known(g, e);
                const FramePair pair{.source = edge.from, .destination = edge.to};
                if (const auto transition = warps.of(known.transition, pair))
                    costs[g][e].parts = split.of(*transition, known.drift, costs[g][e].cost);
            }
        }
    }
}

} // namespace

std::vector<EdgeCost> costsOfEdges(const Digraph& graph, const TransitionCosts& costs)
{
    std::vector<EdgeCost> all;
    all.reserve(graph.edges().size());
    for (const Edge& edge : graph.edges())
        all.push_back(edge.kind == EdgeKind::Original
                          ? EdgeCost()
                          : EdgeCost{.cost = costs.cost()(edge.from, edge.to),
                                     .length = costs.length()(edge.from, edge.to)});
    return all;
}

void splitCosts(const std::vector<const Digraph*>& graphs, const EdgePaths& paths,
                std::vector<std::vector<EdgeCost>>& costs, const Progress& progress)
{
    // Of one sequence each, and a few times as many as the frames after them that their windows reach.
    constexpr NodeIndex most = 192;
    std::vector<WalkSpan> tasks;
    for (int s = 0; s < paths.layout.sequenceCount(); ++s)
        for (NodeIndex first = paths.layout.firstOf(s); first <= paths.layout.lastOf(s); first += most)
            tasks.push_back({first, std::min(first + most - 1, paths.layout.lastOf(s))});
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t task) {
        splitCostsFrom(tasks[task].first, tasks[task].last, graphs, paths, costs);
        progress.report(++done, std::ssize(tasks));
    });
}

} // namespace quadrille
