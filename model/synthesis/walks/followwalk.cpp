// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/followwalk.h"

#include <algorithm>
#include <unordered_map>

namespace quadrille {

namespace {

constexpr double rounding = 1e-9; ///< of costs

struct FollowedState
{
    AutomatonState stage;
    std::int32_t time = 0;
    std::int32_t parent = -1;
    MoveIndex move = noMove;
    double cost = 0; ///< of edges and timing
};

/// Goes along a walk with all that its frames can be.
class Follower
{
public:
    Follower(const FollowedCourse& course, const Walk& walk, double limit)
        : m_course(course), m_walk(walk), m_limit(limit)
    {
    }

    std::optional<FoundRoute> run()
    {
        NodeIndex node = m_walk.spans.front().first;
        if (m_course.path != nullptr &&
            !m_course.path->costs.begin(m_course.path->motions, node, m_place, m_charge))
            return std::nullopt;
        begin(node);
        for (std::size_t span = 0; !isAtEnd(node);) {
            const bool isLast = span + 1 == m_walk.spans.size();
            if (isLast && m_course.path == nullptr)
                endHere();
            const bool leaves = node == m_walk.spans[span].last && !isLast;
            if (!leaves && !playsOn(node, m_walk.spans[span], isLast))
                return std::move(m_best);
            span += leaves ? 1 : 0;
            const NodeIndex next = leaves ? m_walk.spans[span].first : node + 1;
            const MoveIndex move =
                leaves ? m_course.graph.transition({node, next}) : m_course.graph.playedOn(node);
            if (move == noMove || !follow(move) || isTooMuch())
                return std::nullopt;
            node = next;
            if (span == 0 && m_course.beginsLater)
                begin(node);
        }
        endHere();
        return std::move(m_best);
    }

private:
    bool isAtEnd(NodeIndex node) const
    {
        const PathProblem* path = m_course.path;
        return path != nullptr && m_place.walked >= path->course.length() &&
               (path->inAir.empty() || !path->inAir[static_cast<std::size_t>(node)]);
    }

    bool playsOn(NodeIndex node, const WalkSpan& span, bool isLast) const
    {
        const FrameLayout& layout = m_course.graph.layout();
        return node < span.last ||
               (isLast && m_course.path != nullptr && node < layout.lastOf(layout.sequenceOf(node)));
    }

    bool isTooMuch() const { return m_charge.total(mu()) + (m_course.beginsLater ? 0 : m_least) >= m_limit; }

    double mu() const { return m_course.path != nullptr ? m_course.path->mu : 1; }

    void begin(NodeIndex node)
    {
        if (!std::ranges::binary_search(m_course.starts, node))
            return;
        m_course.automaton.settle(m_course.automaton.begin(node), 0, m_settled);
        for (const SettledState& settled : m_settled)
            offer({.stage = settled.state, .cost = mu() * settled.edges + settled.timing});
    }

    /// \return whether the walk may go there.
    bool follow(MoveIndex index)
    {
        const WalkMove& move = m_course.graph.move(index);
        if (m_course.path != nullptr) {
            const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(m_place.placement.turn).toRotationMatrix();
            PathFailure failure;
            if (!m_course.path->costs.follow(m_course.path->motions.of(index), rotation, m_place, m_charge,
                                             failure))
                return false;
        }
        const std::size_t first = m_front;
        m_front = m_seen.size();
        m_least = unreachable;
        if (!m_known.empty())
            m_known.clear();
        for (std::size_t parent = first; parent < m_front; ++parent) {
            const FollowedState from = m_seen[parent];
            if (!m_course.automaton.allows(from.stage, move))
                continue;
            const std::int32_t time = from.time + move.elapsed;
            m_course.automaton.settle(m_course.automaton.after(from.stage, move), time, m_settled);
            for (const SettledState& settled : m_settled)
                offer({.stage = settled.state,
                       .time = time,
                       .parent = static_cast<std::int32_t>(parent),
                       .move = index,
                       .cost = from.cost + mu() * (move.weight + settled.edges) + settled.timing});
        }
        return m_course.beginsLater || m_front < m_seen.size();
    }

    void offer(const FollowedState& state)
    {
        m_least = std::min(m_least, state.cost);
        if (m_seen.size() == m_front) { // mostly there is but one
            m_seen.push_back(state);
            return;
        }
        if (m_known.empty())
            m_known.emplace(futureOf(m_seen[m_front]), m_front);
        const auto [known, isNew] = m_known.try_emplace(futureOf(state), m_seen.size());
        if (isNew)
            m_seen.push_back(state);
        // Of two alike the walk that begins earlier stays.
        else if (state.cost < m_seen[known->second].cost - rounding)
            m_seen[known->second] = state;
    }

    AutomatonFuture futureOf(const FollowedState& state) const
    {
        return m_course.automaton.future(state.stage, state.time);
    }

    void endHere()
    {
        const double path =
            m_charge.total(mu()) + (m_course.path != nullptr ? m_course.path->costs.timingAtEnd(m_place) : 0);
        for (std::size_t i = m_front; i < m_seen.size(); ++i) {
            const double cost = m_seen[i].cost + path;
            if (m_course.automaton.isDone(m_seen[i].stage) && cost < (m_best ? m_best->cost : m_limit))
                m_best = routeTo(m_seen[i], m_seen, cost);
        }
    }

    const FollowedCourse& m_course;
    const Walk& m_walk;
    double m_limit;
    PathPlace m_place;
    PathCharge m_charge;
    std::vector<FollowedState> m_seen;
    double m_least = unreachable; ///< cost of the states at the frame that the walk has come to
    std::size_t m_front = 0;      ///< the first of the states at the frame that the walk has come to
    std::unordered_map<AutomatonFuture, std::size_t, AutomatonFutureHash> m_known; ///< of them
    std::vector<SettledState> m_settled;
    std::optional<FoundRoute> m_best;
};

} // namespace

std::optional<FoundRoute> followWalk(const FollowedCourse& course, const Walk& walk, double limit)
{
    return Follower(course, walk, limit).run();
}

} // namespace quadrille
