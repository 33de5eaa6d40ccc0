// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/constraintautomaton.h"

#include "model/core/error.h"
#include "model/synthesis/walks/fingerprints.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Spans that overlap are one.
std::vector<WalkSpan> united(std::vector<WalkSpan> spans)
{
    std::sort(spans.begin(), spans.end(),
              [](const WalkSpan& a, const WalkSpan& b) { return a.first < b.first; });
    std::vector<WalkSpan> result;
    for (const WalkSpan& span : spans) {
        if (!result.empty() && span.first <= result.back().last)
            result.back().last = std::max(result.back().last, span.last);
        else
            result.push_back(span);
    }
    return result;
}

std::size_t indexOf(NodeIndex node)
{
    return static_cast<std::size_t>(node);
}

} // namespace

std::size_t AutomatonFutureHash::operator()(const AutomatonFuture& future) const
{
    const AutomatonState& stage = future.first;
    return fingerprintOf({stage.node, stage.key, stage.step, stage.span, stage.since, stage.required,
                          stage.isFollowing ? 1 : 0, stage.run, future.second});
}

ConstraintAutomaton::ConstraintAutomaton(const WalkGraph& graph, const WalkConstraints& constraints,
                                         double beta, double edgeFactor, int leastRun, double leftOutWeight)
    : m_graph(graph)
    , m_beta(beta)
    , m_edgeFactor(edgeFactor)
    , m_leastRun(leastRun)
    , m_leftOut(leftOutWeight * graph.alpha())
    , m_keys(constraints.keys)
{
    assert(leftOutWeight >= 1); // or bounds would be too high
    addSteps(constraints.actions);
    addRequired(constraints.junctions);
    addBounds();
    m_chargesRuns = m_leastRun > 0 && constraints.areKeysAlone();
    if (m_chargesRuns)
        m_lastRun = longestRunTo(m_keys.back().frame);
}

/// How many captured frames can be played before a frame, itself included, up to the least run: its take may
/// be entered too late for more.
int ConstraintAutomaton::longestRunTo(NodeIndex node) const
{
    const FrameLayout& layout = m_graph.layout();
    int longest = 0;
    for (const WalkMove& move : m_graph.moves()) {
        if (move.kind == EdgeKind::Transition && move.to <= node &&
            layout.sequenceOf(move.to) == layout.sequenceOf(node))
            longest = std::max(longest, node - move.to + 1);
    }
    return std::min(longest, m_leastRun);
}

void ConstraintAutomaton::addSteps(const std::vector<Action>& actions)
{
    for (std::size_t a = 0; a < actions.size(); ++a) {
        const Action& action = actions[a];
        Step step{.action = static_cast<int>(a), .spans = action.frames.spans, .duration = action.duration};
        step.contains.assign(indexOf(m_graph.nodeCount()), false);
        for (const WalkSpan& span : step.spans) {
            const double share = action.leastShare * span.frameCount();
            step.needed.push_back(std::max(1, static_cast<NodeIndex>(std::ceil(share - 1e-9))));
            for (NodeIndex node = span.first; node <= span.last; ++node)
                step.contains[indexOf(node)] = true;
        }
        m_steps.insert(m_steps.end(), action.duration ? 1 : indexOf(action.repetitions), step);
    }
}

void ConstraintAutomaton::addRequired(const Junctions& junctions)
{
    m_requiredTransitions = junctions.required.size();
    m_requiredSpans = united(junctions.spans);
    const std::size_t count = m_requiredTransitions + m_requiredSpans.size();
    constexpr std::size_t most = 32;
    if (count > most)
        throw Error(ErrorCode::BadArgument,
                    {.values = {{"reason", "More than 32 junctions and spans are required"},
                                {"remedy", "Require fewer."}}});
    for (std::size_t bit = 0; bit < count; ++bit) {
        m_requiredAll |= std::uint32_t{1} << bit;
        NodeIndex from = 0;
        double cost = 0;
        if (bit < m_requiredTransitions) {
            from = junctions.required[bit].source;
            for (const WalkMove& move : m_graph.moves()) {
                if (move.required == static_cast<std::int32_t>(bit))
                    cost = move.weight;
            }
        } else {
            const WalkSpan& span = m_requiredSpans[bit - m_requiredTransitions];
            from = span.first;
            cost = m_graph.alpha() * (span.frameCount() - 1);
        }
        std::vector<double> goal(indexOf(m_graph.nodeCount()), unreachable);
        goal[indexOf(from)] = cost;
        m_requiredCosts.push_back(m_graph.waysTo(std::move(goal)).costs);
    }
}

void ConstraintAutomaton::addBounds()
{
    if (m_edgeFactor > 0) {
        for (const PoseKey& key : m_keys)
            m_keyBounds.emplace_back(m_graph, key.frame, m_beta / m_edgeFactor);
    }
    m_keyRest.resize(m_keyBounds.size());
    for (std::size_t k = m_keyBounds.size(); k-- > 0;) {
        const auto& weighted = m_keyBounds[k].all();
        m_keyRest[k].assign(weighted.size(), 0);
        for (std::size_t i = 0; i < weighted.size(); ++i) {
            if (weighted[i].theta == 0)
                m_zeroTheta = i;
            if (k + 1 < m_keyBounds.size())
                m_keyRest[k][i] =
                    m_keyRest[k + 1][i] + m_keyBounds[k + 1].all()[i].ways.costs[indexOf(m_keys[k].frame)];
        }
    }
    const std::vector<double> nothing(indexOf(m_graph.nodeCount()), 0);
    m_stepCosts.assign(m_steps.size() + 1, nothing);
    m_leastAfter.assign(m_steps.size(), 0);
    for (std::size_t s = m_steps.size(); s-- > 0;) {
        const Step& step = m_steps[s];
        const std::vector<double>& after = m_stepCosts[s + 1];
        std::vector<double> goal(indexOf(m_graph.nodeCount()), unreachable);
        m_leastAfter[s] = unreachable;
        for (std::size_t p = 0; p < step.spans.size(); ++p) {
            const WalkSpan& span = step.spans[p];
            double least = unreachable;
            NodeIndex left = span.last;
            for (NodeIndex entry = span.last; entry >= span.first; --entry) {
                const NodeIndex earliest = step.duration ? entry : entry + step.needed[p] - 1;
                for (; left >= earliest && left >= span.first; --left)
                    least = std::min(least, after[indexOf(left)]);
                if (!step.duration && earliest <= span.last)
                    goal[indexOf(entry)] =
                        std::min(goal[indexOf(entry)], least + m_graph.alpha() * (span.frameCount() - 1));
            }
            m_leastAfter[s] = std::min(m_leastAfter[s], least);
        }
        if (step.duration) {
            const double going = m_edgeFactor > 0 ? std::min(m_graph.alpha(), m_beta / m_edgeFactor) *
                                                        std::max(0.0, *step.duration - 1)
                                                  : 0;
            for (NodeIndex node = 0; node < m_graph.nodeCount(); ++node) {
                if (step.contains[indexOf(node)])
                    goal[indexOf(node)] = std::max(going + m_leastAfter[s], after[indexOf(node)]);
            }
        }
        m_stepCosts[s] = m_graph.waysTo(std::move(goal)).costs;
    }
}

AutomatonState ConstraintAutomaton::arrived(AutomatonState state) const
{
    for (std::size_t i = 0; i < m_requiredSpans.size(); ++i) {
        const WalkSpan& span = m_requiredSpans[i];
        if (state.node == span.first)
            state.isFollowing = true;
        if (state.node == span.last && state.isFollowing) {
            state.required |= std::uint32_t{1} << (m_requiredTransitions + i);
            state.isFollowing = false;
        }
    }
    return state;
}

AutomatonState ConstraintAutomaton::begin(NodeIndex node) const
{
    return arrived({.node = node, .run = static_cast<std::int16_t>(std::min(1, m_leastRun))});
}

bool ConstraintAutomaton::allows(const AutomatonState& state, const WalkMove& move) const
{
    if (move.kind == EdgeKind::Transition && move.required < 0 && !hasRun(state) && !m_chargesRuns)
        return false;
    if (state.span == AutomatonState::free)
        return true;
    const Step& step = m_steps[static_cast<std::size_t>(state.step)];
    if (state.span == AutomatonState::goesOn)
        return step.contains[indexOf(move.to)];
    return move.kind == EdgeKind::Original && move.to <= step.spans[indexOf(state.span)].last;
}

AutomatonState ConstraintAutomaton::after(AutomatonState state, const WalkMove& move) const
{
    state.node = move.to;
    if (m_chargesRuns && move.kind == EdgeKind::Transition && move.required < 0)
        state.shortfall = static_cast<std::int16_t>(runLeft(state));
    const int run = move.kind == EdgeKind::Original ? state.run + 1 : move.required < 0 ? 1 : m_leastRun;
    state.run = static_cast<std::int16_t>(std::min(run, m_leastRun));
    if (move.required >= 0)
        state.required |= std::uint32_t{1} << static_cast<std::uint32_t>(move.required);
    if (m_requiredSpans.empty())
        return state;
    state.isFollowing = state.isFollowing && move.kind == EdgeKind::Original;
    return arrived(state);
}

bool ConstraintAutomaton::canFinish(const AutomatonState& state) const
{
    if (state.span < 0)
        return state.span == AutomatonState::goesOn;
    const Step& step = m_steps[static_cast<std::size_t>(state.step)];
    return state.node - state.since + 1 >= step.needed[indexOf(state.span)];
}

SettledState ConstraintAutomaton::finished(const AutomatonState& state, std::int64_t time) const
{
    const Step& step = m_steps[static_cast<std::size_t>(state.step)];
    SettledState result{.state = state};
    if (state.span == AutomatonState::goesOn)
        result.timing = m_beta * std::abs(static_cast<double>(time - state.since + 1) - *step.duration);
    else
        result.edges = m_leftOut * (step.spans[indexOf(state.span)].last - state.node);
    ++result.state.step;
    result.state.span = AutomatonState::free;
    result.state.since = 0;
    return result;
}

void ConstraintAutomaton::settle(const AutomatonState& state, std::int64_t time,
                                 std::vector<SettledState>& out) const
{
    out.assign(1, {.state = state, .edges = m_beta * state.shortfall});
    out.front().state.shortfall = 0;
    const auto finish = [&](const SettledState& from) {
        if (!canFinish(from.state))
            return;
        SettledState done = finished(from.state, time);
        done.edges += from.edges;
        out.push_back(done);
    };
    if (state.span != AutomatonState::free) {
        finish(out.front());
    } else if (static_cast<std::size_t>(state.step) < m_steps.size()) {
        const Step& step = m_steps[static_cast<std::size_t>(state.step)];
        const auto enter = [&](std::int32_t span, std::int32_t since, double edges) {
            SettledState entered{.state = state, .edges = edges};
            entered.state.span = span;
            entered.state.since = since;
            out.push_back(entered);
            finish(entered);
        };
        if (step.duration && step.contains[indexOf(state.node)])
            enter(AutomatonState::goesOn, static_cast<std::int32_t>(time), 0);
        for (std::size_t p = 0; p < step.spans.size() && !step.duration; ++p) {
            const WalkSpan& span = step.spans[p];
            if (state.node >= span.first && state.node + step.needed[p] - 1 <= span.last)
                enter(static_cast<std::int32_t>(p), state.node, m_leftOut * (state.node - span.first));
        }
    }
    if (static_cast<std::size_t>(state.key) >= m_keys.size())
        return;
    const PoseKey& key = m_keys[static_cast<std::size_t>(state.key)];
    const double error = std::abs(static_cast<double>(time) - key.time);
    if (key.frame != state.node || error > key.tolerance.value_or(unreachable))
        return;
    const bool isEnd = m_chargesRuns && static_cast<std::size_t>(state.key) + 1 == m_keys.size();
    if (isEnd && state.required != m_requiredAll)
        return;
    const int shortfall = isEnd ? std::max(0, m_lastRun - state.run) : 0;
    const std::size_t count = out.size();
    for (std::size_t i = 0; i < count; ++i) {
        SettledState met = out[i];
        ++met.state.key;
        met.timing += m_beta * error;
        met.edges += m_beta * shortfall;
        out.push_back(met);
    }
}

bool ConstraintAutomaton::isDone(const AutomatonState& state) const
{
    return static_cast<std::size_t>(state.key) == m_keys.size() &&
           static_cast<std::size_t>(state.step) == m_steps.size() && state.required == m_requiredAll &&
           (m_chargesRuns || hasRun(state));
}

AutomatonFuture ConstraintAutomaton::future(AutomatonState state, std::int64_t time) const
{
    if (static_cast<std::size_t>(state.key) < m_keys.size())
        return {state, time};
    if (state.span == AutomatonState::goesOn)
        state.since -= static_cast<std::int32_t>(time);
    return {state, 0};
}

int ConstraintAutomaton::quartersDone(const AutomatonState& state, std::int64_t time) const
{
    if (state.span == AutomatonState::free)
        return 0;
    const Step& step = m_steps[static_cast<std::size_t>(state.step)];
    const bool goesOn = state.span == AutomatonState::goesOn;
    const auto behind = static_cast<double>(goesOn ? time - state.since : state.node - state.since);
    const double needed = goesOn ? *step.duration : step.needed[indexOf(state.span)];
    return static_cast<int>(std::clamp(4 * behind / std::max(needed, 1.0), 0.0, 4.0));
}

double ConstraintAutomaton::leastOfKeys(const AutomatonState& state, std::int64_t time) const
{
    const auto k = static_cast<std::size_t>(state.key);
    const auto t = static_cast<double>(time);
    if (k < m_keys.size() && t - m_keys[k].time > m_keys[k].tolerance.value_or(unreachable))
        return unreachable; // its time has passed
    if (k >= m_keyBounds.size())
        return 0;
    double best = m_keyBounds[k](state.node, m_keys[k].time - t) + m_keyRest[k][m_zeroTheta];
    const auto& weighted = m_keyBounds[k].all();
    for (std::size_t i = 0; i < weighted.size(); ++i)
        best = std::max(best, weighted[i].ways.costs[indexOf(state.node)] + m_keyRest[k][i] -
                                  weighted[i].theta * (m_keys.back().time - t));
    return best;
}

double ConstraintAutomaton::leastOfActions(const AutomatonState& state, std::int64_t time) const
{
    const auto s = static_cast<std::size_t>(state.step);
    if (state.span == AutomatonState::free)
        return m_stepCosts[s][indexOf(state.node)];
    const Step& step = m_steps[s];
    const std::vector<double>& after = m_stepCosts[s + 1];
    if (state.span == AutomatonState::goesOn) {
        const double left = *step.duration - static_cast<double>(time - state.since + 1);
        const double rate = m_edgeFactor > 0 ? m_beta / m_edgeFactor : 0;
        const double going = left > 0 ? std::min(m_graph.alpha(), rate) * left : rate * -left;
        return std::max(after[indexOf(state.node)], m_leastAfter[s] + going);
    }
    const auto p = indexOf(state.span);
    const NodeIndex last = step.spans[p].last;
    double least = unreachable;
    for (NodeIndex left = std::max(state.node, state.since + step.needed[p] - 1); left <= last; ++left)
        least = std::min(least, after[indexOf(left)]);
    return least + m_graph.alpha() * (last - state.node);
}

double ConstraintAutomaton::leastOfRequired(const AutomatonState& state) const
{
    double best = 0;
    for (std::size_t bit = 0; bit < m_requiredCosts.size(); ++bit) {
        if ((state.required >> bit & 1U) != 0)
            continue;
        if (state.isFollowing && bit >= m_requiredTransitions) {
            const WalkSpan& span = m_requiredSpans[bit - m_requiredTransitions];
            if (state.node >= span.first && state.node <= span.last) {
                best = std::max(best, m_graph.alpha() * (span.last - state.node));
                continue;
            }
        }
        best = std::max(best, m_requiredCosts[bit][indexOf(state.node)]);
    }
    return best;
}

double ConstraintAutomaton::leastCost(const AutomatonState& state, std::int64_t time) const
{
    const double least =
        std::max({leastOfKeys(state, time), leastOfActions(state, time), leastOfRequired(state)});
    // With weights that count nothing, what cannot be reached stays so.
    return m_edgeFactor > 0 || least == unreachable ? std::max(m_edgeFactor, 1e-300) * least : 0;
}

} // namespace quadrille
