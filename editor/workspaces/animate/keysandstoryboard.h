// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

namespace quadrille {

class AnimationTimeline;
class CurrentAnimation;
class FramePictures;
class FrameNotes;
class KeysPanel;
class NotesPanel;
class StoryboardPanel;

/// The part of the Animate workspace that asks for poses at times and for actions one after the other: the
/// timeline's keys and clip strip, their panels and actions, kept in step.
class KeysAndStoryboard : public QObject
{
    Q_OBJECT

public:
    using ShownPose = std::function<std::optional<NamedFrame>()>;

    explicit KeysAndStoryboard(CurrentAnimation& animation, QObject* parent = nullptr);

    /// Makes them; called once.
    std::vector<Workspace::Panel> panels();
    AnimationTimeline& timeline() { return *m_timeline; }
    /// Makes the docks of both as high as what is in them needs: one line while there is nothing.
    void fitDocks();
    /// Where the pose comes from that is added as a key.
    void setShownPose(ShownPose shownPose) { m_shownPose = std::move(shownPose); }

private:
    void makeActions();
    void makeNotes();
    void updateActions();
    void selectKey(int key);
    void goToNeighbour(int step);
    void addTakes();
    void showStatus(const QString& text);

    CurrentAnimation& m_animation;
    ShownPose m_shownPose;
    FramePictures* m_pictures;
    AnimationTimeline* m_timeline;
    KeysPanel* m_keys = nullptr;
    StoryboardPanel* m_storyboard = nullptr;
    FrameNotes* m_notes = nullptr;
    NotesPanel* m_notesPanel = nullptr;
    int m_selectedKey = -1;
    std::optional<bool> m_areDocksLow; ///< since they were fitted
};

} // namespace quadrille
