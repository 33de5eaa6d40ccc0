// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

namespace quadrille {

class AnimationCamera;
class AnimationSound;
class CurrentAnimation;
class JunctionPanel;
class PoseComparison;
class KeysAndStoryboard;
class PathTool;

/// The workspace in which new performances are made: what is asked of an animation, and what came out.
class AnimateWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit AnimateWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override;
    std::optional<NamedFrame> shownPose() override;
    QString shownClip() const override;
    void setActive(bool active) override;
    CurrentAnimation& animation() { return *m_animation; }
    KeysAndStoryboard& keysAndStoryboard() { return *m_keysAndStoryboard; }
    PathTool& path() { return *m_path; }
    AnimationSound& sound() { return *m_sound; }
    AnimationCamera& camera() { return *m_camera; }

private:
    void connectJunctions();
    void followAnimations();
    void frameOther();
    void followPreview();
    void followResult(const QString& name);
    void showState();

    EditorContext& m_context;
    JunctionPanel* m_junctions = nullptr;
    PoseComparison* m_comparison = nullptr;
    SceneView* m_view;
    CurrentAnimation* m_animation;
    KeysAndStoryboard* m_keysAndStoryboard;
    PathTool* m_path;
    AnimationSound* m_sound;
    AnimationCamera* m_camera;
    std::vector<Panel> m_panels;
    std::optional<FrameIndex> m_frameBefore; ///< of the clip that a preview is shown in place of
    bool m_isActive = false;
    QString m_framed; ///< the animation that the view was framed on last
};

} // namespace quadrille
