// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/playback/clipscene.h"
#include "editor/playback/player.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

#include <QWidget>

class QSplitter;
class QVBoxLayout;

namespace quadrille {

class FrameNotes;
class ViewTools;
struct EditorContext;

namespace widgets {
class MessageStrip;
class PlaybackBar;
} // namespace widgets

/// A viewport with its tools above a timeline with its buttons: where a workspace shows clips and plays them.
/// The actions of the menus View and Playback act on the one that is in front (see ViewActions).
class SceneView : public QWidget
{
    Q_OBJECT

public:
    /// \param name  what the object names of its parts begin with; may be empty.
    SceneView(EditorContext& context, ClipScene::Source source, const QString& name,
              QWidget* parent = nullptr);

    widgets::Viewport& viewport() { return *m_viewport; }
    widgets::Timeline& timeline() { return *m_timeline; }
    widgets::PlaybackBar& playback() { return *m_bar; }
    ClipScene& scene() { return *m_scene; }
    Player& player() { return *m_player; }
    widgets::MessageStrip& message() { return *m_message; }
    ViewTools& tools() { return *m_tools; }
    /// Puts a widget below the timeline. It becomes the view's.
    void addBelowTimeline(QWidget* widget);
    /// Puts a widget at the right of the viewport, above the timeline. It becomes the view's.
    void addBeside(QWidget* widget);

    /// Shows these clips; the last is what following and framing are about unless setCurrent says another.
    void show(const QStringList& names);
    using QWidget::show;
    void setCurrent(const QString& name);
    /// Takes the frames that play from the timeline.
    void updateRange();
    /// The part of the frames that plays again and again; none: all that plays. Frames of the timeline, both
    /// included. A part switches looping on, in the settings too.
    void setLoop(std::optional<std::pair<int, int>> loop);
    /// Begins the part there; it ends where what plays ended, or there as well. So for its end.
    void setLoopStart(int frame);
    void setLoopEnd(int frame);
    /// What the ruler counts as long as the user has not chosen. Their choice for this timeline is kept on
    /// this computer.
    void setUsualUnit(widgets::Timeline::Unit unit);
    /// What the user chose, remembered for this timeline.
    void setRulerUnit(widgets::Timeline::Unit unit);
    /// Puts the playhead, and the number beside the buttons, where no clip needs to be.
    void setPlayhead(int frame);
    /// What plays has so many pictures a second: they are drawn as well as there is time for. The project's
    /// rate until then.
    void setPictureRate(double picturesPerSecond);
    /// Where on the timeline the first frame is of what is shown in place of its clip; 0 for the clip itself.
    void setTimelineOffset(int frames) { m_timelineOffset = frames; }
    /// What is written about the frames that are shown; null where nothing can be.
    void setNotes(FrameNotes* notes) { m_notes = notes; }
    FrameNotes* notes() const { return m_notes; }
    /// Plays the next clip that is shown as soon as it is ready.
    void playWhenReady() { m_playsWhenReady = true; }

    void setNamesShown(bool shown);
    /// Lets the camera go along with the current clip.
    void setFollowing(bool follows);
    /// Ghosts are as far apart as the tools say.
    void setGhostsShown(bool shown);
    /// All clips are framed anew.
    void setLayoutMode(widgets::Viewport::Layout layout);
    /// Brings all of the current clip into the view.
    void frameCurrent();
    /// A tool colours figures, whatever the menu says; or does so no longer.
    void setColoredByTool(bool colored);
    bool isColoredByTool() const { return m_isColoredByTool; }

signals:
    /// Clips came, went or changed their length; the timeline has not followed yet.
    void sceneChanged();
    /// Textures would look alike where figures stand in one place: clay has a colour for each.
    void clayRequested();
    void coloredByToolChanged();

private:
    void arrangeWidgets();
    void connectPlayback();
    void followName(const ChangeEvent& event);
    void connectTimeline();
    void followDocument();
    void followSettings();
    void showPlayhead();
    void followScene();
    void followCharacter();
    void updateNames();

    EditorContext& m_context;
    widgets::Viewport* m_viewport;
    widgets::Timeline* m_timeline;
    widgets::PlaybackBar* m_bar;
    ClipScene* m_scene;
    Player* m_player;
    widgets::MessageStrip* m_message;
    ViewTools* m_tools;
    QVBoxLayout* m_lower = nullptr;
    QSplitter* m_beside = nullptr;
    QString m_current;
    int m_timelineOffset = 0; ///< frames
    bool m_namesShown = true;
    bool m_follows = false;
    bool m_ghostsShown = false;
    bool m_playsWhenReady = false;
    bool m_isColoredByTool = false;
    QStringList m_names; ///< of the clips that are shown
    FrameNotes* m_notes = nullptr;
};

} // namespace quadrille
