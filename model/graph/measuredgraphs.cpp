// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/measuredgraphs.h"

#include "model/graph/essentialedges.h"
#include "model/graph/walkrows.h"

#include <cmath>
#include <utility>

namespace quadrille {
namespace {

/// Of the paths from one frame.
struct RowCosts
{
    std::int64_t paths = 0;
    double mean = 0;
    double squares = 0; ///< of the differences to the mean, summed up
};

RowCosts rowCosts(const Table<double>& costs, Eigen::Index row, Eigen::Index own)
{
    RowCosts result;
    double sum = 0;
    for (Eigen::Index j = 0; j < costs.cols(); ++j) {
        if (j != own && costs(row, j) < unreachable) {
            sum += costs(row, j);
            ++result.paths;
        }
    }
    if (result.paths == 0)
        return result;
    result.mean = sum / static_cast<double>(result.paths);
    for (Eigen::Index j = 0; j < costs.cols(); ++j) {
        const double apart = costs(row, j) - result.mean;
        if (j != own && costs(row, j) < unreachable)
            result.squares += apart * apart;
    }
    return result;
}

PathCostSummary summaryOf(const std::vector<RowCosts>& rows)
{
    PathCostSummary summary;
    double sum = 0;
    for (const RowCosts& row : rows) {
        summary.reachablePairs += row.paths;
        sum += row.mean * static_cast<double>(row.paths);
    }
    const auto count = std::ssize(rows);
    summary.unreachablePairs = count * (count - 1) - summary.reachablePairs;
    if (summary.reachablePairs == 0)
        return summary;
    const auto pairs = static_cast<double>(summary.reachablePairs);
    summary.mean = sum / pairs;
    double squares = 0;
    for (const RowCosts& row : rows)
        squares += row.squares +
                   static_cast<double>(row.paths) * (row.mean - summary.mean) * (row.mean - summary.mean);
    summary.standardDeviation = std::sqrt(squares / pairs);
    return summary;
}

} // namespace

GraphPair graphsAt(const TransitionCosts& costs, std::shared_ptr<const std::vector<FramePair>> minima,
                   double alpha, const Progress& progress, const GraphsTaker& first)
{
    GraphPair graphs{.alpha = alpha, .minima = std::move(minima)};
    graphs.motion = motionGraph(costs, *graphs.minima, alpha);
    std::function<void(Digraph)> certain;
    if (first)
        certain = [&](Digraph edges) {
            auto begun = std::make_shared<GraphPair>(graphs);
            begun->essential = std::move(edges);
            begun->isWhole = false;
            first(std::move(begun));
        };
    graphs.essential = essentialEdges(costs, alpha, progress, certain);
    return graphs;
}

MeasuredGraphs measured(std::shared_ptr<const GraphPair> graphs, const Progress& progress)
{
    MeasuredGraphs result;
    result.essential =
        graphStatistics(graphs->essential, measuredPathCosts(graphs->essential, progress.part(0, 0.5)));
    result.motion = graphStatistics(graphs->motion, measuredPathCosts(graphs->motion, progress.part(0.5, 1)));
    result.graphs = std::move(graphs);
    return result;
}

PathCostSummary measuredPathCosts(const Digraph& graph, const Progress& progress)
{
    std::vector<RowCosts> rows(static_cast<std::size_t>(graph.nodeCount()));
    forEachWalkRows(
        graph,
        [&](NodeIndex first, const Table<double>& costs) {
            for (Eigen::Index r = 0; r < costs.rows(); ++r)
                rows[static_cast<std::size_t>(first + r)] = rowCosts(costs, r, first + r);
        },
        progress);
    return summaryOf(rows);
}

} // namespace quadrille
