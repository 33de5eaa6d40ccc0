// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/walks/foundroute.h"
#include "model/synthesis/walks/pathcosts.h"

#include <functional>
#include <optional>

namespace quadrille {

/// All that a search along a path needs.
struct PathProblem
{
    const WalkGraph& graph;
    const ConstraintAutomaton& automaton;
    const PathCourse& course;
    const PathCosts& costs;
    MoveMotions& motions;
    std::vector<NodeIndex> starts;
    double mu = 0.1;
    std::vector<bool> inAir = {}; ///< WalkMaterial::inAir
    /// Makes a walk that was found cheaper before the next pass; empty: as it is.
    std::function<FoundRoute(FoundRoute)> improve = {};
};

/// Seeks the walk of least total cost along a path: states (frame, walked length, offset, heading and what
/// else is asked) are looked at in layers of walked length, in each the most promising first; states that
/// nearly agree are one. Narrow passes come first, so that there is a walk soon; each further pass looks at
/// more states and tells them apart more finely, until the budget is used up.
/// \param failure  where the walks failed that came farthest.
/// \return nothing where none was found.
/// \throws Error Cancelled.
std::optional<FoundRoute> searchPath(PathProblem& problem, std::int64_t budget, const FoundCallback& found,
                                     PathFailure& failure, SearchEffort& effort,
                                     const Progress& progress = {});

} // namespace quadrille
