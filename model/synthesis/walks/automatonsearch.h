// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/walks/foundroute.h"

#include <optional>

namespace quadrille {

/// Seeks the cheapest walk that meets keys, actions and required junctions, without a path: A* over frame,
/// stage and, where it matters, output frame. Narrow passes come first, so that there is a walk soon; the
/// last one is exact, and what it finds within the budget is optimal. \return nothing where none was found.
/// \throws Error Cancelled.
std::optional<FoundRoute> searchAutomaton(const WalkGraph& graph, const ConstraintAutomaton& automaton,
                                          const std::vector<NodeIndex>& starts, std::int64_t budget,
                                          const FoundCallback& found, SearchEffort& effort,
                                          const Progress& progress = {});

} // namespace quadrille
