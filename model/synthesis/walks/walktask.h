// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/findwalk.h"
#include "model/synthesis/walks/followwalk.h"
#include "model/synthesis/walks/solution.h"

#include <optional>

namespace quadrille {

/// What searches for walks share: the graph with what was decided of its transitions, and where walks may
/// begin. Refers to what it is made from.
struct WalkTask
{
    const WalkMaterial& material;
    const WalkConstraints& constraints;
    const SearchSettings& settings;
    std::vector<double> frameWeights; ///< of each captured frame along a path; empty: as in the graph
    WalkGraph graph;
    std::vector<NodeIndex> starts;
    double beta = 0;

    /// \throws Error as WalkGraph.
    WalkTask(const WalkMaterial& walkMaterial, const WalkConstraints& asked, const SearchSettings& sought);
    WalkTask(const WalkTask&) = delete;
    WalkTask& operator=(const WalkTask&) = delete;
};

/// A task with its path, where it has one, and the order of what is asked. Does not outlive the task.
class WalkCourse
{
public:
    explicit WalkCourse(const WalkTask& task, int leastRun);
    WalkCourse(const WalkCourse&) = delete;
    WalkCourse& operator=(const WalkCourse&) = delete;

    const ConstraintAutomaton& automaton() const { return m_automaton; }
    /// Null without a path.
    PathProblem* path() { return m_along ? &m_along->problem : nullptr; }
    /// For walks that are given.
    FollowedCourse followed();
    WalkSolution solution(const FoundRoute& route);

private:
    struct Along
    {
        PathCourse course;
        PathCosts costs;
        MoveMotions motions;
        PathProblem problem;

        Along(const WalkTask& task, const ConstraintAutomaton& automaton);
    };

    const WalkTask& m_task;
    ConstraintAutomaton m_automaton;
    std::optional<Along> m_along;
};

} // namespace quadrille
