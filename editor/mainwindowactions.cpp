// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The actions of the window.
#include "editor/application/projectfiles.h"
#include "editor/application/recentmenu.h"
#include "editor/docks/statusjobs.h"
#include "editor/mainwindow.h"
#include "editor/preferences/aboutdialog.h"
#include "editor/preferences/preferencesdialog.h"
#include "widgets/controls/actionpalette.h"
#include "widgets/theme/theme.h"

#include <QActionGroup>
#include <QDockWidget>

namespace quadrille {

void MainWindow::makeActions()
{
    ActionRegistry& actions = m_context.actions;
    const auto file = [] { return tr("File"); };
    actions.add({"file.new", file, [] { return tr("&New"); }, {}, "new", {QKeySequence::New}},
                [this] { m_files->newProject(); });
    actions.add({"file.open", file, [] { return tr("&Open…"); }, {}, "open", {QKeySequence::Open}},
                [this] { m_files->askOpen(); });
    auto* recent = new RecentMenu(m_context.settings, this);
    connect(recent, &RecentMenu::projectAsked, this,
            [this](const QString& chosen) { m_files->open(chosen); });
    actions.add({"file.recent", file, [] { return tr("Open &recent"); }, {}, "history", {}}, [] {})
        ->setMenu(recent);
    actions.add({"file.sample", file, [] { return tr("Open the &sample"); }, {}, "character", {}},
                [this] { openSample(); });
    actions.add({"file.save", file, [] { return tr("&Save"); }, {}, "save", {QKeySequence::Save}},
                [this] { m_files->save(); });
    actions.add({"file.saveAs", file, [] { return tr("Save &as…"); }, {}, "save", {QKeySequence::SaveAs}},
                [this] { m_files->saveAs(); });
    actions.add({"file.quit", file, [] { return tr("&Quit"); }, {}, "close", {QKeySequence::Quit}},
                [this] { close(); });
    const auto edit = [] { return tr("Edit"); };
    actions.add({"edit.undo", edit, [] { return tr("&Undo"); }, {}, "undo", {QKeySequence::Undo}},
                [this] { m_context.document.undo(); });
    actions.add({"edit.redo",
                 edit,
                 [] { return tr("&Redo"); },
                 {},
                 "redo",
                 {QKeySequence::Redo, QKeySequence(Qt::CTRL | Qt::Key_Y)}},
                [this] { m_context.document.redo(); });
    actions.add({"edit.preferences",
                 edit,
                 [] { return tr("&Preferences…"); },
                 [] { return tr("Theme, language, copies, shortcuts"); },
                 "settings",
                 {QKeySequence(Qt::CTRL | Qt::Key_Comma)}},
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
    actions.add({"help.manual",
                 [] { return tr("Help"); },
                 [] { return tr("&Manual"); },
                 {},
                 "help",
                 {QKeySequence::HelpContents}},
                [this] { showHelp(); });
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
    for (const QDockWidget* dock : m_docks)
        entries.push_back({dock->toggleViewAction(), tr("View")});
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
