// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/statistics.h"

#include <cassert>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

/// Sums `value(cost)` over all reachable pairs: rows in parallel, then in their order.
template <typename Value>
double sumOverPairs(const Table<double>& pathCosts, const Value& value)
{
    std::vector<double> sums(static_cast<std::size_t>(pathCosts.rows()), 0.0);
    tbb::parallel_for(Eigen::Index{0}, pathCosts.rows(), [&](Eigen::Index i) {
        double sum = 0;
        for (Eigen::Index j = 0; j < pathCosts.cols(); ++j)
            if (i != j && pathCosts(i, j) < unreachable)
                sum += value(pathCosts(i, j));
        sums[static_cast<std::size_t>(i)] = sum;
    });
    double total = 0;
    for (const double sum : sums)
        total += sum;
    return total;
}

} // namespace

PathCostSummary summarizePathCosts(const Table<double>& pathCosts)
{
    assert(pathCosts.rows() == pathCosts.cols());
    PathCostSummary summary;
    summary.reachablePairs = static_cast<std::int64_t>(sumOverPairs(pathCosts, [](double) { return 1.0; }));
    summary.unreachablePairs = pathCosts.rows() * (pathCosts.rows() - 1) - summary.reachablePairs;
    if (summary.reachablePairs == 0)
        return summary;
    const auto pairs = static_cast<double>(summary.reachablePairs);
    summary.mean = sumOverPairs(pathCosts, [](double cost) { return cost; }) / pairs;
    const double squares =
        sumOverPairs(pathCosts, [mean = summary.mean](double cost) { return (cost - mean) * (cost - mean); });
    summary.standardDeviation = std::sqrt(squares / pairs);
    return summary;
}

GraphStatistics graphStatistics(const Digraph& graph, const Table<double>& pathCosts)
{
    assert(pathCosts.rows() == graph.nodeCount());
    return graphStatistics(graph, summarizePathCosts(pathCosts));
}

GraphStatistics graphStatistics(const Digraph& graph, const PathCostSummary& pathCosts)
{
    return {.nodes = graph.nodeCount(),
            .edges = static_cast<std::int64_t>(graph.edges().size()),
            .transitions = graph.count(EdgeKind::Transition),
            .density = graph.density(),
            .pathCosts = pathCosts,
            .connectivity = connectivity(graph)};
}

} // namespace quadrille
