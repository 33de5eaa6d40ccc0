// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of the window and the menus that hold them.
#include "editor/application/projectfiles.h"
#include "editor/mainwindow.h"
#include "editor/playback/player.h"
#include "editor/playback/sequencestage.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/viewport.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMenuBar>

namespace quadrille {

void MainWindow::makeActions()
{
    const auto file = [] { return tr("File"); };
    m_actions.add({"file.new", file, [] { return tr("&New"); }, {}, "new", {QKeySequence::New}},
                  [this] { m_files->newProject(); });
    m_actions.add({"file.open", file, [] { return tr("&Open…"); }, {}, "open", {QKeySequence::Open}},
                  [this] { m_files->askOpen(); });
    m_actions.add({"file.sample", file, [] { return tr("Open the &sample"); }, {}, "character", {}},
                  [this] { openSample(); });
    m_actions.add({"file.import",
                   file,
                   [] { return tr("&Bring in sequences…"); },
                   {},
                   "import",
                   {QKeySequence(Qt::CTRL | Qt::Key_I)}},
                  [this] { m_files->askImport(); });
    m_actions.add({"file.save", file, [] { return tr("&Save"); }, {}, "save", {QKeySequence::Save}},
                  [this] { m_files->save(); });
    m_actions.add({"file.saveAs", file, [] { return tr("Save &as…"); }, {}, "save", {QKeySequence::SaveAs}},
                  [this] { m_files->saveAs(); });
    m_actions.add({"file.quit", file, [] { return tr("&Quit"); }, {}, "close", {QKeySequence::Quit}},
                  [this] { close(); });
    const auto edit = [] { return tr("Edit"); };
    m_actions.add({"edit.undo", edit, [] { return tr("&Undo"); }, {}, "undo", {QKeySequence::Undo}},
                  [this] { m_document.undo(); });
    m_actions.add({"edit.redo",
                   edit,
                   [] { return tr("&Redo"); },
                   {},
                   "redo",
                   {QKeySequence::Redo, QKeySequence(Qt::CTRL | Qt::Key_Y)}},
                  [this] { m_document.redo(); });
    m_actions.add({"edit.trimStart", edit, [] { return tr("Trim &start to here"); }, {}, "trim", {Qt::Key_I}},
                  [this] { m_sequenceTimeline->trimStartHere(); });
    m_actions.add({"edit.trimEnd", edit, [] { return tr("Trim &end to here"); }, {}, "trim", {Qt::Key_O}},
                  [this] { m_sequenceTimeline->trimEndHere(); });
    m_actions.add({"edit.untrim", edit, [] { return tr("Use &all frames"); }, {}, "trim", {}},
                  [this] { m_sequenceTimeline->removeTrim(); });
    m_actions.add({"edit.label", edit, [] { return tr("Add a &label"); }, {}, "label", {Qt::Key_M}},
                  [this] { m_sequenceTimeline->addLabel(); });
    const auto play = [] { return tr("Playback"); };
    m_actions.add({"play.toggle", play, [] { return tr("&Play or pause"); }, {}, "play", {Qt::Key_Space}},
                  [this] { m_player->toggle(); });
    m_actions.add(
        {"play.previous", play, [] { return tr("P&revious frame"); }, {}, "stepback", {Qt::Key_Left}},
        [this] { m_player->step(-1); });
    m_actions.add({"play.next", play, [] { return tr("&Next frame"); }, {}, "step", {Qt::Key_Right}},
                  [this] { m_player->step(1); });
    m_actions.add({"play.first", play, [] { return tr("&First frame"); }, {}, "first", {Qt::Key_Home}},
                  [this] { m_player->goToStart(); });
    m_actions.add({"play.last", play, [] { return tr("&Last frame"); }, {}, "last", {Qt::Key_End}},
                  [this] { m_player->goToEnd(); });
    m_actions.add(
        {"play.backwards", play, [] { return tr("Play &backwards, faster"); }, {}, "stepback", {Qt::Key_J}},
        [this] { m_player->shuttle(-1); });
    m_actions.add({"play.pause", play, [] { return tr("P&ause"); }, {}, "pause", {Qt::Key_K}},
                  [this] { m_player->pause(); });
    m_actions.add(
        {"play.forwards", play, [] { return tr("Play f&orwards, faster"); }, {}, "step", {Qt::Key_L}},
        [this] { m_player->shuttle(1); });
    m_actions.add({"help.manual",
                   [] { return tr("Help"); },
                   [] { return tr("&Manual"); },
                   {},
                   "help",
                   {QKeySequence::HelpContents}},
                  [this] { showHelp(); });
}

void MainWindow::makeViewActions()
{
    using widgets::Shading;
    const auto view = [] { return tr("View"); };
    const auto shading = [this, view](const QString& id, ActionRegistry::Text text, const QString& icon,
                                      Shading mode) {
        return m_actions.addToggle({id, view, std::move(text), {}, icon, {}}, m_viewport->shading() == mode,
                                   [this, mode](bool) { m_viewport->setShading(mode); });
    };
    auto* shadings = new QActionGroup(this);
    shadings->addAction(shading(
        "view.textured", [] { return tr("&Textured"); }, "textured", Shading::Textured));
    shadings->addAction(shading(
        "view.clay", [] { return tr("&Clay"); }, "clay", Shading::Clay));
    shadings->addAction(shading(
        "view.wire", [] { return tr("&Wireframe"); }, "wire", Shading::Wireframe));
    m_actions.addToggle({"view.grid", view, [] { return tr("&Grid"); }, {}, "grid", {Qt::Key_G}},
                        m_viewport->isGridVisible(), [this](bool on) { m_viewport->setGridVisible(on); });
    m_actions.addToggle({"view.follow", view, [] { return tr("&Follow the character"); }, {}, "follow", {}},
                        false, [this](bool on) {
                            const int figure = m_stage->figureOf(m_selection.shownSequence());
                            m_viewport->setFollowed(on && figure >= 0 ? std::optional(figure) : std::nullopt);
                        });
    m_actions.addToggle({"view.ghosts", view, [] { return tr("G&hosts every 10 frames"); }, {}, "ghost", {}},
                        false, [this](bool on) { m_stage->setGhostInterval(on ? 10 : 0); });
    m_actions.addToggle(
        {"view.measure", view, [] { return tr("&Measure"); }, {}, "measure", {}}, false, [this](bool on) {
            m_viewport->setTool(on ? widgets::Viewport::Tool::Measure : widgets::Viewport::Tool::Navigate);
        });
    m_actions.add({"view.frame", view, [] { return tr("Frame &all"); }, {}, "frame", {Qt::Key_F}},
                  [this] { m_viewport->frameAll(); });
    const auto look = [this, view](const QString& id, ActionRegistry::Text text, Qt::Key key,
                                   widgets::StandardView side) {
        m_actions.add({id, view, std::move(text), {}, "camera", {key}},
                      [this, side] { m_viewport->lookFrom(side); });
    };
    look(
        "view.front", [] { return tr("From the f&ront"); }, Qt::Key_1, widgets::StandardView::Front);
    look(
        "view.side", [] { return tr("From the &side"); }, Qt::Key_3, widgets::StandardView::Left);
    look(
        "view.top", [] { return tr("From a&bove"); }, Qt::Key_7, widgets::StandardView::Top);

    using Mode = widgets::Theme::Mode;
    auto* themes = new QActionGroup(this);
    const auto theme = [this, view, themes](const QString& id, ActionRegistry::Text text, Mode mode) {
        themes->addAction(m_actions.addToggle({id, view, std::move(text), {}, "settings", {}},
                                              m_settings.theme() == mode, [this, mode](bool on) {
                                                  if (!on)
                                                      return;
                                                  m_settings.setTheme(mode);
                                                  widgets::Theme::instance().setMode(mode);
                                              }));
    };
    theme(
        "theme.system", [] { return tr("Theme of the s&ystem"); }, Mode::System);
    theme(
        "theme.light", [] { return tr("&Light theme"); }, Mode::Light);
    theme(
        "theme.dark", [] { return tr("&Dark theme"); }, Mode::Dark);
}

void MainWindow::makeMenus()
{
    const auto addMenu = [this](std::function<QString()> title, const QStringList& actions) {
        QMenu* menu = menuBar()->addMenu(QString());
        m_menus.emplace_back(menu, std::move(title));
        for (const QString& id : actions) {
            if (id.isEmpty())
                menu->addSeparator();
            else
                menu->addAction(m_actions.action(id));
        }
        return menu;
    };
    addMenu([] { return tr("&File"); }, {"file.new", "file.open", "file.sample", "", "file.import", "",
                                         "file.save", "file.saveAs", "", "file.quit"});
    addMenu([] { return tr("&Edit"); },
            {"edit.undo", "edit.redo", "", "edit.trimStart", "edit.trimEnd", "edit.untrim", "edit.label"});
    QMenu* view = addMenu([] { return tr("&View"); },
                          {"view.textured", "view.clay", "view.wire", "", "view.grid", "view.follow",
                           "view.ghosts", "view.measure", "", "view.frame", "view.front", "view.side",
                           "view.top", "", "theme.system", "theme.light", "theme.dark", ""});
    for (QDockWidget* dock : {m_treeDock, m_historyDock, m_issuesDock})
        view->addAction(dock->toggleViewAction());
    addMenu([] { return tr("&Playback"); },
            {"play.toggle", "", "play.previous", "play.next", "play.first", "play.last", "", "play.backwards",
             "play.pause", "play.forwards"});
    QMenu* languages = addMenu([] { return tr("&Language"); }, {});
    auto* group = new QActionGroup(this);
    for (const Language& language : LanguageManager::languages()) {
        QAction* action = languages->addAction(language.name);
        action->setCheckable(true);
        action->setChecked(language.code == m_languages.language());
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, code = language.code] {
            m_settings.setLanguage(code);
            m_languages.setLanguage(code);
        });
    }
    addMenu([] { return tr("&Help"); }, {"help.manual"});
    addActions(m_actions.actions());
}

} // namespace quadrille
