// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/transitioncosts.h"

namespace quadrille {

/// The Essential graph and what comes with it.
struct EssentialGraph
{
    Digraph graph;
    /// Cost of the shortest path between every ordered pair, frames × frames, in the complete digraph and, by
    /// construction, in `graph`; 0 on the diagonal, `unreachable` where there is no walk.
    Table<double> pathCosts;
};

/// The edges of the complete digraph (see completeWeights) that lie on shortest paths (SMCAS §4.1.1): the
/// edge (i, j) goes when some k ∉ {i, j} has dist(i,k) + dist(k,j) ≤ E(i,j)·(1 + 1e-7), so that on a tie the
/// longer walk wins. Original edges stay. Distances are kept, up to that factor. Where round trips are nearly
/// free (α = 0, or within 1e-3 of an edge's weight), edges that tie stand in for each other: they are taken
/// away one after the other, in the order of frames, as long as another way as cheap is left.
/// \param alpha  ≥ 0; the paper's default is 0.01.
/// \throws Error BadArgument (α), Cancelled.
/// Cost: O(frames³), see cheapestDetours.
EssentialGraph essentialGraph(const TransitionCosts& costs, double alpha, const Progress& progress = {});

} // namespace quadrille
