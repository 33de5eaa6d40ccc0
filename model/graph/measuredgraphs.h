// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/motiongraph.h"
#include "model/graph/statistics.h"
#include "model/graph/transitioncosts.h"

#include <functional>
#include <memory>
#include <vector>

namespace quadrille {

/// Both graphs of a character at one α.
struct GraphPair
{
    double alpha = 0;
    std::shared_ptr<const std::vector<FramePair>> minima; ///< transitions of the motion graph
    Digraph essential;
    Digraph motion;
    bool isWhole = true; ///< else `essential` has the edges only that are certain so far
};

/// Takes both graphs as they become known.
using GraphsTaker = std::function<void(std::shared_ptr<const GraphPair>)>;

/// The edges of both. \param minima  of costMinima. \param first  receives the motion graph with what is
/// certain of the other, long before the rest is; may be empty. \throws Error, cost: as essentialEdges.
GraphPair graphsAt(const TransitionCosts& costs, std::shared_ptr<const std::vector<FramePair>> minima,
                   double alpha, const Progress& progress = {}, const GraphsTaker& first = {});

/// What takes longer to know of them.
struct MeasuredGraphs
{
    std::shared_ptr<const GraphPair> graphs;
    GraphStatistics essential;
    GraphStatistics motion;
};

/// \throws Error, cost: as measuredPathCosts.
MeasuredGraphs measured(std::shared_ptr<const GraphPair> graphs, const Progress& progress = {});

/// What the shortest paths of a graph of any size cost, without a table of all pairs; see forEachWalkRows.
/// \throws Error Cancelled.
PathCostSummary measuredPathCosts(const Digraph& graph, const Progress& progress = {});

} // namespace quadrille
