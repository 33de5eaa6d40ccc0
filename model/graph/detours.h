// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/table.h"
#include "model/transition/framelayout.h"

#include <span>

namespace quadrille {

/// For every ordered pair of nodes the cost of the cheapest walk that passes through at least one further
/// node: the cheapest way round the edge between them. With it, the smaller of weight and detour is the cost
/// of the shortest path, and an edge is on a shortest path exactly when no detour is as cheap.
/// A walk that takes the edge itself and a round trip is no detour, but where every other is
/// dearer than that, the value may be anything from its cost up to the cheapest other's.
/// Double precision: ties are told apart at 1e-7, and sums of single precision are off by as much.
/// \param weights  nodes × nodes, each ≥ 0 or infinite where there is no edge; the diagonal is not read.
/// \return nodes × nodes, infinite where there is none; the diagonal is the cheapest walk back to the node.
/// \throws Error Cancelled.
/// Cost: O(nodes³) at most, far less for few edges; see lowerDetours.
Table<double> cheapestDetours(const Table<double>& weights, const Progress& progress = {});

/// The same, going on from what is known. Takes what is likely the faster of the two ways below.
/// \param junctions  ascending: every cheapest walk can be cut at some of these nodes into parts that are
/// edges or known detours. All nodes always will do; fewer are faster. \param detours  nodes × nodes, in: the
/// costs of some detours, infinite where none is known; out: the cheapest.
void lowerDetours(const Table<double>& weights, std::span<const NodeIndex> junctions, Table<double>& detours,
                  const Progress& progress = {});

/// The same by a blocked Floyd–Warshall run: O(nodes² · junctions).
void lowerDetoursDensely(const Table<double>& weights, std::span<const NodeIndex> junctions,
                         Table<double>& detours, const Progress& progress = {});

/// The same by relaxing edges in the order of nodes until nothing changes, whatever the junctions:
/// O(nodes · edges) for each time that a cheapest walk goes back in that order.
void lowerDetoursSparsely(const Table<double>& weights, Table<double>& detours,
                          const Progress& progress = {});

} // namespace quadrille
