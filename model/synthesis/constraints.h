// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/synthesis/walk.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// Captured frames that a constraint names: those with a label, of a sequence, or a range chosen by hand.
struct FrameSet
{
    std::string name;            ///< for messages, as the user calls it
    std::vector<WalkSpan> spans; ///< each inside one sequence; they may overlap

    bool operator==(const FrameSet&) const = default;
};

/// A pose that is to be shown at a time (SMCAS §4.3.2).
struct PoseKey
{
    NodeIndex frame = 0;
    double time = 0; ///< wanted, output frames from the start, ≥ 0
    /// Greatest error of the time that is accepted, output frames; empty: any, at its cost.
    std::optional<double> tolerance;

    bool operator==(const PoseKey&) const = default;
};

/// A stretch of a path that asks for more than to be followed.
struct PathSpan
{
    double from = 0; ///< metres of arc length from the beginning of the path
    double to = 0;
    /// While the walked length lies in [from, to] every captured frame is one of these; in a transition, the
    /// source frame or the destination frame is.
    std::optional<FrameSet> demanded;
    std::optional<double> duration; ///< wanted, output frames for which the walked length is in [from, to]

    bool operator==(const PathSpan&) const = default;
};

/// A place on the ground where the centre of the body must not come (IA4D Fig. 8c).
struct Obstacle
{
    std::string name;           ///< for messages
    std::vector<Vec2d> outline; ///< metres, axes of Ground: the centre of a disc, or ≥ 3 corners of a polygon
    double radius = 0;          ///< of the disc, metres; 0 for a polygon
    double clearance = 0;       ///< distance to keep from it, metres

    bool operator==(const Obstacle&) const = default;
};

/// A curve that the centre of the body follows: each output frame is compared with the point of the curve at
/// the length that was walked until then (SMCAS §4.3.1). The animation ends where the curve does.
struct PathConstraint
{
    std::vector<Vec3d> points; ///< ≥ 2 points of the curve, close together, metres, axes of the character
    bool inSpace = false;      ///< heights count, in distance and in length; otherwise seen from above
    std::vector<PathSpan> spans;
    std::vector<Obstacle> obstacles;

    bool operator==(const PathConstraint&) const = default;
};

/// Something that is to be performed: "kick", "walk for three seconds", "jump twice".
struct Action
{
    FrameSet frames;
    /// How often one of the spans is performed: played as captured from near its beginning to near its end.
    /// Each frame left out costs at least as much as one that is played (SearchSettings::leftOutWeight).
    /// Between repetitions anything may happen.
    int repetitions = 1;
    /// Wanted, output frames: the action goes on for so long with any of its frames, in any order, and
    /// transitions between them; repetitions do not count then.
    std::optional<double> duration;
    double leastShare = 0.5; ///< of the frames of a span that must be played, in (0, 1]

    bool operator==(const Action&) const = default;
};

/// What the user decided about single transitions of a walk.
struct Junctions
{
    std::vector<FramePair> banned;   ///< transitions not to be used
    std::vector<FramePair> required; ///< transitions that must be used, whether the graph has them or not
    std::vector<WalkSpan> spans;     ///< captured frames that must be played without a break
    /// The walk that these were decided on; it is changed where they say so and kept everywhere else (see
    /// repairedWalk). Empty: a walk is sought anew.
    Walk walk;

    bool operator==(const Junctions&) const = default;
};

/// All that is asked of a walk; everything combines. Keys are met in their order, and so are actions.
struct WalkConstraints
{
    std::vector<PoseKey> keys;
    std::optional<PathConstraint> path;
    std::vector<Action> actions;
    std::optional<FrameSet> start; ///< where the walk may begin; empty: anywhere
    Junctions junctions;

    /// Whether poses are all that the walk is to meet, whatever was decided about its transitions.
    bool areKeysAlone() const { return !keys.empty() && !path && actions.empty(); }
    bool operator==(const WalkConstraints&) const = default;
};

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
    /// Captured frames of locomotion cost nothing along a path, and others `strayWeight` times α each, in
    /// transitions as far as they show; otherwise each costs α, as in the paper, and in transitions nothing.
    bool prefersLocomotion = false;
    double strayWeight = 1000;
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

/// The smooth curve through given points (Catmull–Rom, centripetal, so that it neither overshoots nor loops).
/// \param spacing  greatest distance of the points that come out, metres, > 0.
/// \return the given points, with points between them; one that repeats the one before is left out.
std::vector<Vec3d> sampleCurve(const std::vector<Vec3d>& through, double spacing, bool closed = false);

/// Points on a cubic Bézier curve, both ends included. \param spacing  as for sampleCurve.
std::vector<Vec3d> sampleBezier(const Vec3d& from, const Vec3d& handleFrom, const Vec3d& handleTo,
                                const Vec3d& to, double spacing);

} // namespace quadrille
