// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/sceneview.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/view/timelinesettings.h"
#include "editor/workspaces/view/viewmenu.h"
#include "editor/workspaces/view/viewtools.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/playbackbar.h"
#include "widgets/viewport/vtkview.h"

#include <QGridLayout>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

/// "viewport" or "animateViewport".
QString partName(const QString& prefix, const QString& part)
{
    return prefix.isEmpty() ? part : prefix + part.at(0).toUpper() + part.mid(1);
}

QVBoxLayout* columnOf(QWidget* widget)
{
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    return column;
}

} // namespace

SceneView::SceneView(EditorContext& context, ClipScene::Source source, const QString& name, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_viewport(new widgets::Viewport)
    , m_timeline(new widgets::Timeline)
    , m_bar(new widgets::PlaybackBar)
    , m_scene(new ClipScene(*m_viewport, std::move(source), context.jobs, this))
    , m_player(new Player(*m_scene, this))
    , m_message(new widgets::MessageStrip)
    , m_tools(new ViewTools(context.actions))
{
    m_viewport->setObjectName(partName(name, QStringLiteral("viewport")));
    m_timeline->setObjectName(partName(name, QStringLiteral("timeline")));
    m_message->setObjectName(partName(name, QStringLiteral("viewMessage")));
    m_tools->setObjectName(partName(name, QStringLiteral("viewTools")));
    new ViewMenu(context, *this);
    arrangeWidgets();
    connectPlayback();
    followSettings();
    connect(&context.settings, &Settings::changed, this, &SceneView::followSettings);
    connectTimeline();
    connect(m_tools, &ViewTools::ghostIntervalChanged, this, [this] { setGhostsShown(m_ghostsShown); });
    connect(&context.document, &ProjectDocument::renamed, this, &SceneView::followName);
    connect(&context.document, &ProjectDocument::changed, this, &SceneView::followDocument);
    connect(m_scene, &ClipScene::changed, this, &SceneView::followScene);
    connect(m_scene, &ClipScene::frameFailed, this,
            [this](const QString& clip, const Error& error) { m_context.issues.add(error, clip); });
    retranslates(this, [this] {
        m_timeline->setAccessibleName(tr("Timeline"));
        m_viewport->setAccessibleName(tr("View"));
    });
    followDocument();
    m_viewport->setLayoutMode(widgets::Viewport::Layout::SideBySide);
}

void SceneView::arrangeWidgets()
{
    auto* upper = new QWidget;
    auto* upperColumn = columnOf(upper);
    upperColumn->addWidget(m_tools);
    // What is told lies over the view: it must not change its size under the pen of who draws there.
    auto* place = new QGridLayout;
    place->addWidget(m_viewport, 0, 0);
    place->addWidget(m_message, 0, 0, Qt::AlignTop);
    upperColumn->addLayout(place, 1);
    auto* lower = new QWidget;
    m_lower = columnOf(lower);
    m_lower->addWidget(m_bar);
    m_lower->addWidget(m_timeline, 1);
    auto* splitter = new QSplitter(Qt::Vertical);
    m_beside = new QSplitter(Qt::Horizontal);
    m_beside->addWidget(upper);
    splitter->addWidget(m_beside);
    splitter->addWidget(lower);
    splitter->setStretchFactor(0, 1);
    splitter->setCollapsible(0, false);
    columnOf(this)->addWidget(splitter);
}

void SceneView::addBeside(QWidget* widget)
{
    m_beside->addWidget(widget);
    m_beside->setChildrenCollapsible(false);
}

void SceneView::connectPlayback()
{
    using widgets::PlaybackBar;
    connect(m_timeline, &widgets::Timeline::frameScrubbed, m_player,
            [this](int frame) { m_player->goTo(frame - m_timelineOffset); });
    connect(m_bar, &PlaybackBar::playToggled, m_player, &Player::toggle);
    connect(m_bar, &PlaybackBar::stepRequested, m_player, &Player::step);
    connect(m_bar, &PlaybackBar::firstRequested, m_player, &Player::goToStart);
    connect(m_bar, &PlaybackBar::lastRequested, m_player, &Player::goToEnd);
    connect(m_bar, &PlaybackBar::frameEntered, m_player, &Player::goTo);
    connect(m_bar, &PlaybackBar::loopToggled, this, [this](bool loops) {
        m_context.settings.setLoopsPlayback(loops);
        m_player->setLooping(loops);
    });
    connect(m_player, &Player::frameChanged, this, &SceneView::showPlayhead);
    connect(m_player, &Player::playingChanged, m_bar, &PlaybackBar::setPlaying);
    connect(m_player, &Player::playingChanged, m_viewport, &widgets::Viewport::setMoving);
    connect(m_player, &Player::fpsReached, m_bar, &PlaybackBar::setFpsReached);
}

void SceneView::followSettings()
{
    m_player->setLooping(m_context.settings.loopsPlayback());
    m_bar->setLooping(m_context.settings.loopsPlayback());
    m_viewport->setMousePreset(m_context.settings.mousePreset());
}

void SceneView::connectTimeline()
{
    using widgets::Timeline;
    m_timeline->setRangeEditable(false);
    m_timeline->setRows(timelineRows(m_timeline->objectName()));
    setUsualUnit(Timeline::Unit::Frames);
    m_bar->setLoopActions(
        {m_context.actions.action("play.backAndForth"), m_context.actions.action("play.loopAll")});
    m_player->setBackAndForth(playsBackAndForth());
    connect(m_timeline, &Timeline::rowsEdited, this,
            [this] { setTimelineRows(m_timeline->objectName(), m_timeline->rows()); });
    connect(m_timeline, &Timeline::loopEdited, this, [this](int first, int last, bool committed) {
        m_timeline->setLoop(std::pair(first, last));
        if (committed)
            setLoop(m_timeline->loop());
    });
    connect(m_timeline, &Timeline::loopRemovalRequested, this, [this] { setLoop(std::nullopt); });
}

void SceneView::setLoop(std::optional<std::pair<int, int>> loop)
{
    m_timeline->setLoop(loop);
    // Who marks a part wants to see it again.
    if (loop && !m_context.settings.loopsPlayback())
        m_context.settings.setLoopsPlayback(true);
    updateRange();
}

void SceneView::setLoopStart(int frame)
{
    setLoop(std::pair(frame, std::max(frame, m_timeline->playedRange().second)));
}

void SceneView::setLoopEnd(int frame)
{
    setLoop(std::pair(std::min(m_timeline->playedRange().first, frame), frame));
}

void SceneView::setUsualUnit(widgets::Timeline::Unit unit)
{
    m_timeline->setUnit(timelineUnit(m_timeline->objectName(), unit));
}

void SceneView::setRulerUnit(widgets::Timeline::Unit unit)
{
    if (unit == m_timeline->unit())
        return;
    m_timeline->setUnit(unit);
    setTimelineUnit(m_timeline->objectName(), unit);
}

void SceneView::setPlayhead(int frame)
{
    m_timeline->setCurrentFrame(frame);
    m_bar->setCurrentFrame(m_timeline->currentFrame());
}

void SceneView::setPictureRate(double picturesPerSecond)
{
    if (widgets::VtkView* view = m_viewport->view())
        view->setPictureRate(picturesPerSecond);
}

void SceneView::addBelowTimeline(QWidget* widget)
{
    m_lower->addWidget(widget);
}

/// What is shown has another name: it stays as it is, with its frame and the camera.
void SceneView::followName(const ChangeEvent& event)
{
    if (event.entry.section != m_scene->section())
        return;
    m_scene->rename(event.before, event.entry.name);
    std::ranges::replace(m_names, event.before, event.entry.name);
    if (m_current == event.before)
        m_current = event.entry.name;
}

void SceneView::followDocument()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    m_viewport->setUpAxis(settings.axes.up == UpAxis::Z ? widgets::UpAxis::Z : widgets::UpAxis::Y);
    m_viewport->setRuler(widgets::Ruler(settings.axes.metresPerUnit));
    setPictureRate(settings.fps);
    m_player->setFps(settings.fps);
    m_bar->setFps(settings.fps);
    m_timeline->setFps(settings.fps);
}

void SceneView::show(const QStringList& names)
{
    if (std::exchange(m_names, names) != names)
        m_timeline->setLoop(std::nullopt);
    m_scene->show(names);
    m_current = names.value(names.size() - 1);
    updateNames();
    followScene();
}

void SceneView::setCurrent(const QString& name)
{
    m_current = name;
    followCharacter();
}

void SceneView::followScene()
{
    m_bar->setFrameCount(static_cast<int>(m_scene->frameCount()));
    emit sceneChanged();
    updateRange();
    m_bar->setCurrentFrame(m_timeline->currentFrame());
    followCharacter();
}

void SceneView::updateRange()
{
    const std::int64_t frames = m_scene->frameCount();
    if (frames == 0) {
        m_player->pause();
        return;
    }
    const auto [first, last] = m_timeline->playedRange();
    const auto played = [&](int frame) {
        return FrameIndex(std::clamp<std::int64_t>(frame - m_timelineOffset, 0, frames - 1));
    };
    m_player->setRange(played(first), played(last));
    if (m_player->frame().value >= frames)
        m_player->goToStart();
    // What had no frames for a while is at the first one; the player tells where it is. Behind the clip,
    // where keys can be put, there is no picture, and the playhead stays.
    if (m_timeline->currentFrame() - m_timelineOffset < frames)
        showPlayhead();
    if (std::exchange(m_playsWhenReady, false))
        m_player->play();
}

void SceneView::showPlayhead()
{
    const auto frame = static_cast<int>(m_player->frame().value);
    m_timeline->setCurrentFrame(frame + m_timelineOffset);
    m_bar->setCurrentFrame(frame);
}

void SceneView::setNamesShown(bool shown)
{
    m_namesShown = shown;
    updateNames();
}

void SceneView::updateNames()
{
    m_viewport->setNamesVisible(m_namesShown && m_scene->isComparing());
}

void SceneView::setFollowing(bool follows)
{
    m_follows = follows;
    followCharacter();
}

void SceneView::followCharacter()
{
    const int figure = m_scene->figureOf(m_current);
    m_viewport->setAnchor(figure);
    const auto followed = m_follows && figure >= 0 ? std::optional(figure) : std::nullopt;
    if (followed != m_viewport->followed())
        m_viewport->setFollowed(followed);
}

void SceneView::setGhostsShown(bool shown)
{
    m_ghostsShown = shown;
    m_scene->ghosts().setInterval(shown ? m_tools->ghostInterval() : 0);
}

void SceneView::setLayoutMode(widgets::Viewport::Layout layout)
{
    m_viewport->setLayoutMode(layout);
    if (layout == widgets::Viewport::Layout::Overlay && m_scene->isComparing() &&
        m_viewport->shading() == widgets::Shading::Textured)
        emit clayRequested();
    m_viewport->frameAll();
}

void SceneView::setColoredByTool(bool colored)
{
    if (colored == m_isColoredByTool)
        return;
    m_isColoredByTool = colored;
    if (colored)
        m_viewport->setShading(widgets::Shading::Scalar);
    emit coloredByToolChanged();
}

void SceneView::frameCurrent()
{
    m_viewport->frameFigure(m_scene->figureOf(m_current));
}

} // namespace quadrille

#include "moc_sceneview.cpp"
