// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/graph/components.h"

namespace quadrille {

/// The costs of shortest paths between different nodes, as far as there are paths.
struct PathCostSummary
{
    double mean = 0;              ///< over reachable pairs; 0 where there are none
    double standardDeviation = 0; ///< of all of them, not of a sample
    std::int64_t reachablePairs = 0;
    std::int64_t unreachablePairs = 0;
    bool operator==(const PathCostSummary&) const = default;
};

/// \param pathCosts  nodes × nodes, of every ordered pair; `unreachable` where there is no path. The diagonal
///                   does not count.
PathCostSummary summarizePathCosts(const Table<double>& pathCosts);

/// What SMCAS Fig. 9 and a report say about a graph.
struct GraphStatistics
{
    NodeIndex nodes = 0;
    std::int64_t edges = 0;
    std::int64_t transitions = 0; ///< of the edges, those that are synthetic
    double density = 0;           ///< edges / (V(V−1))
    PathCostSummary pathCosts;
    Connectivity connectivity;
};

/// \param pathCosts  of that graph, see shortestPathCosts; the Essential graph brings its own.
GraphStatistics graphStatistics(const Digraph& graph, const Table<double>& pathCosts);
GraphStatistics graphStatistics(const Digraph& graph, const PathCostSummary& pathCosts);

} // namespace quadrille
