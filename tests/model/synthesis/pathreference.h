// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/pathsearch.h"

#include <functional>

namespace quadrille::test {

/// Depth-first branch and bound along a path, as SMCAS §4.3 has it; stages are those of constraints without
/// anything but the path. `isOver` is asked at every state and ends the search.
class BranchAndBound
{
public:
    using IsOver = std::function<bool()>;

    BranchAndBound(PathProblem& problem, IsOver isOver) : m_problem(problem), m_isOver(std::move(isOver)) {}

    /// The least cost of all walks, exact unless ended; `unreachable` where there is none.
    double exact();
    /// From one start: looks so many frames ahead, goes the best way, looks again; twice as far where there
    /// is no way.
    double incremental(NodeIndex start, std::int32_t lookAhead);
    /// The best that incremental search finds from all starts, those first that look best at first.
    double incrementalFromAll(std::int32_t lookAhead);
    std::int64_t expansions() const { return m_expansions; }

private:
    struct State
    {
        NodeIndex node = 0;
        PathPlace place;
        double cost = 0;
    };
    std::optional<State> begin(NodeIndex node) const;
    std::optional<State> moved(const State& from, MoveIndex move);
    bool isEnd(const State& state) const { return state.place.walked >= m_problem.course.length(); }
    /// Whether a transition leaves the frame or one behind it.
    bool leadsOn(NodeIndex node) const;
    void descend(const State& state, std::int32_t framesLeft);

    PathProblem& m_problem;
    IsOver m_isOver;
    double m_best = unreachable;
    std::optional<State> m_bestEnd;
    std::int64_t m_expansions = 0;
};

} // namespace quadrille::test
