// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/pathsearch.h"

#include <optional>

namespace quadrille {

/// What walks are followed by.
struct FollowedCourse
{
    const WalkGraph& graph;
    const ConstraintAutomaton& automaton;
    const PathProblem* path;              ///< null without a path
    const std::vector<NodeIndex>& starts; ///< where a walk may begin, ascending
    /// Whether it may begin behind the first frame of its first span, too.
    bool beginsLater = false;
};

/// The cheapest way to meet what is asked with a walk that is given. It ends in its last span, where all is
/// met; along a path it ends where that does, and a last span that is too short for it goes on as captured.
/// \return nothing where the walk does not meet what is asked, or uses a transition that the graph lacks.
/// \param limit  above which a walk does not count. Walks may be followed at the same time when the motions
/// of their transitions are prepared. Cost: O(frames · states).
std::optional<FoundRoute> followWalk(const FollowedCourse& course, const Walk& walk,
                                     double limit = unreachable);

} // namespace quadrille
