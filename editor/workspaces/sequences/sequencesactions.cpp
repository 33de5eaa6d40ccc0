// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of the workspace.
#include "editor/application/editorcontext.h"
#include "editor/playback/player.h"
#include "editor/playback/sequencestage.h"
#include "editor/workspaces/sequences/posecomparison.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "editor/workspaces/sequences/viewtools.h"
#include "widgets/viewport/viewport.h"

#include <QActionGroup>

namespace quadrille {

void SequencesWorkspace::makeEditActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto edit = [] { return tr("Edit"); };
    actions.add({"edit.trimStart", edit, [] { return tr("Trim &start to here"); }, {}, "trim", {Qt::Key_I}},
                [this] { m_sequenceTimeline->trimStartHere(); });
    actions.add({"edit.trimEnd", edit, [] { return tr("Trim &end to here"); }, {}, "trim", {Qt::Key_O}},
                [this] { m_sequenceTimeline->trimEndHere(); });
    actions.add({"edit.untrim", edit, [] { return tr("Use &all frames"); }, {}, "trim", {}},
                [this] { m_sequenceTimeline->removeTrim(); });
    actions.add({"edit.label", edit, [] { return tr("Add a &label"); }, {}, "label", {Qt::Key_M}},
                [this] { m_sequenceTimeline->addLabel(); });
}

void SequencesWorkspace::makePlaybackActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto play = [] { return tr("Playback"); };
    actions.add({"play.toggle", play, [] { return tr("&Play or pause"); }, {}, "play", {Qt::Key_Space}},
                [this] { m_player->toggle(); });
    actions.add({"play.previous", play, [] { return tr("P&revious frame"); }, {}, "stepback", {Qt::Key_Left}},
                [this] { m_player->step(-1); });
    actions.add({"play.next", play, [] { return tr("&Next frame"); }, {}, "step", {Qt::Key_Right}},
                [this] { m_player->step(1); });
    actions.add({"play.first", play, [] { return tr("&First frame"); }, {}, "first", {Qt::Key_Home}},
                [this] { m_player->goToStart(); });
    actions.add({"play.last", play, [] { return tr("&Last frame"); }, {}, "last", {Qt::Key_End}},
                [this] { m_player->goToEnd(); });
    actions.add(
        {"play.backwards", play, [] { return tr("Play &backwards, faster"); }, {}, "stepback", {Qt::Key_J}},
        [this] { m_player->shuttle(-1); });
    actions.add({"play.pause", play, [] { return tr("P&ause"); }, {}, "pause", {Qt::Key_K}},
                [this] { m_player->pause(); });
    actions.add({"play.forwards", play, [] { return tr("Play f&orwards, faster"); }, {}, "step", {Qt::Key_L}},
                [this] { m_player->shuttle(1); });
}

void SequencesWorkspace::makeViewActions()
{
    using widgets::Shading;
    using Tool = widgets::Viewport::Tool;
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    const auto shading = [this, view, &actions](const QString& id, ActionRegistry::Text text,
                                                const QString& icon, Shading mode) {
        return actions.addToggle({id, view, std::move(text), {}, icon, {}}, m_viewport->shading() == mode,
                                 [this, mode](bool) { m_viewport->setShading(mode); });
    };
    auto* shadings = new QActionGroup(this);
    shadings->addAction(shading(
        "view.textured", [] { return tr("&Textured"); }, "textured", Shading::Textured));
    shadings->addAction(shading(
        "view.clay", [] { return tr("&Clay"); }, "clay", Shading::Clay));
    shadings->addAction(shading(
        "view.wire", [] { return tr("&Wireframe"); }, "wire", Shading::Wireframe));
    m_comparison = new PoseComparison(m_context, *m_viewport, *m_stage, *shadings, this);
    actions.addToggle({"view.grid", view, [] { return tr("&Grid"); }, {}, "grid", {Qt::Key_G}},
                      m_viewport->isGridVisible(), [this](bool on) { m_viewport->setGridVisible(on); });
    actions.addToggle({"view.trajectory", view, [] { return tr("Trajector&y"); }, {}, "trajectory", {}}, true,
                      [this](bool on) { m_viewport->setTrajectoriesVisible(on); });
    actions.addToggle({"view.names", view, [] { return tr("&Names"); }, {}, "names", {}}, true,
                      [this](bool) { followNames(); });
    actions.addToggle({"view.ghosts", view, [] { return tr("G&hosts"); }, {}, "ghost", {Qt::Key_H}}, false,
                      [this](bool on) { m_stage->setGhostInterval(on ? m_tools->ghostInterval() : 0); });
    actions.addToggle({"view.measure", view, [] { return tr("&Measure"); }, {}, "measure", {}}, false,
                      [this](bool on) { m_viewport->setTool(on ? Tool::Measure : Tool::Navigate); });
    connect(m_viewport, &widgets::Viewport::toolChanged, actions.action("view.measure"),
            [measure = actions.action("view.measure")](Tool tool) {
                measure->setChecked(tool == Tool::Measure);
            });
    makeCameraActions();
    makeComparingActions();
}

void SequencesWorkspace::makeCameraActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    actions.addToggle({"view.follow", view, [] { return tr("&Follow the character"); }, {}, "follow", {}},
                      false, [this](bool) { followCharacter(); });
    actions.add({"view.frame", view, [] { return tr("Fra&me the selection"); }, {}, "frame", {Qt::Key_F}},
                [this] { m_viewport->frameFigure(m_stage->figureOf(m_context.selection.shownSequence())); });
    actions.add(
        {"view.frameAll", view, [] { return tr("Frame &all"); }, {}, "frameall", {Qt::SHIFT | Qt::Key_F}},
        [this] { m_viewport->frameAll(); });
    const auto look = [this, view, &actions](const QString& id, ActionRegistry::Text text,
                                             const QString& icon, Qt::Key key, widgets::StandardView side) {
        actions.add({id, view, std::move(text), {}, icon, {key}},
                    [this, side] { m_viewport->lookFrom(side); });
    };
    look(
        "view.front", [] { return tr("From the f&ront"); }, "viewfront", Qt::Key_1,
        widgets::StandardView::Front);
    look(
        "view.side", [] { return tr("From the &side"); }, "viewside", Qt::Key_3,
        widgets::StandardView::Right);
    look(
        "view.top", [] { return tr("From a&bove"); }, "viewtop", Qt::Key_7, widgets::StandardView::Top);
}

void SequencesWorkspace::makeComparingActions()
{
    using Layout = widgets::Viewport::Layout;
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    auto* layouts = new QActionGroup(this);
    layouts->addAction(
        actions.addToggle({"view.sideBySide", view, [] { return tr("Side by s&ide"); }, {}, "sidebyside", {}},
                          true, [this](bool on) {
                              if (on)
                                  setLayout(Layout::SideBySide);
                          }));
    layouts->addAction(actions.addToggle({"view.overlay",
                                          view,
                                          [] { return tr("&Overlaid"); },
                                          [] { return tr("Overlaid, each in a colour of its own"); },
                                          "overlay",
                                          {}},
                                         false, [this](bool on) {
                                             if (on)
                                                 setLayout(Layout::Overlay);
                                         }));
}

} // namespace quadrille
