// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/keylegs.h"
#include "model/synthesis/walks/walkgraph.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// How far a walk has come with what is asked of it, wherever it lies.
struct AutomatonState
{
    static constexpr std::int32_t free = -1;   ///< no action is being performed
    static constexpr std::int32_t goesOn = -2; ///< one that has a duration

    NodeIndex node = 0;
    std::int16_t key = 0;       ///< the next to be met
    std::int16_t step = 0;      ///< the action that comes next or is being performed, repetitions counted
    std::int32_t span = free;   ///< which of its spans is being performed
    std::int32_t since = 0;     ///< the frame at which it was entered; when it goes on, the output frame
    std::uint32_t required = 0; ///< bits of the required transitions and spans that were played
    bool isFollowing = false;   ///< a required span was played from its first frame on
    /// Captured frames since the last transition, the one that it came to included, up to the least run; 0
    /// where there is none.
    std::int16_t run = 0;
    std::int16_t shortfall = 0; ///< of the run before the transition just made; 0 once it is settled

    bool operator==(const AutomatonState&) const = default;
};

/// What of a state and its output frame counts for what comes next (see ConstraintAutomaton::future).
using AutomatonFuture = std::pair<AutomatonState, std::int64_t>;

struct AutomatonFutureHash
{
    std::size_t operator()(const AutomatonFuture& future) const;
};

/// What a walk can be after a frame, and what that costs.
struct SettledState
{
    AutomatonState state;
    double edges = 0;  ///< for each frame that an action leaves out or a run lacks
    double timing = 0; ///< β · timing error
};

/// The order in which keys, actions and required junctions are met, as an automaton over the frames of a
/// walk, and lower bounds of what is left.
class ConstraintAutomaton
{
public:
    /// One action, once.
    struct Step
    {
        int action = 0;
        std::vector<WalkSpan> spans;
        std::vector<NodeIndex> needed; ///< frames of each span that must be played
        std::optional<double> duration;
        std::vector<bool> contains; ///< by node
    };

    /// \param edgeFactor  what a weight counts in the total, μ or 1. \param leastRun
    /// SearchSettings::leastRun. \param leftOutWeight  SearchSettings::leftOutWeight.
    ConstraintAutomaton(const WalkGraph& graph, const WalkConstraints& constraints, double beta,
                        double edgeFactor, int leastRun = 0, double leftOutWeight = 1);

    /// What a state that has come to its frame can become there. \param out  cleared first.
    void settle(const AutomatonState& state, std::int64_t time, std::vector<SettledState>& out) const;
    /// The first frame of a walk, before it is settled.
    AutomatonState begin(NodeIndex node) const;
    bool allows(const AutomatonState& state, const WalkMove& move) const;
    /// Having moved, before it is settled.
    AutomatonState after(AutomatonState state, const WalkMove& move) const;
    bool isDone(const AutomatonState& state) const;
    /// Whether enough captured frames were played for a transition, or the end.
    bool hasRun(const AutomatonState& state) const { return runLeft(state) == 0; }
    /// Captured frames that are to come before that.
    int runLeft(const AutomatonState& state) const { return m_leastRun - state.run; }
    /// What of a state and its output frame counts for what comes next: states that agree in it have one
    /// future.
    AutomatonFuture future(AutomatonState state, std::int64_t time) const;
    /// How much of the action that is being performed is behind, in quarters, 0 … 4.
    int quartersDone(const AutomatonState& state, std::int64_t time) const;
    /// No walk goes on from a state with less cost; `unreachable` where none meets what is asked.
    double leastCost(const AutomatonState& state, std::int64_t time) const;
    bool isEmpty() const { return m_keys.empty() && m_steps.empty() && m_requiredAll == 0; }
    const std::vector<Step>& steps() const { return m_steps; }

private:
    void addSteps(const std::vector<Action>& actions);
    void addBounds();
    void addRequired(const Junctions& junctions);
    int longestRunTo(NodeIndex node) const;
    AutomatonState arrived(AutomatonState state) const;
    double leastOfKeys(const AutomatonState& state, std::int64_t time) const;
    double leastOfActions(const AutomatonState& state, std::int64_t time) const;
    double leastOfRequired(const AutomatonState& state) const;
    bool canFinish(const AutomatonState& state) const;
    SettledState finished(const AutomatonState& state, std::int64_t time) const;

    const WalkGraph& m_graph;
    double m_beta;
    double m_edgeFactor;
    int m_leastRun;
    /// Keys are all that is asked for: the walk is over at the last one, and each captured frame that is
    /// missing before a transition or that key costs as much as one of timing error. Otherwise none may be
    /// missing.
    bool m_chargesRuns = false;
    int m_lastRun = 0; ///< captured frames before the last key
    double m_leftOut;  ///< cost of a frame that an action leaves out
    std::vector<PoseKey> m_keys;
    std::vector<Step> m_steps;
    std::vector<LegBounds> m_keyBounds;
    std::vector<std::vector<double>> m_keyRest; ///< of each key and θ: bounds of the legs behind it
    std::size_t m_zeroTheta = 0;
    /// Costs of performing everything from each step on, by node, and the least of a step's last span frames.
    std::vector<std::vector<double>> m_stepCosts;
    std::vector<double> m_leastAfter; ///< of each step with a duration: the least cost of what follows
    std::vector<WalkSpan> m_requiredSpans;
    std::vector<std::vector<double>> m_requiredCosts; ///< of each bit, by node
    std::size_t m_requiredTransitions = 0;
    std::uint32_t m_requiredAll = 0;
};

} // namespace quadrille
