// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/digraph.h"

namespace quadrille {

/// A walk through a graph: each edge begins where the one before it ends.
struct GraphPath
{
    std::vector<Edge> edges; ///< none where the path ends at its own beginning
    double cost = 0;         ///< the sum of their weights
};

/// The cheapest path between two nodes (Dijkstra); nothing where there is none.
std::optional<GraphPath> shortestPath(const Digraph& graph, NodeIndex from, NodeIndex to);

/// Cost of the shortest path between every ordered pair, nodes × nodes; 0 on the diagonal, `unreachable`
/// where there is none.
/// \throws Error Cancelled.
/// Cost: O(nodes³), see cheapestDetours.
Table<double> shortestPathCosts(const Digraph& graph, const Progress& progress = {});

} // namespace quadrille
