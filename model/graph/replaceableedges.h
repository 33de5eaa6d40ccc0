// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/digraph.h"

#include <vector>

namespace quadrille {

/// How near to an edge's weight another walk counts as just as cheap, of the weight.
inline constexpr double edgeTie = 1e-7;
/// Two edges can stand in for each other only where a round trip costs no more than the tolerance of their
/// ties; a chain of edges, that many times as much.
inline constexpr double nearlyFreeTrip = 1e-3;

/// Takes edges away one after the other as long as what is left holds another walk between their ends that is
/// as cheap. \param doubtful  positions of the edges that may go, in the order in which they are tried.
/// \throws Error Cancelled.
Digraph withoutReplaceable(const Digraph& graph, const std::vector<std::size_t>& doubtful,
                           const Progress& progress = {});

} // namespace quadrille
