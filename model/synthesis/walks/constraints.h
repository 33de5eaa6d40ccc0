// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/synthesis/clips/walk.h"

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

/// The smooth curve through given points (Catmull–Rom, centripetal, so that it neither overshoots nor loops).
/// \param spacing  greatest distance of the points that come out, metres, > 0.
/// \return the given points, with points between them; one that repeats the one before is left out.
std::vector<Vec3d> sampleCurve(const std::vector<Vec3d>& through, double spacing, bool closed = false);

/// Points on a cubic Bézier curve, both ends included. \param spacing  as for sampleCurve.
std::vector<Vec3d> sampleBezier(const Vec3d& from, const Vec3d& handleFrom, const Vec3d& handleTo,
                                const Vec3d& to, double spacing);

} // namespace quadrille
