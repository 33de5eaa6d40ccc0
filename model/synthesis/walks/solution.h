// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/foundroute.h"
#include "model/synthesis/walks/pathcosts.h"
#include "model/synthesis/walks/walksolution.h"

namespace quadrille {

/// The parts of a path that a solution is measured by.
struct PathMeasure
{
    const PathCourse& course;
    const PathCosts& costs;
    MoveMotions& motions;
};

/// Follows a route once more and accounts for it. \param path  null without a path; weights then count 1.
/// \pre The automaton is that of the constraints, and the route keeps to them.
WalkSolution solutionOf(const WalkGraph& graph, const ConstraintAutomaton& automaton,
                        const WalkConstraints& constraints, const FoundRoute& found, double mu,
                        const PathMeasure* path);

} // namespace quadrille
