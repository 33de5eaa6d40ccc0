// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/workspace.h"
#include "widgets/timeline/paintedrate.h"

#include <QPointer>
#include <QTimer>

namespace quadrille {

class FramePictures;
class Gamepad;
class Job;
class LiveBar;
class LiveKeys;
class LivePaths;
class LiveSession;
class SteeringPanel;

/// The workspace in which motion spaces are steered live: by keys, gamepad and sliders. Every tick can be
/// gone back to, and what was steered becomes a performance of the project.
class LiveWorkspace : public Workspace
{
    Q_OBJECT

public:
    explicit LiveWorkspace(EditorContext& context, QWidget* parent = nullptr);

    SceneView& view() override { return *m_view; }
    std::vector<Panel> panels() override { return m_panels; }
    QString shownClip() const override;
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
    /// How many pictures a second are reached.
    void measure();
    void showState();
    QString failedSpace(const Error& error) const;
    /// Shows its properties.
    void editSpace(const QString& name);
    void showPose();
    /// Its first take in the middle; null until it is drawn.
    QImage pictureOf(const QString& space);
    void showTimeline();
    void toggle();
    void toggleRecording();
    /// Keeps what is being recorded, if anything is.
    void finishRecording();
    /// Offers to do something with the performance that is played again, where there is one.
    void offerClip();
    void addSequence();

    EditorContext& m_context;
    SceneView* m_view;
    LiveSession* m_session;
    LiveKeys* m_keys;
    Gamepad* m_gamepad;
    LivePaths* m_paths;
    FramePictures* m_pictures;
    LiveBar* m_bar = nullptr;
    SteeringPanel* m_steering = nullptr;
    std::vector<Panel> m_panels;
    QString m_loaded;    ///< the performance that is played again
    QPointer<Job> m_job; ///< whose progress is followed
    QString m_help;      ///< the action behind the message's button
    QString m_failed;    ///< the motion space whose properties are behind it
    int m_shownTicks = 0;
    widgets::PaintedRate m_rate;
    QTimer m_gamepadPolls; ///< while nothing is played
    bool m_isActive = false;
};

} // namespace quadrille
