// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/timelineactions.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/view/framenotes.h"
#include "editor/workspaces/view/sceneview.h"
#include "editor/workspaces/view/timelinesettings.h"

#include <QMenu>

namespace quadrille {

using widgets::Timeline;

TimelineActions::TimelineActions(EditorContext& context, std::function<SceneView*()> view, QObject* parent)
    : QObject(parent), m_context(context), m_view(std::move(view))
{
    add(
        "play.andReturn", [] { return tr("Play from here and &return"); },
        [] { return tr("Plays from the playhead, which goes back there when it stops"); }, "play", Qt::Key_R,
        [](SceneView& front) { front.player().playAndReturn(); });
    add(
        "play.loopStart", [] { return tr("Loop from &here"); },
        [] { return tr("Lets the part that plays again and again begin at the playhead"); }, "loop",
        Qt::CTRL | Qt::ALT | Qt::Key_I,
        [](SceneView& front) { front.setLoopStart(front.timeline().currentFrame()); });
    add(
        "play.loopEnd", [] { return tr("Loop &up to here"); },
        [] { return tr("Lets the part that plays again and again end at the playhead"); }, "loop",
        Qt::CTRL | Qt::ALT | Qt::Key_O,
        [](SceneView& front) { front.setLoopEnd(front.timeline().currentFrame()); });
    add(
        "play.loopAll", [] { return tr("Play &everything again"); },
        [] { return tr("Takes the loop off the ruler"); }, "cancel", {},
        [](SceneView& front) { front.setLoop(std::nullopt); });
    add(
        "note.write", [] { return tr("&Write a note"); },
        [] { return tr("Writes something about the frame that is shown"); }, "label", Qt::SHIFT | Qt::Key_N,
        [](SceneView& front) {
            if (front.notes() != nullptr)
                front.notes()->write(front.timeline().currentFrame());
        });
    add(
        "note.previous", [] { return tr("Previous n&ote"); },
        [] { return tr("Goes to the note before the playhead"); }, "stepback", Qt::ALT | Qt::Key_PageUp,
        [](SceneView& front) {
            if (front.notes() != nullptr)
                front.notes()->goToNeighbour(-1);
        });
    add(
        "note.next", [] { return tr("Next no&te"); },
        [] { return tr("Goes to the note behind the playhead"); }, "step", Qt::ALT | Qt::Key_PageDown,
        [](SceneView& front) {
            if (front.notes() != nullptr)
                front.notes()->goToNeighbour(1);
        });
    ActionRegistry& actions = context.actions;
    const auto group = [] { return tr("Playback"); };
    actions.addToggle({"play.backAndForth",
                       group,
                       [] { return tr("Back an&d forth"); },
                       [] { return tr("What loops turns round at its ends instead of starting over"); },
                       "exchange",
                       {}},
                      playsBackAndForth(), [this](bool on) {
                          setPlaysBackAndForth(on);
                          follow();
                      });
    actions.addToggle({"play.seconds",
                       group,
                       [] { return tr("&Seconds on the ruler"); },
                       [] { return tr("Counts seconds on the ruler instead of frames"); },
                       "measure",
                       {}},
                      false, [this](bool on) {
                          if (SceneView* front = m_view())
                              front->setRulerUnit(on ? Timeline::Unit::Seconds : Timeline::Unit::Frames);
                      });
}

void TimelineActions::add(const char* id, const std::function<QString()>& text,
                          const std::function<QString()>& tip, const char* icon, const QKeySequence& key,
                          std::function<void(SceneView&)> run)
{
    m_context.actions.add({QLatin1String(id), [] { return tr("Playback"); }, text, tip, QLatin1String(icon),
                           key.isEmpty() ? QList<QKeySequence>() : QList{key}},
                          [this, run = std::move(run)] {
                              if (SceneView* front = m_view())
                                  run(*front);
                          });
}

void TimelineActions::follow()
{
    SceneView* front = m_view();
    if (front == nullptr)
        return;
    front->player().setBackAndForth(m_context.actions.action("play.backAndForth")->isChecked());
    m_context.actions.action("play.seconds")->setChecked(front->timeline().unit() == Timeline::Unit::Seconds);
    for (const char* id : {"note.write", "note.previous", "note.next"})
        m_context.actions.action(QLatin1String(id))->setEnabled(front->notes() != nullptr);
}

void addTimelineMenu(QMenu& menu, SceneView& view, const EditorContext& context, const QString& track,
                     int frame)
{
    const auto action = [&](const char* id) { menu.addAction(context.actions.action(QLatin1String(id))); };
    if (!menu.isEmpty())
        menu.addSeparator();
    action("play.andReturn");
    menu.addAction(TimelineActions::tr("Loop from here"), &view,
                   [&view, frame] { view.setLoopStart(frame); });
    menu.addAction(TimelineActions::tr("Loop up to here"), &view, [&view, frame] { view.setLoopEnd(frame); });
    if (view.timeline().loop())
        action("play.loopAll");
    action("play.backAndForth");
    menu.addSeparator();
    if (FrameNotes* notes = view.notes(); notes != nullptr && notes->isThere()) {
        menu.addAction(TimelineActions::tr("Write a note here"), &view,
                       [notes, frame] { notes->write(frame); });
        menu.addSeparator();
    }
    menu.addAction(TimelineActions::tr("Show all frames"), &view, [&view] { view.timeline().zoomToFit(); });
    action("play.seconds");
    if (track.isEmpty())
        return;
    const bool isFolded = view.timeline().isFolded(track);
    menu.addAction(isFolded ? TimelineActions::tr("Unfold the row") : TimelineActions::tr("Fold the row"),
                   &view, [&view, track, isFolded] { view.timeline().setFolded(track, !isFolded); });
}

} // namespace quadrille

#include "moc_timelineactions.cpp"
