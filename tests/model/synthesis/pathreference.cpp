// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/synthesis/pathreference.h"

#include <algorithm>

namespace quadrille::test {

std::optional<BranchAndBound::State> BranchAndBound::begin(NodeIndex node) const
{
    State state{.node = node};
    PathCharge charge;
    if (!m_problem.costs.begin(m_problem.motions, node, state.place, charge))
        return std::nullopt;
    state.cost = charge.total(m_problem.mu);
    return state;
}

std::optional<BranchAndBound::State> BranchAndBound::moved(const State& from, MoveIndex move)
{
    State next = from;
    PathCharge charge;
    PathFailure failure;
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(from.place.placement.turn).toRotationMatrix();
    if (!m_problem.costs.follow(m_problem.motions.of(move), rotation, next.place, charge, failure))
        return std::nullopt;
    next.node = m_problem.graph.move(move).to;
    next.cost += charge.total(m_problem.mu) + m_problem.mu * m_problem.graph.move(move).weight;
    if (isEnd(next))
        next.cost += m_problem.costs.timingAtEnd(next.place);
    return next;
}

bool BranchAndBound::leadsOn(NodeIndex node) const
{
    const FrameLayout& layout = m_problem.graph.layout();
    for (NodeIndex last = layout.lastOf(layout.sequenceOf(node)); node <= last; ++node) {
        const auto [begin, end] = m_problem.graph.from(node);
        if (end - begin > 1)
            return true;
    }
    return false;
}

void BranchAndBound::descend(const State& state, std::int32_t framesLeft)
{
    if (state.cost >= m_best || m_isOver())
        return;
    if (!isEnd(state) && framesLeft <= 0 && !leadsOn(state.node))
        return;
    if (isEnd(state) || framesLeft <= 0) {
        m_best = state.cost;
        m_bestEnd = state;
        return;
    }
    ++m_expansions;
    const auto [begin, end] = m_problem.graph.from(state.node);
    for (MoveIndex index = begin; index < end; ++index) {
        const WalkMove& move = m_problem.graph.move(index);
        if (state.cost + m_problem.mu * move.weight >= m_best)
            break; // they come the lightest first
        if (const std::optional<State> next = moved(state, index))
            descend(*next, framesLeft - move.elapsed);
    }
}

double BranchAndBound::exact()
{
    m_best = unreachable;
    for (const NodeIndex node : m_problem.starts) {
        if (const std::optional<State> state = begin(node))
            descend(*state, std::numeric_limits<std::int32_t>::max());
    }
    return m_best;
}

double BranchAndBound::incremental(NodeIndex start, std::int32_t lookAhead)
{
    constexpr std::int32_t farthest = 4;
    std::optional<State> state = begin(start);
    std::int32_t factor = 1;
    while (state && !isEnd(*state)) {
        m_best = unreachable;
        m_bestEnd.reset();
        descend(*state, factor * lookAhead);
        if (!m_bestEnd && factor == farthest)
            return unreachable;
        factor = m_bestEnd ? 1 : 2 * factor;
        state = m_bestEnd ? m_bestEnd : state;
        if (m_isOver())
            return unreachable;
    }
    return state ? state->cost : unreachable;
}

double BranchAndBound::incrementalFromAll(std::int32_t lookAhead)
{
    std::vector<std::pair<double, NodeIndex>> starts;
    for (const NodeIndex node : m_problem.starts) {
        m_best = unreachable;
        if (const std::optional<State> state = begin(node))
            descend(*state, lookAhead / 2);
        if (m_best < unreachable)
            starts.emplace_back(m_best, node);
    }
    std::sort(starts.begin(), starts.end());
    double best = unreachable;
    for (const auto& [outlook, node] : starts)
        best = std::min(best, incremental(node, lookAhead));
    return best;
}

} // namespace quadrille::test
