// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/measuredgraph.h"

#include "model/graph/essentialedges.h"
#include "model/graph/essentialgraph.h"
#include "model/graph/shortestpath.h"
#include "model/graph/walkrows.h"

#include <cmath>

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

MeasuredGraph measuredEssentialGraph(const TransitionCosts& costs, double alpha, const Progress& progress,
                                     NodeIndex tabledFrames)
{
    if (costs.layout().frameCount() <= tabledFrames) {
        EssentialGraph essential = essentialGraph(costs, alpha, progress);
        return {.graph = std::move(essential.graph), .pathCosts = summarizePathCosts(essential.pathCosts)};
    }
    MeasuredGraph measured{.graph = essentialEdges(costs, alpha, progress.part(0, 0.3))};
    measured.pathCosts = measuredPathCosts(measured.graph, progress.part(0.3, 1), tabledFrames);
    return measured;
}

PathCostSummary measuredPathCosts(const Digraph& graph, const Progress& progress, NodeIndex tabledFrames)
{
    if (graph.nodeCount() <= tabledFrames)
        return summarizePathCosts(shortestPathCosts(graph, progress));
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
