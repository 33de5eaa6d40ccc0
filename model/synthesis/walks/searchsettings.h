// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace quadrille {

/// β over α where none is given. With 1, waiting costs as much as being early, so that nothing keeps a walk
/// from going from key to key the shortest way: on real takes ten keys over 1,800 frames were then met some
/// 700 frames early each, with 10 all of them on time at 5 % more weight.
inline constexpr double betaPerAlpha = 10;

/// What being off a path costs; the defaults are the paper's (SMCAS §4.3.1): the squared distance in each
/// output frame.
struct PathCharging
{
    double deadZone = 0; ///< metres off the path that cost nothing
    /// Above 0: the squared distance counts by the way that is walked, so many times for each metre, not by
    /// frames: who walks slowly is not punished for it.
    double perMetre = 0;

    bool operator==(const PathCharging&) const = default;
};

/// How far the way of a walk is turned towards its path at most, beyond what was captured.
struct SteeringLimits
{
    double perMetre = 0; ///< radians for each metre walked; 0: not at all
    double perFrame = 0; ///< radians in each output frame

    bool operator==(const SteeringLimits&) const = default;
};

/// How a walk is sought. What is found depends on the budget, never on threads or time.
struct SearchSettings
{
    /// β: cost of a frame of timing error of keys, actions and spans, ≥ 0; empty: betaPerAlpha · α.
    std::optional<double> beta;
    double mu = 0.1; ///< μ: weight of edges against squared metres of deviation, where there is a path
    /// Expansions, ≥ 1: states of which all ways on are looked at. Where keys alone are asked for, all states
    /// of a leg at one output frame count as one.
    std::int64_t budget = 100'000;
    /// Keys are met with the least cost over all of them. Otherwise from key to key, each with the error of
    /// the one before carried over, as in the paper.
    bool globalKeys = false;
    /// Captured frames that are played at least between two transitions, before the first and after the last;
    /// required transitions may be nearer to others. Where keys alone are asked for, each that is missing
    /// costs β.
    int leastRun = 0;
    /// What a frame of an action that is left out costs, times α, ≥ 1; with 1 as much as one that is played.
    double leftOutWeight = 1;
    PathCharging charging;
    SteeringLimits steering;
    /// Captured frames of locomotion cost nothing along a path, and others `strayWeight` times α each, in
    /// transitions as far as they show; otherwise each costs α, as in the paper, and in transitions nothing.
    bool prefersLocomotion = false;
    double strayWeight = 3000;
    /// What a transition costs more, times α, that goes from the ground into flight or out of flight onto the
    /// ground, where keys alone are asked for; 0 as in the paper. So a jump begins with its take-off and ends
    /// with its landing.
    double flightWeight = 0;
    /// What a transition along a path costs more, times α, for each body height a second by which the body
    /// gets on faster or slower behind it; 0 as in the paper.
    double paceWeight = 0;
    /// What a transition along a path costs more, times α, for an uneven pace: for each output frame the
    /// square of how much the speed over the ground changes within a fifth of a second, body heights a
    /// second; 0 as in the paper.
    double unevenWeight = 0;

    bool operator==(const SearchSettings&) const = default;
    /// What looks best along a path: see the evaluation “walks”.
    static SearchSettings calm()
    {
        return {.budget = 20'000,
                .leftOutWeight = 5,
                .charging = {.deadZone = 0.07, .perMetre = 50},
                .prefersLocomotion = true,
                .flightWeight = 200,
                .paceWeight = 200,
                .unevenWeight = 600};
    }
};

} // namespace quadrille
