// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/table.h"
#include "model/graph/digraph.h"

#include <functional>

namespace quadrille {

/// Receives the costs of the shortest paths from some sources in a row, of which the first is named, to every
/// node: sources × nodes; 0 to itself, `unreachable` where there is none.
using WalkRowsUser = std::function<void(NodeIndex first, const Table<double>& costs)>;

/// The rows of shortestPathCosts, some at a time and in no order, for those who need each only once. A table
/// of all of them takes 800 MB for 10,000 nodes; this takes 3 MB for each thread then, and 12 bytes for each
/// edge. \param use  called from several threads at once. \throws Error Cancelled; what `use` throws.
/// Cost: O(nodes · edges) for each time that a cheapest path goes back in the order of nodes.
void forEachWalkRows(const Digraph& graph, const WalkRowsUser& use, const Progress& progress = {});

} // namespace quadrille
