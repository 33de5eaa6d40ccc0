// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/mainwindow.h"

#include "editor/application/focuskeys.h"
#include "editor/application/projectfiles.h"
#include "editor/application/projectstrips.h"
#include "editor/application/sessionkeeper.h"
#include "editor/docks/statusjobs.h"
#include "editor/errors/errortext.h"
#include "editor/exporting/exportflow.h"
#include "editor/exporting/pictureflow.h"
#include "editor/fields/fieldundo.h"
#include "editor/fields/wheelfocus.h"
#include "editor/importing/importflow.h"
#include "editor/language/retranslate.h"
#include "editor/playback/player.h"
#include "editor/relinking/relinkflow.h"
#include "editor/results/resultsflow.h"
#include "editor/welcome/sampleflow.h"
#include "editor/welcome/welcomepage.h"
#include "editor/workspaces/animate/animateworkspace.h"
#include "editor/workspaces/animate/keysandstoryboard.h"
#include "editor/workspaces/appearance/appearanceworkspace.h"
#include "editor/workspaces/graph/graphworkspace.h"
#include "editor/workspaces/live/liveworkspace.h"
#include "editor/workspaces/sequences/sequencesworkspace.h"
#include "editor/workspaces/transfer/transferworkspace.h"
#include "editor/workspaces/variations/variationsworkspace.h"
#include "editor/workspaces/workspacetabs.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/viewport.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>
#include <chrono>

namespace quadrille {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent)
    , m_autosave(m_context.document)
    , m_files(
          new ProjectFiles(m_context.document, m_context.jobs, m_context.issues, m_context.settings, this))
    , m_import(new ImportFlow(m_context, this))
    , m_export(new ExportFlow(
          m_context,
          [this] {
              Workspace* front = workspaceInFront();
              return front == nullptr ? nullptr : &front->view();
          },
          [this] {
              const Workspace* front = workspaceInFront();
              return front == nullptr ? QString() : front->shownClip();
          },
          this))
    , m_relink(new RelinkFlow(m_context, this))
    , m_results(new ResultsFlow(m_context, this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowIcon(widgets::icons::application());
    setAcceptDrops(true);
    new FocusKeys(this);
    new FieldUndo(this);
    new WheelFocus(this);
    resize(1280, 800);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    {
        const widgets::StyleWhenComplete style;
        makeCentre();
        makeDocks();
        makeWorkspaces();
        makeActions();
        makeThemeActions();
        makeMenus();
    }
    connectAll();
    m_session = new SessionKeeper(m_context, *m_workspaces, *m_sequences, *this);
    connect(m_session, &SessionKeeper::putAside, this, &MainWindow::tellPutAside, Qt::QueuedConnection);
    m_autosave.setDelay(m_context.settings.autosaveSeconds());
    m_session->restoreWindow();
    m_workspaces->begin();
    followDocument(ChangeEvent::reset());
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

Workspace* MainWindow::workspaceInFront() const
{
    return m_workspaces == nullptr ? nullptr : m_workspaces->currentWorkspace();
}

void MainWindow::open(const QStringList& files)
{
    m_sequences->view().playWhenReady();
    QStringList sequences = files;
    openProjects(sequences);
    if (!sequences.isEmpty())
        m_import->open(sequences);
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
    m_sample->open(SampleGoal::Play);
}

void MainWindow::makeCentre()
{
    m_welcome = new WelcomePage(m_context.settings);
    m_workspaces = new WorkspaceTabs(m_context, *this);
    m_sample = new SampleFlow(m_context, *m_files, *m_workspaces, this);
    m_pictures = new PictureFlow(
        m_context, [this] { return &m_workspaces->currentWorkspace()->viewport(); }, this);
    m_sequences = new SequencesWorkspace(m_context);
    m_graph = new GraphWorkspace(m_context);
    m_animate = new AnimateWorkspace(m_context);
    m_variations = new VariationsWorkspace(m_context);
    m_appearance = new AppearanceWorkspace(m_context);
    m_transfer = new TransferWorkspace(m_context);
    m_live = new LiveWorkspace(m_context);
    m_animate->keysAndStoryboard().setShownPose(
        [this] { return m_workspaces->currentWorkspace()->shownPose(); });
    m_strips = new ProjectStrips(m_context, *m_files);
    m_pages = new QStackedWidget;
    m_pages->addWidget(m_welcome);
    m_pages->addWidget(m_workspaces);
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_relink->strip());
    column->addWidget(m_strips);
    column->addWidget(m_results->strip());
    column->addWidget(m_pages, 1);
    setCentralWidget(centre);

    m_message = new QLabel;
    m_message->setObjectName(QStringLiteral("message"));
    statusBar()->addWidget(m_message, 1);
    m_messagePasses = new QTimer(this);
    m_messagePasses->setObjectName(QStringLiteral("messagePasses"));
    m_messagePasses->setSingleShot(true);
    connect(m_messagePasses, &QTimer::timeout, m_message, [this] {
        m_message->clear();
        m_message->setToolTip({});
    });
    m_jobs = new StatusJobs(m_context.jobs);
    statusBar()->addPermanentWidget(m_jobs);
}

void MainWindow::connectAll()
{
    connectFiles();
    retranslates(this, [this] {
        setLocale(QLocale()); // numbers as the language writes them
        showTitle();
    });
    connect(&m_context.document, &ProjectDocument::changed, this, &MainWindow::followDocument);
    connect(m_context.document.undoStack(), &QUndoStack::indexChanged, this,
            [this] { followDocument(ChangeEvent::file()); });
    connect(&m_context.media, &SequenceMedia::changed, this, [this](const QString& name) {
        const auto* resultState = m_context.media.resultState(name);
        m_context.issues.clear(name);
        if (resultState && resultState->error)
            m_context.issues.add(*resultState->error, name);
    });
    connect(m_import, &ImportFlow::imported, this,
            [this](const QStringList& names) { m_context.selection.selectSequences(names.mid(0, 1)); });
    connect(m_export, &ExportFlow::exported, this, [this](const QStringList& files) {
        showMessage(tr("Exported to %1").arg(files.value(0)), files);
        m_context.variations.readStopped();
    });
    connect(m_variations, &VariationsWorkspace::exportRequested, this,
            [this](const QString& clip) { m_export->exportClips({clip}); });
    connect(m_transfer, &TransferWorkspace::exportRequested, this,
            [this](const QString& clip) { m_export->exportClips({clip}); });
    connect(m_live, &LiveWorkspace::exportRequested, this,
            [this](const QString& clip) { m_export->exportClips({clip}); });
    connect(m_pictures, &PictureFlow::saved, this,
            [this](const QStringList& files) { showMessage(tr("Saved to %1").arg(files.value(0)), files); });
    connect(m_import, &ImportFlow::failed, this, [this](const Error& error) {
        m_context.issues.add(error);
        showProblem(describe(error).oneLine());
    });
    connect(m_relink, &RelinkFlow::relinked, this,
            [this](int media) { showMessage(tr("%n file(s) were relinked", nullptr, media), {}); });
    connect(&m_context.jobs, &JobRunner::failed, this, [this](Job*, const Error& error) {
        m_context.issues.add(error);
        showProblem(describe(error).oneLine());
    });
    connect(m_welcome, &WelcomePage::actionRequested, this,
            [this](const QString& id) { m_context.actions.action(id)->trigger(); });
    connect(m_welcome, &WelcomePage::projectRequested, this, [this](const QString& file) { open({file}); });
    connect(m_welcome, &WelcomePage::sampleRequested, m_sample, &SampleFlow::open);
    connect(m_welcome, &WelcomePage::sampleCancelled, m_sample, &SampleFlow::cancel);
    connect(m_sample, &SampleFlow::progressed, m_welcome, &WelcomePage::showSampleProgress);
    connect(m_sample, &SampleFlow::ended, m_welcome, &WelcomePage::endSampleProgress);
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
    const bool beginsWork = !isWelcoming && m_pages->currentIndex() == 0;
    m_pages->setCurrentIndex(isWelcoming ? 0 : 1);
    m_workspaces->setShown(!isWelcoming);
    if (beginsWork)
        m_workspaces->currentWorkspace()->viewport().setFocus();
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_message->clear();
        if (!sequences.empty())
            m_context.selection.selectSequences({QString::fromStdString(sequences.front().name)});
    }
}

void MainWindow::showMessage(const QString& message, const QStringList& files)
{
    constexpr std::chrono::seconds seen{15};
    m_message->setText(message);
    m_message->setToolTip(files.mid(0, 20).join(QLatin1Char('\n')));
    m_messagePasses->start(seen);
}

void MainWindow::tellPutAside(const QString& file)
{
    showMessage(
        tr("Settings that could not be used were put aside as %1: here are the usual ones.").arg(file),
        {file});
}

void MainWindow::showProblem(const QString& message)
{
    m_messagePasses->stop(); // it stays until something else is told
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
    m_session->keepWindow();
    m_context.jobs.cancelAll();
    event->accept();
}

void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::WindowStateChange)
        m_context.actions.action("view.fullScreen")->setChecked(isFullScreen());
    QMainWindow::changeEvent(event);
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

#include "moc_mainwindow.cpp"
