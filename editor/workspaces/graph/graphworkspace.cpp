// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphworkspace.h"

#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/graph/gapspanel.h"
#include "editor/workspaces/graph/graphbar.h"
#include "editor/workspaces/graph/graphchartspanel.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "editor/workspaces/graph/graphsettingspanel.h"
#include "editor/workspaces/graph/graphstatepage.h"
#include "editor/workspaces/graph/pairpreview.h"
#include "editor/workspaces/graph/transitionpanel.h"
#include "editor/workspaces/graph/transitionspeeds.h"
#include "model/project/document/madeclips.h"
#include "model/project/steps/charactersteps.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/graph/matrixview.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/cliplegend.h"

#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QVBoxLayout>

namespace quadrille {

namespace {

constexpr int dwellMilliseconds = 350;
constexpr int smallestMap = 340;   // pixels, with the filters above it
constexpr int smallestView = 360;  // with the buttons below it
constexpr int smallestPanel = 300; // pixels, so that all tabs show

QScrollArea* scrolled(QWidget* content)
{
    auto* area = new QScrollArea;
    area->setWidget(content);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    return area;
}

} // namespace

GraphWorkspace::GraphWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new SceneView(context,
                           {.clip = [this](const QString& name, bool) { return m_preview->sequence(name); },
                            .upAxis = [&context] { return context.media.upAxis(); }},
                           QStringLiteral("graph")))
    , m_explorer(new GraphExplorer(context.jobs, this))
    , m_preview(new PairPreview(context.jobs, this))
    , m_speeds(new TransitionSpeeds(context.jobs, this))
    , m_pictures(new FramePictures(context.document, context.media, context.jobs, this))
    , m_bar(new GraphBar(context, *m_explorer))
    , m_map(new GraphMap(*m_explorer, *m_pictures, context.jobs))
    , m_statePage(new GraphStatePage(context))
    , m_message(new widgets::MessageStrip)
    , m_readOut(new QLabel)
    , m_pages(new QStackedWidget)
    , m_tabs(new QTabWidget)
    , m_transition(new TransitionPanel(*m_explorer, *m_speeds, *m_pictures))
    , m_charts(new GraphChartsPanel(*m_explorer))
    , m_gaps(new GapsPanel(*m_explorer))
    , m_settings(new GraphSettingsPanel(context))
{
    setObjectName(QStringLiteral("graphWorkspace"));
    m_message->setObjectName(QStringLiteral("graphMessage"));
    m_dwell.setSingleShot(true);
    m_dwell.setInterval(dwellMilliseconds);
    makeActions();
    makePanels();
    arrangeWidgets();
    connectParts();
    retranslates(this, [this] {
        m_tabs->setTabText(0, tr("Transition"));
        m_tabs->setTabText(1, tr("Charts"));
        m_tabs->setTabText(2, tr("Gaps"));
        m_tabs->setTabText(3, tr("Settings"));
        showState();
        showReadOut();
        if (m_preview->clip() == nullptr)
            showStrip({});
    });
}

void GraphWorkspace::makePanels()
{
    m_tabs->setObjectName(QStringLiteral("graphTabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->setUsesScrollButtons(false);
    m_tabs->setElideMode(Qt::ElideNone); // the panel is as wide as its tabs are in any language
    m_tabs->setMinimumWidth(smallestPanel);
    m_tabs->addTab(scrolled(m_transition), {});
    m_tabs->addTab(scrolled(m_charts), {});
    m_tabs->addTab(scrolled(m_gaps), {});
    m_tabs->addTab(scrolled(m_settings), {});
    m_panels = {{"graphDock", [] { return tr("Transitions"); }, m_tabs, Qt::RightDockWidgetArea}};
}

void GraphWorkspace::arrangeWidgets()
{
    m_readOut->setObjectName(QStringLiteral("graphReadOut"));
    m_readOut->setFont(widgets::Theme::tabularFont(m_readOut->font()));
    m_readOut->setContentsMargins(8, 4, 8, 4);
    m_readOut->setWordWrap(true);
    m_readOut->setMinimumHeight(2 * m_readOut->fontMetrics().lineSpacing() + 8);
    m_readOut->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* left = new QWidget;
    auto* leftColumn = new QVBoxLayout(left);
    leftColumn->setContentsMargins(0, 0, 0, 0);
    leftColumn->setSpacing(0);
    leftColumn->addWidget(m_message);
    m_pages->addWidget(m_statePage);
    m_pages->addWidget(m_map);
    leftColumn->addWidget(m_pages, 1);
    leftColumn->addWidget(m_readOut);
    // What both sides need at least changes with what they show: the divider must not.
    left->setMinimumWidth(smallestMap);
    m_view->setMinimumWidth(smallestView);
    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setObjectName(QStringLiteral("graphSplitter"));
    splitter->addWidget(left);
    splitter->addWidget(m_view);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    splitter->setChildrenCollapsible(false);
    splitter->setSizes({600, 400});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    using widgets::FrameKind;
    m_view->addBelowTimeline(new widgets::ClipLegend({FrameKind::Captured, FrameKind::Transition}));
    column->addWidget(m_bar);
    column->addWidget(splitter, 1);
}

void GraphWorkspace::connectParts()
{
    connect(&m_context.graphs, &GraphResults::changed, this, &GraphWorkspace::followGraph);
    connect(&m_context.document, &ProjectDocument::changed, this, &GraphWorkspace::followGraph);
    connect(m_bar, &GraphBar::characterChosen, this, &GraphWorkspace::followGraph);
    connect(m_explorer, &GraphExplorer::characterChanged, this, [this] {
        m_chosen.reset();
        m_hovered.reset();
        m_preview->setCharacter(m_explorer->character());
        m_speeds->setCharacter(m_explorer->character());
        m_view->message().clear();
        m_view->show(QStringList());
        showStrip({});
        showState();
        showReadOut();
    });
    connect(m_explorer, &GraphExplorer::characterReplaced, this, [this] {
        m_preview->replaceCharacter(m_explorer->character());
        m_speeds->replaceCharacter(m_explorer->character());
    });
    connect(m_explorer, &GraphExplorer::graphsChanged, this, [this] {
        m_charts->setAlpha(m_explorer->alpha());
        showReadOut();
        updateActions();
    });
    connect(m_explorer, &GraphExplorer::pathsChanged, this, &GraphWorkspace::updateActions);
    connect(m_map, &GraphMap::hovered, this, &GraphWorkspace::hover);
    connect(m_map, &GraphMap::moved, this, [this](const FramePair& pair) {
        choose(pair);
        showFrames(pair);
    });
    connect(m_map, &GraphMap::activated, this, &GraphWorkspace::activate);
    connect(m_map, &GraphMap::menuRequested, this, &GraphWorkspace::askWhatToDo);
    connect(m_map, &GraphMap::takesMenuRequested, this, &GraphWorkspace::askAboutTakes);
    connect(m_map, &GraphMap::filterDropped, this, [this] { m_explorer->setFilter({}); });
    connect(&m_context.selection, &Selection::changed, this, &GraphWorkspace::followSelection);
    connect(m_transition, &TransitionPanel::chosen, this, &GraphWorkspace::activate);
    connect(m_gaps, &GapsPanel::chosen, this, [this](const FramePair& pair, bool isTransition) {
        m_map->setCurrent(pair);
        if (isTransition) {
            activate(pair);
        } else {
            choose(pair);
            showFrames(pair);
        }
    });
    connect(m_charts, &GraphChartsPanel::alphaEdited, m_bar, &GraphBar::editAlpha);
    connect(m_preview, &PairPreview::framesChanged, this, [this] {
        scene().update(PairPreview::sourceName());
        scene().update(PairPreview::destinationName());
    });
    connect(m_preview, &PairPreview::clipChanged, this, &GraphWorkspace::showClip);
    connect(m_preview, &PairPreview::clipFailed, this, [this](const Error& error) {
        const ErrorText text = describe(error);
        m_view->message().show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
    });
    connect(m_message, &widgets::MessageStrip::actionTriggered, this, [this] {
        const auto* resultState = m_context.graphs.resultState(m_bar->character());
        const bool computes = resultState != nullptr && resultState->phase == ResultPhase::Computing;
        m_context.actions.action(computes ? "graph.stop" : "graph.compute")->trigger();
    });
    connect(&m_dwell, &QTimer::timeout, this, [this] {
        if (m_hovered)
            showFrames(*m_hovered);
    });
    connect(m_view, &SceneView::sceneChanged, this,
            [this] { m_view->timeline().setFrameCount(static_cast<int>(scene().frameCount())); });
}

void GraphWorkspace::setActive(bool active)
{
    m_isActive = active;
    followGraph();
}

/// The graph is looked at only while somebody does.
void GraphWorkspace::followGraph()
{
    if (!m_isActive)
        return;
    const QString character = m_bar->character();
    const double fps = m_context.document.project().settings.fps;
    m_map->setFps(fps);
    m_transition->setFps(fps);
    m_settings->showCharacter(character);
    m_statePage->show(character);
    const auto* resultState = m_context.graphs.resultState(character);
    m_explorer->setCharacter(resultState != nullptr ? resultState->opened : nullptr);
    showOverview();
    m_charts->setAlpha(m_explorer->alpha());
    showState();
    updateActions();
}

/// While a graph is opened for the first time.
void GraphWorkspace::showOverview()
{
    const auto* state = m_context.graphs.resultState(m_bar->character());
    const bool isOpening =
        state != nullptr && state->opened == nullptr && state->phase == ResultPhase::Computing;
    m_hasOverview = isOpening && state->overview != nullptr;
    showReadOut();
    if (!m_hasOverview) {
        m_map->showOverview(nullptr, {}, {});
        return;
    }
    const Project& project = m_context.document.project();
    const std::string character = m_bar->character().toStdString();
    QStringList sequences;
    for (const std::string& name : sequencesOfGraph(project, character))
        sequences += QString::fromStdString(name);
    m_map->showOverview(state->overview, sequences, graphOf(project, character).pose.metric);
}

void GraphWorkspace::showState()
{
    const bool isThere = m_explorer->character() != nullptr;
    m_pages->setCurrentIndex(isThere || m_hasOverview ? 1 : 0);
    m_readOut->setVisible(isThere || m_hasOverview);
    viewport().setNotice(!isThere || !scene().shown().isEmpty()
                             ? QString()
                             : tr("Point at the map to see two frames; click to play the transition."));
    const auto* resultState = isThere ? m_context.graphs.resultState(m_bar->character()) : nullptr;
    const bool isReady = resultState == nullptr || resultState->phase == ResultPhase::Ready;
    // A graph for another α alone comes so soon that a message would only flicker.
    const bool computesQuietly =
        !isReady && resultState->phase == ResultPhase::Computing &&
        (resultState->opened == nullptr || resultState->job.isNull() || resultState->job->isBackground());
    if (isReady || computesQuietly) {
        m_message->clear();
    } else if (resultState->phase == ResultPhase::Failed && resultState->error) {
        const ErrorText text = describe(*resultState->error);
        m_message->show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
        m_message->setAction(tr("Try again"));
    } else if (resultState->phase == ResultPhase::Computing) {
        m_message->show(widgets::MessageStrip::Kind::Info,
                        tr("The graph is computed anew; this is the one before."));
        m_message->setAction(tr("Stop"));
    } else {
        m_message->show(widgets::MessageStrip::Kind::Warning,
                        tr("The settings have changed since this graph was computed."));
        m_message->setAction(tr("Compute"));
    }
}

void GraphWorkspace::choose(const FramePair& pair)
{
    m_chosen = pair;
    m_transition->show(pair);
    showReadOut();
    updateActions();
}

void GraphWorkspace::activate(const FramePair& pair)
{
    if (!m_explorer->character())
        return;
    m_dwell.stop();
    m_view->message().clear();
    m_map->setCurrent(pair);
    choose(pair);
    if (m_explorer->character()->graph.costs().hasTransition(pair.source, pair.destination))
        m_preview->makeClip(pair);
    else
        showFrames(pair);
}

QString GraphWorkspace::readOut(const FramePair& pair) const
{
    const CharacterGraph& graph = m_explorer->character()->graph;
    QString text = m_map->matrix().cellText({pair.source, pair.destination});
    const auto transition = graph.transition(pair);
    if (!transition)
        return text;
    const double fps = m_context.document.project().settings.fps;
    const int length = graph.costs().length()(pair.source, pair.destination);
    //: a cell of the map, then how long its transition is in frames and seconds, and its windows in frames
    text = tr("%1 · %2 frames (%3 s) · windows %4 and %5")
               .arg(text)
               .arg(length)
               .arg(QLocale().toString((length - 1) / fps, 'f', 2))
               .arg(transition->sourceWindow)
               .arg(transition->destinationWindow);
    const auto& graphs = m_explorer->graphs();
    if (graphs && graphs->essential.find(pair.source, pair.destination) != nullptr)
        text = tr("%1 · Essential graph").arg(text);
    if (graphs && graphs->motion.find(pair.source, pair.destination) != nullptr)
        text = tr("%1 · motion graph").arg(text);
    return text;
}

void GraphWorkspace::showReadOut()
{
    const auto pair = m_hovered ? m_hovered : m_chosen;
    m_readOut->setText(m_hasOverview                     ? tr("The graph is being opened…")
                       : pair && m_explorer->character() ? readOut(*pair)
                                                         : tr("Point at the map to read costs"));
    m_readOut->setToolTip(m_readOut->text());
}

} // namespace quadrille

#include "moc_graphworkspace.cpp"
