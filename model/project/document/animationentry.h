// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/constraintentry.h"
#include "model/render/camerakeys.h"
#include "model/synthesis/finishing/postprocessingsettings.h"
#include "model/synthesis/walks/searchsettings.h"
#include "model/transition/interpolationmethod.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// How long and by which weights a walk is sought.
struct SearchEntry
{
    std::optional<std::int64_t> budget; ///< expansions
    std::optional<double> beta; ///< weight of a frame of timing error; ten times the graph's alpha when empty
    std::optional<double> mu;   ///< weight of the edges beside the deviation from a path
    bool globalKeys = false;    ///< all keys in one search
    /// Whether walks cost what the paper has; otherwise they are calm, and what follows counts.
    bool isPaper = false;
    std::optional<double> dwell;    ///< least time between two transitions, seconds
    std::optional<double> deadZone; ///< metres off a path that cost nothing
    std::optional<double> steering; ///< how far the way turns towards a path at most, degrees a metre
    UnknownKeys unknown;

    bool operator==(const SearchEntry&) const = default;
};

/// What counts where SearchEntry::dwell is empty, seconds.
inline constexpr double usualDwell = 0.5;
/// What counts where SearchEntry::steering is empty, degrees a metre.
inline constexpr double usualSteering = 30;

/// What a walk is sought with at a rate, frames per second.
SearchSettings searchSettings(const SearchEntry& entry, double fps);

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

/// Captured frames of a walk.
struct WalkSpanEntry
{
    std::string sequence;
    FrameRange frames;

    bool operator==(const WalkSpanEntry&) const = default;
};

/// Transitions that the user decided on.
struct JunctionsEntry
{
    std::vector<JunctionEntry> banned; ///< never used
    std::vector<JunctionEntry> locked; ///< kept from a walk that was accepted
    std::vector<JunctionEntry> chosen; ///< preferred to what the search would take
    /// The walk that these were decided on: what they do not say of it stays; empty: a walk is sought anew.
    std::vector<WalkSpanEntry> walk;
    UnknownKeys unknown;

    /// Whether nothing was decided.
    bool isEmpty() const { return banned.empty() && locked.empty() && chosen.empty(); }
    bool operator==(const JunctionsEntry&) const = default;
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

/// How an animation shows frames that it shows again: from variations of their takes, each time another one.
struct VariedRepeats
{
    std::string from;  ///< entry of “variations”; all that vary a take when empty
    double ease = 0.2; ///< how long poses take from captured frames to varied ones and back, seconds
    UnknownKeys unknown;

    bool operator==(const VariedRepeats&) const = default;
};

/// What happens to the clip once its frames are there.
struct PostProcessingEntry
{
    std::optional<VariedRepeats> variations; ///< before all other steps
    /// Contacts are corrected unless it is said that they are not.
    PostProcessing steps{.contacts = ContactCorrectionSettings()};
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
    bool gentleBlend = true; ///< BlendSettings::gentle, otherwise the paper's
    PostProcessingEntry post;
    std::optional<AudioEntry> audio;
    std::vector<CameraKeyEntry> camera; ///< in the order of their times
    UnknownKeys unknown;

    /// Whether there is a walk, or what one can be sought for.
    bool asksForSomething() const { return walk || !constraints.empty(); }
    bool operator==(const AnimationEntry&) const = default;
};

} // namespace quadrille
