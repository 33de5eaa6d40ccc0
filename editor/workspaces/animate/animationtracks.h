// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/animate/clipparts.h"
#include "widgets/timeline/timeline.h"

#include <QCoreApplication>

namespace quadrille {

class FramePictures;

constexpr auto keyTrackId = QLatin1String("keys");
constexpr auto clipTrackId = QLatin1String("clip");

/// What a frame is called: "dance 40".
QString poseText(const std::string& sequence, FrameIndex frame);
/// What frames are called: a label, a sequence, or "dance 10–40".
QString choiceText(const FrameChoice& frames);

/// The rows of an animation's timeline. Refers to what it is made with.
struct AnimationTracks
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AnimationTracks)

public:
    const AnimationEntry& entry;
    const AnimationResult* result;            ///< null without one
    const std::vector<std::int64_t>& planned; ///< see plannedFrames
    const std::vector<ClipPart>& parts;
    double fps;

    /// \param ids of each key.
    widgets::TimelineTrack keys(const std::vector<int>& ids, FramePictures& pictures) const;
    /// Spans have the numbers of the parts.
    widgets::TimelineTrack clip() const;
    /// Where each action is performed.
    widgets::TimelineTrack actions() const;
    /// Where the path demands a label, a take or a duration.
    widgets::TimelineTrack demands() const;

private:
    QString partText(const ClipPart& part) const;
    /// The variation that a part is drawn from; empty for captured frames.
    QString variationText(const ClipPart& part) const;
};

} // namespace quadrille
