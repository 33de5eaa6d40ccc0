// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/statistics.h"
#include "model/graph/transitioncosts.h"

namespace quadrille {

/// Up to so many frames, costs of all pairs are kept in tables; for more, some rows at a time.
inline constexpr NodeIndex mostTabledFrames = 3000;

/// A graph with what its shortest paths cost.
struct MeasuredGraph
{
    Digraph graph;
    PathCostSummary pathCosts;
};

/// The Essential graph of a character of any size. \param tabledFrames  beyond so many, without tables.
/// \throws Error as essentialGraph. Cost: see there, essentialEdges and forEachWalkRows.
MeasuredGraph measuredEssentialGraph(const TransitionCosts& costs, double alpha,
                                     const Progress& progress = {},
                                     NodeIndex tabledFrames = mostTabledFrames);

/// What the shortest paths of a graph of any size cost; see shortestPathCosts and forEachWalkRows.
/// \throws Error Cancelled.
PathCostSummary measuredPathCosts(const Digraph& graph, const Progress& progress = {},
                                  NodeIndex tabledFrames = mostTabledFrames);

} // namespace quadrille
