// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"

#include "model/graph/shortestpath.h"

#include <algorithm>

namespace quadrille {
namespace {

/// \param whole  the statistics of the graph as it is.
GraphStatistics atEdgeCount(std::int64_t edgeCount, const Digraph& graph, const GraphStatistics& whole,
                            const Progress& progress)
{
    if (whole.edges <= edgeCount)
        return whole;
    const Digraph rest = thinned(graph, edgeCount);
    return graphStatistics(rest, shortestPathCosts(rest, progress));
}

} // namespace

GraphComparison compareGraphs(const TransitionCosts& costs, std::span<const FramePair> minima, double alpha,
                              const Progress& progress)
{
    GraphComparison comparison{.alpha = alpha};
    const EssentialGraph essential = essentialGraph(costs, alpha, progress.part(0, 0.33));
    comparison.essential = graphStatistics(essential.graph, essential.pathCosts);
    const Digraph motion = motionGraph(costs, minima, alpha);
    comparison.motion = graphStatistics(motion, shortestPathCosts(motion, progress.part(0.33, 0.66)));
    const std::int64_t edges = std::min(comparison.essential.edges, comparison.motion.edges);
    const Progress last = progress.part(0.66, 1);
    comparison.essentialAtEqualDensity = atEdgeCount(edges, essential.graph, comparison.essential, last);
    comparison.motionAtEqualDensity = atEdgeCount(edges, motion, comparison.motion, last);
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
