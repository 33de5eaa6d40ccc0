// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/render/camerakeys.h"
#include "model/synthesis/postprocessingsettings.h"
#include "model/transition/interpolationmethod.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace quadrille {

/// Keys of the project file that this version does not know; kept and written again.
using UnknownKeys = nlohmann::ordered_json;

/// Frames that a constraint speaks of: all with a label, or a sequence, or some of its frames.
struct FrameChoice
{
    std::string label; ///< empty where a sequence is named
    std::string sequence;
    std::optional<FrameRange> range; ///< of the sequence

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
    double from = 0; ///< metres along the curve
    double to = 0;
    std::optional<FrameChoice> frames; ///< that may be played there
    std::optional<double> duration;    ///< seconds
    UnknownKeys unknown;

    bool operator==(const PathSpanEntry&) const = default;
};

/// A part of the ground that is not to be entered: a disc or a polygon.
struct ObstacleEntry
{
    std::vector<Vec2d> corners; ///< of the polygon; of a disc, its centre alone
    double radius = 0;          ///< of the disc, metres
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
    /// In the project's axes, metres; on the ground the coordinate along the up axis is 0.
    std::vector<Vec3d> points;
    std::vector<PathSpanEntry> spans;
    std::vector<ObstacleEntry> obstacles;
    double clearance = 0; ///< metres that the centre keeps from obstacles
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

/// How long and by which weights a walk is sought.
struct SearchEntry
{
    std::optional<std::int64_t> budget; ///< expansions
    std::optional<double> beta; ///< weight of a frame of timing error; ten times the graph's alpha when empty
    std::optional<double> mu;   ///< weight of the edges beside the deviation from a path
    bool globalKeys = false;    ///< all keys in one search
    UnknownKeys unknown;

    bool operator==(const SearchEntry&) const = default;
};

/// A frame of a sequence, by name.
struct NamedFrame
{
    std::string sequence;
    FrameIndex frame{0};

    bool operator==(const NamedFrame&) const = default;
};

/// The transition from one frame to another.
struct JunctionEntry
{
    NamedFrame from;
    NamedFrame to;

    bool operator==(const JunctionEntry&) const = default;
};

/// Transitions that the user decided on.
struct JunctionsEntry
{
    std::vector<JunctionEntry> banned; ///< never used
    std::vector<JunctionEntry> locked; ///< kept from a walk that was accepted
    std::vector<JunctionEntry> chosen; ///< preferred to what the search would take
    UnknownKeys unknown;

    bool isEmpty() const { return banned.empty() && locked.empty() && chosen.empty(); }
    bool operator==(const JunctionsEntry&) const = default;
};

/// Captured frames of a walk.
struct WalkSpanEntry
{
    std::string sequence;
    FrameRange frames;

    bool operator==(const WalkSpanEntry&) const = default;
};

/// A walk that was accepted, or written by hand; it is used as it is.
struct WalkEntry
{
    std::vector<WalkSpanEntry> spans;
    double turn = 0;         ///< of the first frame about the up axis, degrees
    std::optional<Vec2d> at; ///< where the first frame's centre stands; where it was captured when empty
    UnknownKeys unknown;

    bool operator==(const WalkEntry&) const = default;
};

/// What happens to the clip once its frames are there.
struct PostProcessingEntry
{
    PostProcessing steps;
    std::string symmetry; ///< file with the vertex opposite to each vertex; found from the mesh when empty
    UnknownKeys unknown;
    UnknownKeys unknownOfContacts;
    UnknownKeys unknownOfLoop;
    UnknownKeys unknownOfRetime;

    bool operator==(const PostProcessingEntry&) const = default;
};

/// A sound that is heard with an animation.
struct AudioEntry
{
    std::string file;
    double offset = 0; ///< when it begins, seconds from the start; below zero: its beginning is not heard
    double gain = 0;   ///< decibels
    UnknownKeys unknown;

    bool operator==(const AudioEntry&) const = default;
};

/// Where the camera of pictures and videos stands at a time, in the project's axes and unit.
struct CameraKeyEntry
{
    CameraKey key;
    UnknownKeys unknown;

    bool operator==(const CameraKeyEntry&) const = default;
};

/// A performance made from captured ones.
struct AnimationEntry
{
    std::string name;
    std::string character;            ///< may be left out in a file with one character
    std::optional<FrameChoice> start; ///< where the walk may begin; anywhere when empty
    std::vector<ConstraintEntry> constraints;
    SearchEntry search;
    JunctionsEntry junctions;
    std::optional<WalkEntry> walk;
    InterpolationMethod interpolation = InterpolationMethod::Poisson;
    bool gentleBlend = false; ///< BlendSettings::gentle instead of the paper's
    PostProcessingEntry post;
    std::optional<AudioEntry> audio;
    std::vector<CameraKeyEntry> camera; ///< in the order of their times
    UnknownKeys unknown;

    bool operator==(const AnimationEntry&) const = default;
};

} // namespace quadrille
