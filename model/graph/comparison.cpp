// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"

#include "model/graph/shortestpath.h"

#include <algorithm>

namespace quadrille {
namespace {

struct Measured
{
    Digraph graph;
    Table<double> pathCosts;
};

/// The graph with no more than some edges.
Measured withEdges(std::int64_t edgeCount, Measured whole, const Progress& progress)
{
    if (std::ssize(whole.graph.edges()) <= edgeCount)
        return whole;
    Measured rest{.graph = thinned(whole.graph, edgeCount)};
    rest.pathCosts = shortestPathCosts(rest.graph, progress);
    return rest;
}

/// Forgets the costs of pairs that the other table has no path for.
Table<double> overPairsOf(const Table<double>& other, const Table<double>& pathCosts)
{
    return (other < unreachable).select(pathCosts, unreachable);
}

} // namespace

GraphComparison compareGraphs(const TransitionCosts& costs, std::span<const FramePair> minima, double alpha,
                              const Progress& progress)
{
    GraphComparison comparison{.alpha = alpha};
    EssentialGraph complete = essentialGraph(costs, alpha, progress.part(0, 0.33));
    Measured essential{std::move(complete.graph), std::move(complete.pathCosts)};
    comparison.essential = graphStatistics(essential.graph, essential.pathCosts);
    Measured motion{.graph = motionGraph(costs, minima, alpha)};
    motion.pathCosts = shortestPathCosts(motion.graph, progress.part(0.33, 0.66));
    comparison.motion = graphStatistics(motion.graph, motion.pathCosts);

    const std::int64_t edges = std::min(comparison.essential.edges, comparison.motion.edges);
    essential = withEdges(edges, std::move(essential), progress.part(0.66, 1));
    motion = withEdges(edges, std::move(motion), progress.part(0.66, 1));
    comparison.essentialAtEqualDensity = graphStatistics(essential.graph, essential.pathCosts);
    comparison.motionAtEqualDensity = graphStatistics(motion.graph, motion.pathCosts);
    const PathCostSummary ofEssential =
        summarizePathCosts(overPairsOf(motion.pathCosts, essential.pathCosts));
    const PathCostSummary ofMotion = summarizePathCosts(overPairsOf(essential.pathCosts, motion.pathCosts));
    comparison.commonPairs = ofMotion.reachablePairs;
    comparison.essentialMeanOverCommonPairs = ofEssential.mean;
    comparison.motionMeanOverCommonPairs = ofMotion.mean;
    progress.report(1);
    return comparison;
}

std::vector<GraphComparison> sweepAlpha(const TransitionCosts& costs, std::span<const FramePair> minima,
                                        std::span<const double> alphas, const Progress& progress)
{
    std::vector<GraphComparison> rows;
    const auto count = static_cast<double>(alphas.size());
    for (const double alpha : alphas) {
        const auto done = static_cast<double>(rows.size());
        rows.push_back(compareGraphs(costs, minima, alpha, progress.part(done / count, (done + 1) / count)));
    }
    return rows;
}

} // namespace quadrille
