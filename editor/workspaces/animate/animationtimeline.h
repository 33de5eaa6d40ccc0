// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/workspaces/animate/clipparts.h"
#include "widgets/timeline/timeline.h"

#include <QObject>

namespace quadrille {

class CurrentAnimation;
class FrameNotes;
class FramePictures;

/// Lets the timeline show and edit the animation that is worked on: its keys, where its clip was captured and
/// where it is made, and where what was demanded is met. Frames are those of the clip as it is shown.
class AnimationTimeline : public QObject
{
    Q_OBJECT

public:
    AnimationTimeline(CurrentAnimation& animation, FramePictures& pictures, QObject* parent = nullptr);

    /// Whose row stands below the others.
    void setNotes(FrameNotes& notes);
    /// Puts a pose where the playhead is, or behind all keys where one stands there already. That is one
    /// second behind the last. The key is selected then; so below. Without an animation one is made first.
    void addKey(const NamedFrame& pose);
    /// Puts a pose at a time, or at the next frame that is free. \param time seconds.
    void addKey(const NamedFrame& pose, double time);
    /// \param key  in the order of times, from 0; nothing happens for one that there is not.
    void removeKey(int key);
    /// The frame of the timeline at which a key is met, or is to be met. \pre There is one.
    int frameOfKey(int key) const;
    /// Puts player and playhead there; nothing happens for one that there is not.
    void goToKey(int key);
    /// Shows the first of some planned frames. Nothing happens where post-processing has left none of them.
    /// \param frames output frames, before post-processing.
    void goToPlanned(const FrameRange& frames);
    /// −1 for none. Emits nothing.
    void selectKey(int key);
    /// Chooses a transition of the walk; −1 for none. Emits nothing.
    void selectJunction(int junction);
    /// The parts of the clip that is shown.
    const std::vector<ClipPart>& parts() const { return m_parts; }

signals:
    /// −1 when none is selected any more. Return and double clicks: to be edited.
    void keySelected(int key);
    void keyActivated(int key);
    /// A transition of the walk, by its number; −1 when none is selected any more.
    void junctionSelected(int junction);
    void junctionHovered(int junction);
    void junctionActivated(int junction);

private:
    void refresh();
    void followResult();
    void refreshTracks();
    int shownFrames() const;
    double fps() const;
    void moveKey(int id, int frame, EditPhase phase);
    void take(const std::optional<widgets::SpanRef>& selected);
    int junctionOf(const std::optional<widgets::SpanRef>& span) const;
    std::optional<int> keyOf(const widgets::SpanRef& span) const;
    void createKeyHere(int frame);
    void showMenu(const QString& track, const std::optional<widgets::SpanRef>& span, int frame,
                  const QPoint& position);
    void keepPlayhead(int frame);
    void goTo(int frame);

    CurrentAnimation& m_animation;
    FramePictures& m_pictures;
    widgets::Timeline& m_timeline;
    std::shared_ptr<const AnimationResult> m_result;
    std::vector<std::int64_t> m_planned;
    std::vector<ClipPart> m_parts;
    QString m_shown;
    std::vector<int> m_keyIds; ///< what the timeline calls each key, so that one that is moved stays the same
    std::optional<AnimationEntry> m_dragBase;
    int m_dragged = -1; ///< key of the base
    FrameNotes* m_notes = nullptr;
    bool m_isTaking = false;
};

} // namespace quadrille
