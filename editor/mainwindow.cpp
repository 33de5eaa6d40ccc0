// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/mainwindow.h"

#include "editor/application/focuskeys.h"
#include "editor/application/menus.h"
#include "editor/application/projectfiles.h"
#include "editor/application/recoveryflow.h"
#include "editor/application/sessionkeeper.h"
#include "editor/docks/cardspanel.h"
#include "editor/docks/projectpanel.h"
#include "editor/docks/statusjobs.h"
#include "editor/docks/texturepanel.h"
#include "editor/errors/errortext.h"
#include "editor/errors/issuespanel.h"
#include "editor/exporting/exportflow.h"
#include "editor/exporting/pictureflow.h"
#include "editor/help/helpviewer.h"
#include "editor/importing/importflow.h"
#include "editor/language/retranslate.h"
#include "editor/playback/player.h"
#include "editor/properties/propertiespanel.h"
#include "editor/relinking/relinkflow.h"
#include "editor/welcome/welcomepage.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/keysandstoryboard.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/variations/variationsworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QHash>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QUndoView>
#include <QVBoxLayout>

namespace quadrille {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent)
    , m_autosave(m_context.document, m_context.jobs)
    , m_files(
          new ProjectFiles(m_context.document, m_context.jobs, m_context.issues, m_context.settings, this))
    , m_import(new ImportFlow(m_context, this))
    , m_export(new ExportFlow(m_context, this))
    , m_relink(new RelinkFlow(m_context, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowIcon(widgets::icons::application());
    setAcceptDrops(true);
    new FocusKeys(this);
    resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    makeCentre();
    makeDocks();
    makeWorkspaces();
    makeActions();
    makeThemeActions();
    makeMenus();
    connectAll();
    m_autosave.setInterval(m_context.settings.autosaveSeconds());
    restoreWindow(*this, m_context.settings.windowGeometry());
    m_workspaces->setStates(m_context.settings.docks());
    m_workspaces->begin();
    followDocument(ChangeEvent::reset());
    m_session = new SessionKeeper(m_context, *m_workspaces, *m_sequences, *this);
}

MainWindow::~MainWindow()
{
    // What is shown looks at the context, which would go before it; nothing is to be told any more.
    hide();
    m_context.document.blockSignals(true);
    m_context.document.undoStack()->blockSignals(true);
    m_context.jobs.blockSignals(true);
    qDeleteAll(m_docks);
    delete takeCentralWidget();
    delete statusBar();
}

void MainWindow::open(const QStringList& files)
{
    m_sequences->view().playWhenReady();
    QStringList sequences = files;
    openProjects(sequences);
    if (!sequences.isEmpty())
        m_import->open(sequences);
}

void MainWindow::offerRecovery()
{
    (new RecoveryFlow(m_context, m_autosave, this))->offer();
}

/// Opens the projects among some files and takes them out.
void MainWindow::openProjects(QStringList& files)
{
    for (const QString& file : files) {
        if (ProjectFiles::isProject(file))
            m_files->open(file);
    }
    files.removeIf(ProjectFiles::isProject);
}

void MainWindow::openSample()
{
    m_sequences->view().playWhenReady();
    m_files->openSample();
}

void MainWindow::makeCentre()
{
    m_welcome = new WelcomePage(m_context.settings);
    m_workspaces = new WorkspaceTabs(m_context, *this);
    m_pictures = new PictureFlow(
        m_context, [this] { return &m_workspaces->currentWorkspace()->viewport(); }, this);
    m_sequences = new SequencesWorkspace(m_context);
    m_graph = new GraphWorkspace(m_context);
    m_animate = new AnimateWorkspace(m_context);
    m_variations = new VariationsWorkspace(m_context);
    m_animate->keysAndStoryboard().setShownPose(
        [this] { return m_workspaces->currentWorkspace()->shownPose(); });
    m_pages = new QStackedWidget;
    m_pages->addWidget(m_welcome);
    m_pages->addWidget(m_workspaces);
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_relink->strip());
    column->addWidget(m_pages, 1);
    setCentralWidget(centre);

    m_message = new QLabel;
    m_message->setObjectName(QStringLiteral("message"));
    statusBar()->addWidget(m_message, 1);
    m_jobs = new StatusJobs(m_context.jobs);
    statusBar()->addPermanentWidget(m_jobs);
}

QDockWidget* MainWindow::addDock(const char* name, std::function<QString()> title, QWidget* content,
                                 Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(this);
    dock->setObjectName(QLatin1String(name));
    dock->setWidget(content);
    addDockWidget(area, dock);
    retranslates(dock, [dock, title = std::move(title)] { dock->setWindowTitle(title()); });
    m_docks += dock;
    return dock;
}

void MainWindow::makeDocks()
{
    auto* project = addDock(
        "projectDock", [] { return tr("Project"); }, new ProjectPanel(m_context), Qt::LeftDockWidgetArea);
    m_propertiesDock = addDock(
        "propertiesDock", [] { return tr("Properties"); }, new PropertiesPanel(m_context),
        Qt::RightDockWidgetArea);
    auto* cards = addDock(
        "cardsDock", [] { return tr("Cards"); }, new CardsPanel(m_context), Qt::LeftDockWidgetArea);
    tabifyDockWidget(project, cards);
    project->raise();
    auto* history = addDock(
        "historyDock", [] { return tr("History"); }, new QUndoView(m_context.document.undoStack()),
        Qt::RightDockWidgetArea);
    m_issuesDock = addDock(
        "issuesDock", [] { return tr("Issues"); }, new IssuesPanel(m_context.issues),
        Qt::BottomDockWidgetArea);
    auto* texture = addDock(
        "textureDock", [] { return tr("Texture"); }, new TexturePanel(m_context, m_sequences->stage()),
        Qt::RightDockWidgetArea);
    splitDockWidget(m_propertiesDock, texture, Qt::Vertical);
    tabifyDockWidget(m_propertiesDock, history);
    m_propertiesDock->raise();
    history->hide();
    texture->hide();
    m_issuesDock->hide();
    resizeDocks({project, m_propertiesDock}, {240, 280}, Qt::Horizontal);
}

void MainWindow::makeWorkspaces()
{
    const auto add = [this](const char* id, ActionRegistry::Text title, Workspace* workspace) {
        QList<QDockWidget*> docks;
        QHash<Qt::DockWidgetArea, QDockWidget*> firstOf;
        QDockWidget* lower = nullptr;
        for (const Workspace::Panel& panel : workspace->panels()) {
            docks += addDock(panel.name, panel.title, panel.content, panel.area);
            docks.back()->setProperty("isShownFirst", panel.isShown);
            if (panel.isLower) {
                // Docks that share a place cannot be split: the one below them can be shared.
                docks.back()->setProperty("isLower", true);
                tabifyDockWidget(findChild<QDockWidget*>(QStringLiteral("textureDock")), docks.back());
                if (lower == nullptr)
                    lower = docks.back();
                continue;
            }
            // Side by side they would be too low to be of use.
            if (panel.area == Qt::RightDockWidgetArea)
                tabifyDockWidget(findChild<QDockWidget*>(QStringLiteral("propertiesDock")), docks.back());
            QDockWidget*& first = firstOf[panel.area];
            if (first != nullptr)
                tabifyDockWidget(first, docks.back());
            else
                first = docks.back();
        }
        for (QDockWidget* first : std::as_const(firstOf))
            first->raise();
        if (lower != nullptr)
            lower->raise();
        // Its own panels take the place of the properties.
        m_workspaces->add({QLatin1String(id), std::move(title), workspace, docks,
                           firstOf.contains(Qt::RightDockWidgetArea)});
    };
    m_workspaces->setPropertiesDock(m_propertiesDock);
    add(
        "sequences", [] { return tr("&Sequences"); }, m_sequences);
    add(
        "graph", [] { return tr("&Graph"); }, m_graph);
    add(
        "animate", [] { return tr("&Animate"); }, m_animate);
    add(
        "variations", [] { return tr("&Variations"); }, m_variations);
}

void MainWindow::makeMenus()
{
    QList<QAction*> toggles;
    for (QDockWidget* dock : m_docks)
        toggles += dock->toggleViewAction();
    new Menus(m_context, toggles, *this);
}

void MainWindow::connectAll()
{
    retranslates(this, [this] {
        setLocale(QLocale()); // numbers as the language writes them
        showTitle();
    });
    connect(&m_context.document, &ProjectDocument::changed, this, &MainWindow::followDocument);
    connect(m_context.document.undoStack(), &QUndoStack::indexChanged, this,
            [this] { followDocument(ChangeEvent::file()); });
    connect(&m_context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        const auto* medium = m_context.media.medium(name);
        m_context.issues.clear(name);
        if (medium && medium->error)
            m_context.issues.add(*medium->error, name);
    });
    connect(m_import, &ImportFlow::imported, this,
            [this](const QStringList& names) { m_context.selection.selectSequences(names.mid(0, 1)); });
    connect(m_export, &ExportFlow::exported, this, [this](const QStringList& files) {
        showMessage(tr("Exported to %1").arg(files.value(0)), files);
        m_context.variations.readStopped();
    });
    connect(m_variations, &VariationsWorkspace::exportAsked, this,
            [this](const QString& clip) { m_export->exportClips({clip}); });
    connect(m_pictures, &PictureFlow::saved, this,
            [this](const QStringList& files) { showMessage(tr("Saved to %1").arg(files.value(0)), files); });
    connect(m_import, &ImportFlow::failed, this, [this](const Error& error) {
        m_context.issues.add(error);
        showProblem(describe(error).oneLine());
    });
    connect(m_files, &ProjectFiles::aboutToLeave, this, [this] { m_session->keep(); });
    connect(m_files, &ProjectFiles::saved, this, [this] {
        m_session->keep();
        m_relink->noteContents();
    });
    connect(m_relink, &RelinkFlow::relinked, this,
            [this](int media) { m_message->setText(tr("%n file(s) were relinked", nullptr, media)); });
    connect(&m_context.settings, &Settings::changed, this, [this] {
        m_autosave.setInterval(m_context.settings.autosaveSeconds());
        m_context.document.setHistoryBytes(static_cast<std::size_t>(m_context.settings.historyMegabytes())
                                           << 20U);
    });
    connect(m_files, &ProjectFiles::failed, this, &MainWindow::showProblem);
    connect(&m_context.jobs, &JobRunner::failed, this, [this](Job*, const Error& error) {
        m_context.issues.add(error);
        showProblem(describe(error).oneLine());
    });
    connect(m_welcome, &WelcomePage::actionAsked, this,
            [this](const QString& id) { m_context.actions.action(id)->trigger(); });
    connect(m_welcome, &WelcomePage::projectAsked, this, [this](const QString& file) { open({file}); });
}

void MainWindow::showTitle()
{
    setWindowTitle(m_context.document.title() + QStringLiteral("[*] – Quadrille"));
}

void MainWindow::followDocument(const ChangeEvent& event)
{
    ProjectDocument& document = m_context.document;
    showTitle();
    setWindowModified(document.isModified());
    m_context.actions.action("edit.undo")->setEnabled(document.canUndo());
    m_context.actions.action("edit.redo")->setEnabled(document.undoStack()->canRedo());
    const auto& sequences = document.project().sequences;
    const bool isWelcoming = sequences.empty() && document.isUntitled();
    m_pages->setCurrentIndex(isWelcoming ? 0 : 1);
    m_workspaces->showStrip(!isWelcoming);
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_message->clear();
        if (!sequences.empty())
            m_context.selection.selectSequences({QString::fromStdString(sequences.front().name)});
    }
}

void MainWindow::showHelp()
{
    auto* viewer = findChild<HelpViewer*>();
    if (!viewer)
        viewer = new HelpViewer(this);
    viewer->showPage(helpPageOf(focusWidget()));
    viewer->show();
    viewer->raise();
}

void MainWindow::showMessage(const QString& message, const QStringList& files)
{
    m_message->setText(message);
    m_message->setToolTip(files.mid(0, 20).join(QLatin1Char('\n')));
}

void MainWindow::showProblem(const QString& message)
{
    m_message->setText(message);
    m_message->setToolTip(message);
    m_issuesDock->show();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayClose()) {
        event->ignore();
        return;
    }
    m_session->keep();
    m_context.settings.setWindow(saveGeometry(), m_workspaces->states());
    m_context.jobs.cancelAll();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        files << url.toLocalFile();
    event->acceptProposedAction();
    openProjects(files);
    if (!files.isEmpty())
        m_import->preview(files);
}

} // namespace quadrille
