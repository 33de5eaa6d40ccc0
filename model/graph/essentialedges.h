// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/transitioncosts.h"

#include <functional>

namespace quadrille {

/// The graph of essentialGraph without the costs of its paths, and without tables of all pairs of frames:
/// some sources at a time, each as far as its dearest edge. The same edges, but for those whose cheapest
/// detour is nearer to 1e-7 of their weight than sums of double precision are exact. \param alpha  ≥ 0.
/// \throws Error BadArgument (α), Cancelled. Cost: O(frames²), and for each frame the edges that it comes to
/// for less than its own dearest one weighs. Memory: 24 bytes for each edge that plain playing on does not
/// replace, 1 KB for each frame for each thread.
/// \param certain  receives, once and from this thread, the edges that belong to the graph whatever walks may
/// be found: they are known after a twentieth of the time. May be empty.
Digraph essentialEdges(const TransitionCosts& costs, double alpha, const Progress& progress = {},
                       const std::function<void(Digraph)>& certain = {});

} // namespace quadrille
