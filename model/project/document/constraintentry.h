// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/project/document/unknownkeys.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace quadrille {

/// Frames that a constraint speaks of: all with a label, or a sequence, or some of its frames.
struct FrameChoice
{
    std::string label; ///< empty where a sequence is named
    std::string sequence;
    std::optional<FrameRange> range; ///< of the sequence

    bool saysNothing() const { return *this == FrameChoice(); }
    bool operator==(const FrameChoice&) const = default;
};

/// A pose that is to be shown at a time.
struct KeyEntry
{
    std::string sequence;
    FrameIndex frame{0};
    double time = 0;                 ///< wanted, seconds from the start
    std::optional<double> tolerance; ///< greatest error of the time, seconds; any when empty
    UnknownKeys unknown;

    bool operator==(const KeyEntry&) const = default;
};

/// What is asked of a part of a path.
struct PathSpanEntry
{
    double from = 0; ///< along the curve, in the project's unit
    double to = 0;
    std::optional<FrameChoice> frames; ///< that may be played there
    std::optional<double> duration;    ///< seconds
    UnknownKeys unknown;

    bool saysNothing() const { return !frames && !duration; }
    bool operator==(const PathSpanEntry&) const = default;
};

/// A part of the ground that is not to be entered: a disc or a polygon.
struct ObstacleEntry
{
    std::vector<Vec2d> corners; ///< of the polygon; of a disc, its centre alone
    double radius = 0;          ///< of the disc, in the project's unit
    UnknownKeys unknown;

    bool isDisc() const { return corners.size() == 1; }
    bool operator==(const ObstacleEntry&) const = default;
};

enum class PathCurve
{
    CatmullRom, ///< through all points
    Polyline,
    Bezier, ///< cubic: point, handle, handle, point, …
};

/// A curve to follow, over the ground or through space.
struct PathEntry
{
    PathCurve curve = PathCurve::CatmullRom;
    bool inSpace = false; ///< points have three coordinates
    /// In the project's axes and unit; on the ground the coordinate along the up axis is 0.
    std::vector<Vec3d> points;
    std::vector<PathSpanEntry> spans;
    std::vector<ObstacleEntry> obstacles;
    double clearance = 0; ///< that the centre keeps from obstacles, in the project's unit
    UnknownKeys unknown;

    bool operator==(const PathEntry&) const = default;
};

/// A movement that is to be performed.
struct ActionEntry
{
    FrameChoice frames;
    int repeat = 1;
    std::optional<double> duration;   ///< seconds; the action goes on with any of its frames
    std::optional<double> leastShare; ///< of a span that must be played, 0 … 1
    UnknownKeys unknown;

    bool operator==(const ActionEntry&) const = default;
};

using ConstraintEntry = std::variant<KeyEntry, PathEntry, ActionEntry>;

} // namespace quadrille
