// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"

#include <QPointer>

namespace quadrille {

class Gamepad;
class Job;
class LiveBar;
class LiveKeys;
class LiveSession;
class SteeringPanel;

namespace widgets {
class PlaybackBar;
}

/// The workspace in which motion spaces are steered live: by keys, gamepad and sliders. Every tick can be
/// gone back to, and what was steered becomes a performance of the project.
class LiveWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit LiveWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    void setActive(bool active) override;
    LiveSession& session() { return *m_session; }
    Gamepad& gamepad() { return *m_gamepad; }

    /// What the figure is called in the view.
    static QString figureName();

signals:
    /// The user wants a performance in files: "live/NAME".
    void exportRequested(const QString& clip);

private:
    ClipScene::Source source();
    void makeActions();
    void makePanels();
    void connectSession();
    void connectView();
    /// Whose spaces are played; null where nobody has any.
    QString character() const;
    void follow();
    void followGraph();
    void followSelection();
    void followRunning();
    void showState();
    void showPose();
    void showTimeline();
    void toggle();
    void toggleRecording();
    void addSequence();

    EditorContext& m_context;
    SceneView* m_view;
    LiveSession* m_session;
    LiveKeys* m_keys;
    Gamepad* m_gamepad;
    LiveBar* m_bar = nullptr;
    SteeringPanel* m_steering = nullptr;
    std::vector<Panel> m_panels;
    MeshSequence m_still; ///< that the figure is made of
    QString m_loaded;     ///< the performance that is played again
    widgets::PlaybackBar* m_playback = nullptr;
    QPointer<Job> m_job; ///< whose progress is followed
    QString m_help;      ///< the action behind the message's button
    int m_shownTicks = 0;
    bool m_isActive = false;
};

} // namespace quadrille
