// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/motiongraph.h"
#include "model/project/document/animationentry.h"
#include "model/project/document/appearanceentry.h"
#include "model/project/document/evaluationentry.h"
#include "model/project/document/liveentry.h"
#include "model/project/document/motionspaceentry.h"
#include "model/project/document/problem.h"
#include "model/project/document/projectionentry.h"
#include "model/project/document/transferentry.h"
#include "model/project/document/unknownkeys.h"
#include "model/project/document/variationentry.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/transition/posedistancesettings.h"
#include "model/transition/transitionsettings.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

struct ProjectSettings
{
    double fps = 25.0;                 ///< frames per second; everything runs at it
    CoordinateSystem axes;             ///< up axis and unit that all sequences are converted to
    std::int64_t cacheMegabytes = 512; ///< frames and textures kept in memory
    UnknownKeys unknown;

    /// What MediaCache::setBudget takes.
    std::size_t cacheBytes() const { return static_cast<std::size_t>(cacheMegabytes) << 20U; }
    bool operator==(const ProjectSettings&) const = default;
};

/// Texture files of a character or sequence: none, one, one per frame (a folder or pattern), or one per
/// material.
struct TextureReference
{
    enum class Kind
    {
        None,
        Single,
        PerFrame,
        PerMaterial,
    };
    Kind kind = Kind::None;
    /// Single: one file. PerFrame: one folder or pattern. PerMaterial: one file per material, in material
    /// order.
    std::vector<std::string> paths;
    UnknownKeys unknown;

    bool operator==(const TextureReference&) const = default;
};

struct CharacterEntry
{
    std::string name;
    std::string mesh; ///< path of the mesh that gives topology and UVs
    TextureReference texture;
    std::string notes;
    UnknownKeys unknown;

    bool operator==(const CharacterEntry&) const = default;
};

struct SequenceEntry
{
    std::string name;
    std::string character;           ///< may be left out in a file with one character
    std::string source;              ///< a file, a folder or pattern of a series, or "clip:SECTION/NAME"
    std::string clip;                ///< animation clip of a scene file
    std::optional<FrameRange> range; ///< in source frames; everything when empty
    std::optional<double> sourceFps; ///< rate of a source that names none, where it is not settings.fps
    std::optional<CoordinateSystem> sourceAxes;
    TextureReference texture;      ///< instead of the character's
    std::vector<LabelSpan> labels; ///< in frames of the sequence
    std::vector<ContactSpan> contacts;
    std::string jointAngles; ///< BVH with reference joint angles, for evaluation
    UnknownKeys unknown;
    /// Labels and contacts that were read with unknown keys, whole, as {"labels": […], "contacts": […]}; a
    /// span that is saved unchanged gets its keys back.
    UnknownKeys unknownOfSpans;

    bool operator==(const SequenceEntry&) const = default;
};

/// How the poses of one character are compared, and which transitions its graphs hold.
struct GraphEntry
{
    // What is not the paper's (SMCAS) looks better by the evaluations “junctions” and “walks”.
    std::string character; ///< may be left out in a file with one character
    PoseDistanceSettings pose;
    /// Rate and windows are those of `durations` at the project's rate, see transitionSettings.
    TransitionCost cost = TransitionCost::Mean;
    CostScale costScale = CostScale::Liveliness;
    TransitionLength length = TransitionLength::Windows;
    /// What else than poses transitions are sought by.
    StepWeights steps{.contacts = 1, .velocity = 0.05};
    int slope = TransitionSettings().slope;
    /// Shortest and longest window of a transition, seconds; usualDurations when empty.
    std::optional<std::pair<double, double>> durations;
    double alpha = usualAlpha; ///< weight of a frame's time against the cost (SMCAS §4.1)
    CostSmoothing smoothing = CostSmoothing::None; ///< what the minima of the motion graph are looked for in
    std::optional<double> greatestDistance; ///< d_max, in the unit of the pose distances; the largest of all
    UnknownKeys unknown;

    bool operator==(const GraphEntry&) const = default;
    /// What the paper has (SMCAS): the sum of pose distances alone, in windows of a third of a second or
    /// more.
    static GraphEntry paper();
};

/// Shortest and longest window of a transition, seconds. Windows of takes that are too short for two of them
/// may be shorter, which those that are asked for may not.
inline constexpr std::pair<double, double> usualDurations{0.6, 2.0};

inline constexpr double longestWindow = 60; ///< of a transition, seconds

/// What the transitions of a graph are sought with at a rate, frames per second.
TransitionSettings transitionSettings(const GraphEntry& entry, double fps);

struct ExportEntry
{
    std::string name;
    std::string what; ///< "sequences/NAME", "animations/NAME", "live/NAME", "transfers/NAME",
                      ///< "projections/NAME", "variations/NAME/3", or all of "variations/NAME"
    std::string path; ///< the ending gives the format, unless `format` does
    std::string format;
    std::optional<FrameRange> range;
    std::optional<double> fps;
    std::optional<CoordinateSystem> axes;
    bool textures = true;
    /// Size, look and camera of pictures and videos as in the file, see pictureoptions.h; none for the
    /// defaults.
    UnknownKeys picture;
    UnknownKeys unknown;

    bool operator==(const ExportEntry&) const = default;
};

/// The project document: a plain value, compared and copied as a whole by undo. Paths are relative to the
/// file, with forward slashes.
struct Project
{
    static constexpr int currentVersion = 1;

    ProjectSettings settings;
    std::vector<CharacterEntry> characters;
    std::vector<SequenceEntry> sequences;
    std::vector<BodyPartsEntry> bodyParts; ///< the section “body_parts”; one for each character at most
    std::vector<GraphEntry> graphs;        ///< the section “graph”; one for each character at most
    std::vector<AnimationEntry> animations;
    std::vector<VariationEntry> variations;
    std::vector<MotionSpaceEntry> motionSpaces; ///< the section “motion_spaces”
    std::vector<LiveEntry> lives;               ///< the section “live”
    std::vector<AppearanceEntry> appearances;   ///< the section “appearance”
    std::vector<TransferEntry> transfers;
    std::vector<ProjectionEntry> projections;
    std::vector<EvaluationEntry> evaluations;
    std::vector<ExportEntry> exports;
    /// Sections and keys that this version does not know.
    UnknownKeys unknown;

    bool operator==(const Project&) const = default;
};

} // namespace quadrille
