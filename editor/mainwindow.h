// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/actionregistry.h"
#include "editor/application/autosave.h"
#include "editor/application/settings.h"
#include "editor/documents/projectdocument.h"
#include "editor/documents/selection.h"
#include "editor/documents/sequencemedia.h"
#include "editor/errors/issuelog.h"
#include "editor/jobs/jobrunner.h"
#include "editor/language/languagemanager.h"

#include <QMainWindow>

class QLabel;
class QMenu;
class QStackedWidget;
class QTreeView;

namespace quadrille {

class Player;
class ProjectFiles;
class ProjectTreeModel;
class SequenceStage;
class SequenceTimeline;
class WelcomePage;

namespace widgets {
class PlaybackBar;
class Timeline;
class Viewport;
} // namespace widgets

/// The window: puts document, views and actions together, and nothing else.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens what the command line or a drop names.
    void open(const QStringList& files);
    void openSample();

    ProjectDocument& document() { return m_document; }
    Player& player() { return *m_player; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCentre();
    void makeDocks();
    void makeActions();
    void makeViewActions();
    void makeMenus();
    void connectAll();
    void retranslate();
    void followDocument(const ChangeEvent& event);
    void followSelection();
    void followStage();
    void followRange();
    void showHelp();
    void showProblem(const QString& message);

    Settings m_settings;
    LanguageManager m_languages;
    JobRunner m_jobs;
    ProjectDocument m_document;
    Selection m_selection;
    SequenceMedia m_media;
    IssueLog m_issues;
    Autosave m_autosave;
    ActionRegistry m_actions;
    ProjectFiles* m_files = nullptr;

    QStackedWidget* m_pages = nullptr;
    WelcomePage* m_welcome = nullptr;
    widgets::Viewport* m_viewport = nullptr;
    widgets::Timeline* m_timeline = nullptr;
    widgets::PlaybackBar* m_bar = nullptr;
    SequenceStage* m_stage = nullptr;
    Player* m_player = nullptr;
    SequenceTimeline* m_sequenceTimeline = nullptr;
    ProjectTreeModel* m_treeModel = nullptr;
    QTreeView* m_tree = nullptr;
    QDockWidget* m_treeDock = nullptr;
    QDockWidget* m_historyDock = nullptr;
    QDockWidget* m_issuesDock = nullptr;
    QLabel* m_message = nullptr;
    std::vector<std::pair<QMenu*, std::function<QString()>>> m_menus;
    bool m_playsWhenReady = false;
};

} // namespace quadrille
