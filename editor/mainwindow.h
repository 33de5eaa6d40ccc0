// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/application/autosave.h"
#include "editor/context/editorcontext.h"

#include <QMainWindow>

class QLabel;
class QMenu;
class QStackedWidget;
class QTimer;

namespace quadrille {

class AnimateWorkspace;
class AppearanceWorkspace;
class LiveWorkspace;
class TransferWorkspace;
class ExportFlow;
class GraphWorkspace;
class HelpFlow;
class ImportFlow;
class PictureFlow;
class ProjectFiles;
class ProjectStrips;
class RecoveryFlow;
class RelinkFlow;
class ResultsFlow;
class SampleFlow;
class SequencesWorkspace;
class SessionKeeper;
class StatusJobs;
class VariationsWorkspace;
class WelcomePage;
class Workspace;
class WorkspaceTabs;

namespace widgets {
class ActionPalette;
} // namespace widgets

/// The window: puts document, workspaces, docks and actions together, and nothing else.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens what the command line names: a project, or sequences.
    void open(const QStringList& files);
    /// Opens it to see a take play, as the tile of the welcome page does.
    void openSample();
    /// Says that settings or a session could not be used, and where they are now.
    void tellPutAside(const QString& file);
    /// Offers edits that a crash left unsaved.
    void offerRecovery();

    EditorContext& context() { return m_context; }
    WorkspaceTabs& workspaces() { return *m_workspaces; }
    SequencesWorkspace& sequences() { return *m_sequences; }
    GraphWorkspace& graph() { return *m_graph; }
    AnimateWorkspace& animate() { return *m_animate; }
    VariationsWorkspace& variations() { return *m_variations; }
    AppearanceWorkspace& appearance() { return *m_appearance; }
    TransferWorkspace& transfer() { return *m_transfer; }
    LiveWorkspace& live() { return *m_live; }
    PictureFlow& pictures() { return *m_pictures; }
    ProjectFiles& files() { return *m_files; }
    ProjectStrips& strips() { return *m_strips; }

    QMenu* createPopupMenu() override;

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// Null until there are workspaces.
    Workspace* workspaceInFront() const;
    void makeCentre();
    void makeDocks();
    void makeWorkspaces();
    QDockWidget* addDock(const char* name, std::function<QString()> title, QWidget* content,
                         Qt::DockWidgetArea area);
    void makeActions();
    void makeWindowActions();
    void makeThemeActions();
    void makeMenus();
    void connectAll();
    void connectFiles();
    void showTitle();
    void followDocument(const ChangeEvent& event);
    void showPalette();
    void openProjects(QStringList& files);
    void showMessage(const QString& message, const QStringList& files);
    void showProblem(const QString& message);

    EditorContext m_context;
    Autosave m_autosave;
    ProjectFiles* m_files;
    ImportFlow* m_import;
    WorkspaceTabs* m_workspaces = nullptr;
    ExportFlow* m_export;
    RelinkFlow* m_relink;
    ResultsFlow* m_results;
    RecoveryFlow* m_recovery = nullptr;
    ProjectStrips* m_strips = nullptr;
    QStackedWidget* m_pages = nullptr;
    WelcomePage* m_welcome = nullptr;
    SampleFlow* m_sample = nullptr;
    SequencesWorkspace* m_sequences = nullptr;
    GraphWorkspace* m_graph = nullptr;
    AnimateWorkspace* m_animate = nullptr;
    VariationsWorkspace* m_variations = nullptr;
    AppearanceWorkspace* m_appearance = nullptr;
    TransferWorkspace* m_transfer = nullptr;
    LiveWorkspace* m_live = nullptr;
    PictureFlow* m_pictures = nullptr;
    QList<QDockWidget*> m_docks;
    QDockWidget* m_propertiesDock = nullptr;
    QDockWidget* m_issuesDock = nullptr;
    QLabel* m_message = nullptr;
    QTimer* m_messagePasses = nullptr;
    StatusJobs* m_jobs = nullptr;
    SessionKeeper* m_session = nullptr;
    HelpFlow* m_help = nullptr;
    QMenu* m_panelMenu = nullptr;
    widgets::ActionPalette* m_palette = nullptr;
};

} // namespace quadrille
