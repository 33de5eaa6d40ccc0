// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of the window.
#include "editor/application/projectfiles.h"
#include "editor/application/recentmenu.h"
#include "editor/application/standardkeys.h"
#include "editor/docks/statusjobs.h"
#include "editor/fields/rightmenu.h"
#include "editor/help/helpflow.h"
#include "editor/mainwindow.h"
#include "editor/preferences/aboutdialog.h"
#include "editor/preferences/preferencesdialog.h"
#include "editor/workspaces/workspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "widgets/controls/actionpalette.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/viewport.h"

#include <QActionGroup>
#include <QMenu>
#include <QUndoView>

namespace quadrille {

namespace {

constexpr float zoomStep = 0.8F; ///< of the distance

} // namespace

void MainWindow::makeActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto file = [] { return tr("File"); };
    actions.add({"file.new", file, [] { return tr("&New"); }, {}, "new", standardKeys(QKeySequence::New)},
                [this] { m_files->newProject(); });
    actions.add(
        {"file.open", file, [] { return tr("&Open…"); }, {}, "open", standardKeys(QKeySequence::Open)},
        [this] { m_files->askOpen(); });
    auto* recent = new RecentMenu(m_context.settings, this);
    connect(recent, &RecentMenu::projectRequested, this,
            [this](const QString& chosen) { m_files->open(chosen); });
    actions.add({"file.recent", file, [] { return tr("Open &recent"); }, {}, "history", {}}, [] {})
        ->setMenu(recent);
    actions.add({"file.sample", file, [] { return tr("Open the &sample"); }, {}, "character", {}},
                [this] { openSample(); });
    actions.add({"file.save", file, [] { return tr("&Save"); }, {}, "save", standardKeys(QKeySequence::Save)},
                [this] { m_files->save(); });
    actions.add(
        {"file.saveAs", file, [] { return tr("Save &as…"); }, {}, "save", standardKeys(QKeySequence::SaveAs)},
        [this] { m_files->saveAs(); });
    actions.add({"file.close",
                 file,
                 [] { return tr("&Close the project"); },
                 [] { return tr("Close the project and go back to the beginning"); },
                 {},
                 standardKeys(QKeySequence::Close)},
                [this] { m_files->newProject(); });
    actions.add(
        {"file.quit", file, [] { return tr("&Quit"); }, {}, "close", standardKeys(QKeySequence::Quit)},
        [this] { close(); });
    const auto edit = [] { return tr("Edit"); };
    actions.add({"edit.undo", edit, [] { return tr("&Undo"); }, {}, "undo", standardKeys(QKeySequence::Undo)},
                [this] { m_context.document.undo(); });
    actions.add({"edit.redo", edit, [] { return tr("&Redo"); }, {}, "redo", standardKeys(QKeySequence::Redo)},
                [this] { m_context.document.redo(); });
    addRightMenu(*findChild<QUndoView*>(), {actions.action("edit.undo"), actions.action("edit.redo")});
    actions.add({"edit.properties",
                 edit,
                 [] { return tr("Pr&operties"); },
                 [] { return tr("Shows the properties of what is selected in the project"); },
                 "info",
                 {QKeySequence(Qt::ALT | Qt::Key_Return)}},
                [this] {
                    m_propertiesDock->show();
                    m_propertiesDock->raise();
                });
    actions.add({"edit.preferences", edit, [] { return tr("&Preferences…"); },
                 [] { return tr("Theme, language, copies, shortcuts"); }, "settings",
                 standardKeys(QKeySequence::Preferences)},
                [this] { (new PreferencesDialog(m_context, this))->open(); });
    actions.add({"view.jobs",
                 [] { return tr("View"); },
                 [] { return tr("&Running jobs"); },
                 [] { return tr("Lists what is being worked on, each with a button that cancels it"); },
                 "stop",
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J)}},
                [this] { m_jobs->showJobs(); });
    const auto help = [] { return tr("Help"); };
    actions.add({"help.palette",
                 help,
                 [] { return tr("&Find an action…"); },
                 [] { return tr("Find any action by its name and run it"); },
                 "search",
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P)}},
                [this] { showPalette(); });
    actions.add({"help.about", help, [] { return tr("&About Quadrille"); }, {}, "info", {}},
                [this] { (new AboutDialog(this))->open(); });
    m_help = new HelpFlow(actions, *this);
    makeWindowActions();
}

void MainWindow::makeWindowActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    actions.addToggle({"view.fullScreen",
                       view,
                       [] { return tr("F&ull screen"); },
                       [] { return tr("Fill the screen with the window, and back"); },
                       {},
                       standardKeys(QKeySequence::FullScreen)},
                      false,
                      [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
    const auto zoom = [this](float factor) {
        widgets::Viewport& viewport = m_workspaces->currentWorkspace()->viewport();
        widgets::Turntable camera = viewport.camera();
        camera.zoom(factor, QRectF(viewport.rect()).center(), viewport.size());
        viewport.setCamera(camera);
    };
    actions.add({"view.zoomIn",
                 view,
                 [] { return tr("Come &closer"); },
                 [] { return tr("Move the camera towards what it looks at"); },
                 {},
                 standardKeys(QKeySequence::ZoomIn)},
                [zoom] { zoom(zoomStep); });
    actions.add({"view.zoomOut",
                 view,
                 [] { return tr("Go f&arther"); },
                 [] { return tr("Move the camera away from what it looks at"); },
                 {},
                 standardKeys(QKeySequence::ZoomOut)},
                [zoom] { zoom(1 / zoomStep); });
}

void MainWindow::showPalette()
{
    if (m_palette == nullptr)
        m_palette = new widgets::ActionPalette(this);
    std::vector<widgets::ActionPalette::Entry> entries;
    for (QAction* action : m_context.actions.actions()) {
        if (action->menu() == nullptr)
            entries.push_back({action, m_context.actions.group(action)});
    }
    for (QAction* panel : m_panelMenu->actions()) {
        if (panel->isVisible())
            entries.push_back({panel, tr("Panel")});
    }
    m_palette->ask(entries);
}

void MainWindow::makeThemeActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto view = [] { return tr("View"); };
    using Mode = widgets::Theme::Mode;
    auto* themes = new QActionGroup(this);
    const auto theme = [this, view, themes, &actions](const QString& id, ActionRegistry::Text text,
                                                      Mode mode) {
        themes->addAction(actions.addToggle({id, view, std::move(text), {}, "settings", {}},
                                            m_context.settings.theme() == mode, [this, mode](bool on) {
                                                if (!on)
                                                    return;
                                                m_context.settings.setTheme(mode);
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

} // namespace quadrille
