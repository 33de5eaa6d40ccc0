// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/mainwindow.h"

#include "editor/application/projectfiles.h"
#include "editor/docks/projecttreemodel.h"
#include "editor/docks/statusjobs.h"
#include "editor/errors/errortext.h"
#include "editor/errors/issuespanel.h"
#include "editor/help/helpviewer.h"
#include "editor/playback/player.h"
#include "editor/playback/sequencestage.h"
#include "editor/welcome/welcomepage.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/playbackbar.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTreeView>
#include <QUndoView>
#include <QVBoxLayout>

namespace quadrille {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent)
    , m_selection(m_document)
    , m_media(m_document, m_jobs)
    , m_autosave(m_document, m_jobs)
    , m_actions(m_settings)
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowIcon(widgets::icons::application());
    setAcceptDrops(true);
    resize(1280, 800);
    m_languages.setLanguage(m_settings.language());
    m_files = new ProjectFiles(m_document, m_jobs, m_issues, m_settings, this);
    makeCentre();
    makeDocks();
    makeActions();
    makeViewActions();
    makeMenus();
    connectAll();
    m_autosave.setInterval(m_settings.autosaveSeconds());
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState());
    retranslate();
    followDocument(ChangeEvent::reset());
}

MainWindow::~MainWindow() = default;

void MainWindow::open(const QStringList& files)
{
    m_playsWhenReady = true;
    m_files->open(files);
}

void MainWindow::openSample()
{
    m_playsWhenReady = true;
    m_files->openSample();
}

void MainWindow::makeCentre()
{
    m_viewport = new widgets::Viewport;
    m_timeline = new widgets::Timeline;
    m_bar = new widgets::PlaybackBar;
    m_stage = new SequenceStage(*m_viewport, m_media, m_jobs, this);
    m_player = new Player(*m_stage, this);
    m_player->setLooping(m_settings.loopsPlayback());
    m_bar->setLooping(m_settings.loopsPlayback());
    m_sequenceTimeline = new SequenceTimeline(*m_timeline, m_document, m_media, this);

    auto* lower = new QWidget;
    auto* column = new QVBoxLayout(lower);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_bar);
    column->addWidget(m_timeline, 1);
    auto* stage = new QSplitter(Qt::Vertical);
    stage->addWidget(m_viewport);
    stage->addWidget(lower);
    stage->setStretchFactor(0, 1);
    stage->setCollapsible(0, false);
    m_welcome = new WelcomePage(m_settings);
    m_pages = new QStackedWidget;
    m_pages->addWidget(m_welcome);
    m_pages->addWidget(stage);
    setCentralWidget(m_pages);

    m_message = new QLabel;
    m_message->setObjectName(QStringLiteral("message"));
    statusBar()->addWidget(m_message, 1);
    statusBar()->addPermanentWidget(new StatusJobs(m_jobs));
}

void MainWindow::makeDocks()
{
    const auto addDock = [this](const char* name, QWidget* content, Qt::DockWidgetArea area) {
        auto* dock = new QDockWidget(this);
        dock->setObjectName(QLatin1String(name));
        dock->setWidget(content);
        addDockWidget(area, dock);
        return dock;
    };
    m_treeModel = new ProjectTreeModel(
        m_document,
        [this](const EntryRef& entry) {
            ProjectTreeModel::EntryStatus status;
            const auto* medium = entry.section == Section::Sequences ? m_media.medium(entry.name) : nullptr;
            if (!medium || medium->state == SequenceMedia::State::Ready)
                return status;
            status.state =
                medium->state == SequenceMedia::State::Failed ? EntryState::Failed : EntryState::Computing;
            if (medium->error)
                status.problem = describe(*medium->error).oneLine();
            return status;
        },
        this);
    m_tree = new QTreeView;
    m_tree->setObjectName(QStringLiteral("projectTree"));
    m_tree->setModel(m_treeModel);
    m_tree->setHeaderHidden(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_treeDock = addDock("projectDock", m_tree, Qt::LeftDockWidgetArea);
    m_historyDock = addDock("historyDock", new QUndoView(m_document.undoStack()), Qt::RightDockWidgetArea);
    m_issuesDock = addDock("issuesDock", new IssuesPanel(m_issues), Qt::BottomDockWidgetArea);
    m_historyDock->hide();
    m_issuesDock->hide();
    resizeDocks({m_treeDock}, {240}, Qt::Horizontal);
}

void MainWindow::connectAll()
{
    connect(&m_document, &ProjectDocument::changed, this, &MainWindow::followDocument);
    connect(m_document.undoStack(), &QUndoStack::indexChanged, this,
            [this] { followDocument(ChangeEvent::file()); });
    connect(&m_selection, &Selection::changed, this, &MainWindow::followSelection);
    connect(m_stage, &SequenceStage::changed, this, &MainWindow::followStage);
    connect(m_sequenceTimeline, &SequenceTimeline::rangeChanged, this, &MainWindow::followRange);
    connect(m_stage, &SequenceStage::frameFailed, this,
            [this](const QString& name, const Error& error) { m_issues.add(error, name); });
    connect(&m_media, &SequenceMedia::changed, this, [this](const QString& name) {
        m_treeModel->updateStatus({Section::Sequences, name});
        const auto* medium = m_media.medium(name);
        m_issues.clear(name);
        if (medium && medium->error)
            m_issues.add(*medium->error, name);
    });
    connect(m_tree->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        QStringList names;
        for (const QModelIndex& index : m_tree->selectionModel()->selectedIndexes()) {
            const EntryRef entry = m_treeModel->entry(index);
            if (entry.section == Section::Sequences && !entry.name.isEmpty())
                names << entry.name;
        }
        if (!names.isEmpty())
            m_selection.selectSequences(names);
    });
    connect(m_files, &ProjectFiles::sequencesAdded, this,
            [this](const QStringList& names) { m_selection.selectSequences(names.mid(0, 1)); });
    connect(m_files, &ProjectFiles::failed, this, &MainWindow::showProblem);
    connect(&m_jobs, &JobRunner::failed, this,
            [this](Job*, const Error& error) { showProblem(describe(error).oneLine()); });
    connect(m_welcome, &WelcomePage::actionAsked, this,
            [this](const QString& id) { m_actions.action(id)->trigger(); });
    connect(m_welcome, &WelcomePage::projectAsked, this, [this](const QString& file) { open({file}); });

    connect(m_timeline, &widgets::Timeline::frameScrubbed, m_player, &Player::goTo);
    connect(m_bar, &widgets::PlaybackBar::playToggled, m_player, &Player::toggle);
    connect(m_bar, &widgets::PlaybackBar::stepAsked, m_player, &Player::step);
    connect(m_bar, &widgets::PlaybackBar::firstAsked, m_player, &Player::goToStart);
    connect(m_bar, &widgets::PlaybackBar::lastAsked, m_player, &Player::goToEnd);
    connect(m_bar, &widgets::PlaybackBar::frameEntered, m_player, &Player::goTo);
    connect(m_bar, &widgets::PlaybackBar::loopToggled, this, [this](bool loops) {
        m_settings.setLoopsPlayback(loops);
        m_player->setLooping(loops);
    });
    connect(m_player, &Player::frameChanged, this, [this](qint64 frame) {
        m_timeline->setCurrentFrame(static_cast<int>(frame));
        m_bar->setCurrentFrame(static_cast<int>(frame));
    });
    connect(m_player, &Player::playingChanged, m_bar, &widgets::PlaybackBar::setPlaying);
    connect(m_player, &Player::fpsReached, m_bar, &widgets::PlaybackBar::setFpsReached);
}

void MainWindow::followDocument(const ChangeEvent& event)
{
    setWindowTitle(m_document.title() + QStringLiteral("[*] – Quadrille"));
    setWindowModified(m_document.isModified());
    m_actions.action("edit.undo")->setEnabled(m_document.canUndo());
    m_actions.action("edit.redo")->setEnabled(m_document.undoStack()->canRedo());
    const auto& sequences = m_document.project().sequences;
    m_pages->setCurrentIndex(sequences.empty() && m_document.isUntitled() ? 0 : 1);
    m_viewport->setUpAxis(m_document.project().settings.axes.up == UpAxis::Z ? widgets::UpAxis::Z
                                                                             : widgets::UpAxis::Y);
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_message->clear();
        m_tree->expandAll();
        if (!sequences.empty())
            m_selection.selectSequences({QString::fromStdString(sequences.front().name)});
    }
    const double fps = m_document.project().settings.fps;
    m_player->setFps(fps);
    m_bar->setFps(fps);
    m_timeline->setFps(fps);
}

void MainWindow::followSelection()
{
    const QStringList& names = m_selection.sequences();
    m_stage->show(names.size() > 1 ? names : QStringList{m_selection.shownSequence()});
    m_viewport->setLayoutMode(widgets::Viewport::Layout::SideBySide);
    m_viewport->setNamesVisible(names.size() > 1);
    followStage();
}

void MainWindow::followStage()
{
    const std::int64_t frames = m_stage->frameCount();
    m_sequenceTimeline->show(m_selection.shownSequence(), m_stage->isComparing() ? frames : 0);
    m_bar->setFrameCount(static_cast<int>(frames));
    followRange();
}

void MainWindow::followRange()
{
    const std::int64_t frames = m_stage->frameCount();
    if (frames == 0) {
        m_player->pause();
        return;
    }
    const auto [first, last] = m_timeline->range();
    m_player->setRange(FrameIndex(first), FrameIndex(std::min<std::int64_t>(last, frames - 1)));
    if (m_player->frame().value >= frames)
        m_player->goToStart();
    if (std::exchange(m_playsWhenReady, false))
        m_player->play();
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

void MainWindow::showProblem(const QString& message)
{
    m_message->setText(message);
    m_message->setToolTip(message);
    m_issuesDock->show();
}

void MainWindow::retranslate()
{
    m_actions.retranslate();
    for (const auto& [menu, title] : m_menus)
        menu->setTitle(title());
    m_treeDock->setWindowTitle(tr("Project"));
    m_historyDock->setWindowTitle(tr("History"));
    m_issuesDock->setWindowTitle(tr("Issues"));
    m_tree->setAccessibleName(tr("Project"));
    m_timeline->setAccessibleName(tr("Timeline"));
    m_viewport->setAccessibleName(tr("View"));
}

void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange && m_bar)
        retranslate();
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayClose()) {
        event->ignore();
        return;
    }
    m_settings.setWindow(saveGeometry(), saveState());
    m_jobs.cancelAll();
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
    open(files);
    event->acceptProposedAction();
}

} // namespace quadrille
