// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/solution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// Fills in what a route means for keys and actions.
class StepAccount
{
public:
    StepAccount(const ConstraintAutomaton& automaton, const WalkConstraints& constraints,
                WalkSolution& solution)
        : m_automaton(automaton), m_constraints(constraints), m_solution(solution)
    {
        m_solution.actions.resize(constraints.actions.size());
    }

    /// A frame that the route comes to. \param arrived  its stage before it was settled.
    void add(const AutomatonState& arrived, const AutomatonState& settled, std::int64_t time)
    {
        m_automaton.settle(arrived, time, m_settled);
        double edges = std::numeric_limits<double>::infinity();
        double timing = 0;
        for (const SettledState& stage : m_settled) {
            if (stage.state == settled && stage.edges + stage.timing < edges + timing) {
                edges = stage.edges;
                timing = stage.timing;
            }
        }
        assert(edges < std::numeric_limits<double>::infinity());
        m_solution.cost.edges += edges;
        m_solution.cost.timing += timing;
        if (settled.key > arrived.key)
            m_solution.keys.push_back({m_constraints.keys[static_cast<std::size_t>(arrived.key)].time, time});
        const bool begins = arrived.span == AutomatonState::free &&
                            (settled.span != AutomatonState::free || settled.step > arrived.step);
        const auto step = static_cast<std::size_t>(arrived.step);
        if (!begins && settled.step == arrived.step)
            return;
        FrameRange& range = m_solution.actions[static_cast<std::size_t>(m_automaton.steps()[step].action)];
        if (begins && range.count() == 0)
            range.first = FrameIndex(time);
        range.last = FrameIndex(time);
    }

private:
    const ConstraintAutomaton& m_automaton;
    const WalkConstraints& m_constraints;
    WalkSolution& m_solution;
    std::vector<SettledState> m_settled;
};

/// Follows a route along the path.
class PathAccount
{
public:
    PathAccount(const PathMeasure& path, const WalkConstraints& constraints, NodeIndex start,
                WalkSolution& solution)
        : m_path(path), m_spans(constraints.path->spans), m_solution(solution)
    {
        m_solution.spans.resize(m_spans.size());
        m_path.costs.begin(m_path.motions, start, m_place, m_charge);
        m_solution.start = m_place.placement;
        m_solution.start.shift /= m_path.course.metresPerUnit();
        m_solution.pathLength = m_path.course.length();
        const Vec3d& point = m_path.motions.point(start);
        const Vec2d ground = m_place.placement(Vec2d(point.head<2>()));
        add({ground.x(), ground.y(), point.z()}, 0, 0);
    }

    void follow(MoveIndex index, std::int64_t time)
    {
        const MoveMotions::Motion& motion = m_path.motions.of(index);
        const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(m_place.placement.turn).toRotationMatrix();
        const double begun = m_place.walked;
        PathFailure failure;
        std::vector<Vec3d> points;
        m_path.costs.follow(motion, rotation, m_place, m_charge, failure, &points);
        for (std::size_t s = 0; s < points.size(); ++s)
            add(points[s], begun + static_cast<double>(motion.steps[s].arcLength), ++time);
    }

    void end()
    {
        m_solution.cost.deviation = m_charge.deviation;
        m_solution.cost.edges += m_charge.edges;
        m_solution.cost.timing += m_charge.timing + m_path.costs.timingAtEnd(m_place);
        m_solution.meanDeviation /= static_cast<double>(m_solution.frameCount);
    }

private:
    void add(const Vec3d& point, double walked, std::int64_t time)
    {
        const double distance = m_path.costs.distance(point, walked);
        m_solution.meanDeviation += distance;
        m_solution.greatestDeviation = std::max(m_solution.greatestDeviation, distance);
        for (std::size_t i = 0; i < m_spans.size(); ++i) {
            if (walked < m_spans[i].from || walked > m_spans[i].to)
                continue;
            FrameRange& range = m_solution.spans[i];
            if (range.count() == 0)
                range.first = FrameIndex(time);
            range.last = FrameIndex(time);
        }
    }

    const PathMeasure& m_path;
    const std::vector<PathSpan>& m_spans;
    WalkSolution& m_solution;
    PathPlace m_place;
    PathCharge m_charge;
};

} // namespace

FrameRange WalkSolution::asked() const
{
    FrameRange all;
    const auto add = [&all](const FrameRange& range) {
        if (range.count() == 0)
            return;
        all = all.count() == 0 ? range
                               : FrameRange{std::min(all.first, range.first), std::max(all.last, range.last)};
    };
    for (const KeyTime& key : keys)
        add({FrameIndex(key.obtained), FrameIndex(key.obtained)});
    for (const FrameRange& action : actions)
        add(action);
    for (const FrameRange& span : spans)
        add(span);
    return all;
}

WalkSolution solutionOf(const WalkGraph& graph, const ConstraintAutomaton& automaton,
                        const WalkConstraints& constraints, const FoundRoute& found, double mu,
                        const PathMeasure* path)
{
    WalkSolution solution{.walk = graph.walk(found.route),
                          .expansions = found.expansions,
                          .optimal = found.optimal,
                          .bound = found.bound};
    StepAccount account(automaton, constraints, solution);
    std::optional<PathAccount> along;
    if (path)
        along.emplace(*path, constraints, found.route.start, solution);
    account.add(automaton.begin(found.route.start), found.states.front(), 0);
    std::int64_t time = 0;
    for (std::size_t m = 0; m < found.route.moves.size(); ++m) {
        const WalkMove& move = graph.move(found.route.moves[m]);
        if (along)
            along->follow(found.route.moves[m], time);
        time += move.elapsed;
        solution.cost.edges += move.weight;
        account.add(automaton.after(found.states[m], move), found.states[m + 1], time);
    }
    solution.frameCount = time + 1;
    if (along)
        along->end();
    solution.totalCost = solution.cost.total(path ? mu : 1);
    return solution;
}

} // namespace quadrille
