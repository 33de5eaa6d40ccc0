// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/transitioncosts.h"
#include "model/transition/framepair.h"

namespace quadrille {

/// What the minima of a motion graph are looked for in: D as it is (the paper's), or its mean over the finite
/// cells of a square around each cell, inside the block of its two sequences.
enum class CostSmoothing
{
    None,
    Mean3, ///< 3×3
    Mean5, ///< 5×5
};

/// The transitions of a motion graph (Kovar et al. 2002, as compared in SMCAS §4.1): for every ordered pair
/// of sequences, a sequence with itself included, the strict local minima of D over the 8 neighbours; cells
/// outside the pair's block and infinite ones count as larger. No threshold. They do not depend on α.
/// \return sorted by source, then destination.
/// \throws Error Cancelled.
std::vector<FramePair> costMinima(const TransitionCosts& costs, CostSmoothing smoothing = CostSmoothing::None,
                                  const Progress& progress = {});

/// The motion graph: the original edges, and those transitions that `costMinima` gave, with the weights of
/// the Essential graph but without its rule for one sequence. An original edge stands for a transition beside
/// it.
/// \throws Error BadArgument (α).
Digraph motionGraph(const TransitionCosts& costs, std::span<const FramePair> minima, double alpha);

} // namespace quadrille
