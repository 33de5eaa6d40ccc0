// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathsearch.h"

#include "model/synthesis/walks/beamlayers.h"
#include "model/synthesis/walks/fingerprints.h"
#include "model/synthesis/walks/pathoutlook.h"
#include "model/synthesis/walks/searchmemory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille {

namespace {

constexpr double layerLength = 0.1;   ///< metres
constexpr double finestOffset = 0.02; ///< metres that two states may differ by to be one, at last
/// How much of the outlook counts: between the few ways that it knows it is too dark.
constexpr double outlookShare = 0.6;

/// How much one pass looks at.
struct PassSettings
{
    std::int64_t width = 0; ///< states looked at in a layer
    MoveIndex moves = 0;    ///< the lightest ones of a frame
    double offset = 0;      ///< metres that two states may differ by to be one
    double heading = 0;     ///< radians
};

struct Candidate
{
    AutomatonState stage;
    PathPlace place;
    std::int32_t time = 0;
    std::int32_t parent = -1; ///< among the states that were looked at
    MoveIndex move = noMove;
    double cost = 0;
    double rank = 0; ///< lower is more promising
    std::uint32_t order = 0;
};

class PathPass
{
public:
    PathPass(PathProblem& problem, const PathOutlook& outlook, const PassSettings& settings, double limit,
             PathFailure& failure)
        : m_problem(problem), m_outlook(outlook), m_settings(settings), m_limit(limit), m_failure(failure)
    {
    }

    /// \param budget  what is used is taken from it.
    std::optional<FoundRoute> run(std::int64_t& budget, const Progress& progress)
    {
        m_isComplete = true;
        begin();
        followRuns();
        for (std::size_t l = 0; l < m_layers.size() && budget > 0 && hasMemory(); ++l) {
            for (std::int64_t taken = 0;
                 taken < m_layers[l].width(m_settings.width) && budget > 0 && hasMemory();) {
                const std::optional<Candidate> next = m_layers[l].take();
                if (!next)
                    break;
                if (next->cost >= m_limit || m_known.isWorse(fingerprint(*next), next->cost))
                    continue;
                ++taken;
                --budget;
                if (budget % 256 == 0)
                    progress.report(0);
                expand(*next);
                followRuns();
            }
            m_isComplete = m_isComplete && !m_layers[l].take();
            m_layers[l] = {};
        }
        m_isComplete = m_isComplete && budget > 0 && hasMemory();
        return std::move(m_found);
    }

    /// Whether run has looked at every state that it came to.
    bool isComplete() const { return m_isComplete; }

private:
    bool hasMemory() const { return m_seen.size() < mostVisits && m_known.count() < mostKnownStates; }

    void begin()
    {
        m_layers.resize(static_cast<std::size_t>(m_problem.course.length() / layerLength) + 1);
        std::vector<SettledState> settled;
        for (const NodeIndex node : m_problem.starts) {
            Candidate first;
            PathCharge charge;
            if (!m_problem.costs.begin(m_problem.motions, node, first.place, charge))
                continue;
            m_problem.automaton.settle(m_problem.automaton.begin(node), 0, settled);
            for (const SettledState& stage : settled) {
                first.stage = stage.state;
                first.cost = charge.total(m_problem.mu) + m_problem.mu * stage.edges + stage.timing;
                offer(first);
            }
        }
    }

    /// Plays on from states that cannot do anything else yet: there is nothing to choose, and nothing to
    /// count.
    void followRuns()
    {
        while (!m_running.empty()) {
            const Candidate next = m_running.back();
            m_running.pop_back();
            m_seen.resize(std::max(m_kept, static_cast<std::size_t>(next.parent + 1)));
            expand(next);
        }
        m_seen.resize(m_kept);
    }

    /// \return the moves, [begin, end), that a state may make.
    std::pair<MoveIndex, MoveIndex> movesOf(const AutomatonState& stage) const
    {
        if (m_problem.automaton.hasRun(stage) || m_problem.graph.hasRequired())
            return m_problem.graph.from(stage.node);
        const MoveIndex next = m_problem.graph.playedOn(stage.node);
        return {next, next == noMove ? noMove : next + 1};
    }

    void expand(const Candidate& from)
    {
        const auto parent = static_cast<std::int32_t>(m_seen.size());
        m_seen.push_back(from);
        const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(from.place.placement.turn).toRotationMatrix();
        const auto [begin, end] = movesOf(from.stage);
        if (m_problem.automaton.hasRun(from.stage))
            m_problem.motions.prepare(begin, std::min(end, begin + m_settings.moves));
        for (MoveIndex index = begin; index < end; ++index) {
            const WalkMove& move = m_problem.graph.move(index);
            if (!m_problem.automaton.allows(from.stage, move))
                continue;
            if (index - begin >= m_settings.moves && move.required < 0) {
                m_isComplete = false;
                continue;
            }
            double cost = from.cost + m_problem.mu * move.weight;
            if (cost >= m_limit)
                break;
            if (move.kind == EdgeKind::Transition && !isPromising(from, index, cost)) {
                m_isComplete = false;
                continue;
            }
            Candidate next;
            next.place = from.place;
            PathCharge charge;
            if (!m_problem.costs.follow(m_problem.motions.of(index), rotation, next.place, charge, m_failure))
                continue;
            cost += charge.total(m_problem.mu);
            next.time = from.time + move.elapsed;
            next.parent = parent;
            next.move = index;
            m_problem.automaton.settle(m_problem.automaton.after(from.stage, move), next.time, m_settled);
            for (const SettledState& stage : m_settled) {
                next.stage = stage.state;
                next.cost = cost + m_problem.mu * stage.edges + stage.timing;
                offer(next);
            }
        }
    }

    /// Whether a transition leads to where states are still taken, once the frames behind it were played that
    /// must be. \param cost  with that of the move.
    bool isPromising(const Candidate& from, MoveIndex index, double cost)
    {
        if (!m_problem.automaton.isEmpty())
            return true;
        const WalkMove& move = m_problem.graph.move(index);
        const MoveMotions::Motion& motion = m_problem.motions.of(index);
        const FrameLayout& layout = m_problem.graph.layout();
        const NodeIndex node = std::min(move.to + std::max(0, m_problem.automaton.runLeft({}) - 1),
                                        layout.lastOf(layout.sequenceOf(move.to)));
        const double walked = from.place.walked + static_cast<double>(motion.steps.back().arcLength) +
                              m_problem.motions.wayBetween(move.to, node);
        if (walked >= m_problem.course.length())
            return true;
        const double rank =
            cost + outlookShare * m_outlook.cost(node, walked, from.place.placement * motion.exit);
        BeamFront<Candidate>& front = m_layers[layerOf(walked)];
        return front.layer({.node = node}, 0).takes(rank);
    }

    std::size_t layerOf(double walked) const
    {
        return std::min(static_cast<std::size_t>(walked / layerLength), m_layers.size() - 1);
    }

    void offer(Candidate& candidate)
    {
        const double left = m_problem.automaton.leastCost(candidate.stage, candidate.time);
        if (candidate.cost + left >= m_limit)
            return;
        const bool isAtEnd = candidate.place.walked >= m_problem.course.length();
        if (isAtEnd && m_problem.automaton.hasRun(candidate.stage) && !isInAir(candidate.stage.node)) {
            if (m_problem.automaton.isDone(candidate.stage))
                keep(candidate);
            return;
        }
        const NodeIndex node = candidate.stage.node;
        const FrameLayout& layout = m_problem.graph.layout();
        if (node + m_problem.automaton.runLeft(candidate.stage) > layout.lastOf(layout.sequenceOf(node)))
            return;
        // The last frames of a sequence have no way out.
        if (candidate.place.walked + m_problem.motions.walkableFrom(candidate.stage.node) <
            m_problem.course.length())
            return;
        const bool runs = !m_problem.automaton.hasRun(candidate.stage);
        if (runs && candidate.stage.run > 1) {
            m_running.push_back(candidate);
            return;
        }
        BeamFront<Candidate>& front = m_layers[layerOf(candidate.place.walked)];
        BeamLayer<Candidate>& layer =
            front.layer(candidate.stage, m_problem.automaton.quartersDone(candidate.stage, candidate.time));
        candidate.rank = candidate.cost + left + outlook(candidate);
        if (!layer.takes(candidate.rank)) {
            m_isComplete = false;
            return;
        }
        if (!m_known.improves(fingerprint(candidate), candidate.cost))
            return;
        if (runs) {
            m_running.push_back(candidate);
            return;
        }
        m_kept = std::max(m_kept, static_cast<std::size_t>(candidate.parent + 1));
        candidate.order = m_order++;
        layer.add(candidate, m_settings.width);
    }

    bool isInAir(NodeIndex node) const
    {
        return !m_problem.inAir.empty() && m_problem.inAir[static_cast<std::size_t>(node)];
    }

    void keep(const Candidate& last)
    {
        const double cost = last.cost + m_problem.costs.timingAtEnd(last.place);
        if (cost >= m_limit)
            return;
        m_limit = cost;
        m_found = routeTo(last, m_seen, cost);
    }

    /// About what is still to come.
    double outlook(const Candidate& candidate) const
    {
        const NodeIndex node = candidate.stage.node;
        const PathPlace& place = candidate.place;
        // Of two that are both close enough, the closer one goes first.
        constexpr double tie = 1e-3;
        const Vec3d& point = m_problem.motions.point(node);
        const Vec2d ground = place.placement(Vec2d(point.head<2>()));
        const double off = m_problem.costs.distance({ground.x(), ground.y(), point.z()}, place.walked);
        return outlookShare * m_outlook.cost(node, place.walked, place.placement) + tie * off * off +
               0.001 * std::abs(m_problem.costs.lateness(place));
    }

    std::uint64_t fingerprint(const Candidate& candidate) const
    {
        const Vec3d& point = m_problem.motions.point(candidate.stage.node);
        const Vec2d ground = candidate.place.placement(Vec2d(point.head<2>()));
        const auto cell = [](double value, double size) {
            return static_cast<std::int64_t>(std::floor(value / size));
        };
        const std::size_t future =
            AutomatonFutureHash()(m_problem.automaton.future(candidate.stage, candidate.time));
        return fingerprintOf({static_cast<std::int64_t>(future), candidate.place.timed,
                              candidate.place.timedFrames / 2,
                              cell(candidate.place.walked, m_settings.offset),
                              cell(ground.x(), m_settings.offset), cell(ground.y(), m_settings.offset),
                              cell(wrappedAngle(candidate.place.placement.turn), m_settings.heading)});
    }

    PathProblem& m_problem;
    const PathOutlook& m_outlook;
    PassSettings m_settings;
    double m_limit;
    PathFailure& m_failure;
    std::vector<BeamFront<Candidate>> m_layers;
    std::vector<Candidate> m_running; ///< cannot leave their takes yet
    std::vector<Candidate> m_seen;
    std::size_t m_kept = 0; ///< of these, the first ones: open states come after them
    std::vector<SettledState> m_settled;
    CheapestKnown m_known;
    std::uint32_t m_order = 0;
    std::optional<FoundRoute> m_found;
    bool m_isComplete = true;
};

} // namespace

std::optional<FoundRoute> searchPath(PathProblem& problem, std::int64_t budget, const FoundCallback& found,
                                     PathFailure& failure, SearchEffort& effort, const Progress& progress)
{
    std::optional<FoundRoute> best;
    const double layers = problem.course.length() / layerLength + 1;
    const auto allMoves = static_cast<MoveIndex>(problem.graph.moves().size());
    const PathOutlook outlook(problem.graph, problem.course, problem.costs, problem.motions, problem.mu,
                              problem.automaton.runLeft({}), progress);
    PassSettings settings{
        .width = 16, .moves = problem.automaton.isEmpty() ? allMoves : 64, .offset = 0.1, .heading = 0.2};
    for (std::int64_t left = budget; left > 0;) {
        progress.report(budget - left, budget);
        // A pass that the budget would end half way is made narrower instead.
        settings.width =
            std::max(std::int64_t{1},
                     std::min(settings.width, static_cast<std::int64_t>(static_cast<double>(left) / layers)));
        const std::int64_t before = left;
        PathPass pass(problem, outlook, settings, best ? best->cost : unreachable, failure);
        std::optional<FoundRoute> better = pass.run(left, progress);
        effort.expansions = budget - left;
        if (better) {
            best = std::move(better);
            best->expansions = effort.expansions;
            found(*best);
            if (problem.improve)
                best = problem.improve(*std::move(best));
        }
        effort.isComplete = pass.isComplete() && settings.offset <= finestOffset;
        if (left == before || (effort.isComplete && !best))
            break;
        settings.width *= 3;
        settings.moves = settings.moves > allMoves / 2 ? allMoves : 2 * settings.moves;
        settings.offset = std::max(settings.offset / 2, finestOffset);
        settings.heading = std::max(settings.heading / 2, 0.04);
    }
    return best;
}

} // namespace quadrille
