// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/stageview.h"

#include "editor/application/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/view/timelinesettings.h"
#include "editor/workspaces/view/viewmenu.h"
#include "editor/workspaces/view/viewtools.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/playbackbar.h"

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

StageView::StageView(EditorContext& context, SequenceStage::Source source, const QString& name,
                     QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_viewport(new widgets::Viewport)
    , m_timeline(new widgets::Timeline)
    , m_bar(new widgets::PlaybackBar)
    , m_stage(new SequenceStage(*m_viewport, std::move(source), context.jobs, this))
    , m_player(new Player(*m_stage, this))
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
    connect(&context.settings, &Settings::changed, this, &StageView::followSettings);
    connectTimeline();
    connect(m_tools, &ViewTools::ghostIntervalChanged, this, [this] { setGhostsShown(m_ghostsShown); });
    connect(&context.document, &ProjectDocument::renamed, this, &StageView::followName);
    connect(&context.document, &ProjectDocument::changed, this, &StageView::followDocument);
    connect(m_stage, &SequenceStage::changed, this, &StageView::followStage);
    connect(m_stage, &SequenceStage::frameFailed, this,
            [this](const QString& clip, const Error& error) { m_context.issues.add(error, clip); });
    retranslates(this, [this] {
        m_timeline->setAccessibleName(tr("Timeline"));
        m_viewport->setAccessibleName(tr("View"));
    });
    followDocument();
    m_viewport->setLayoutMode(widgets::Viewport::Layout::SideBySide);
}

void StageView::arrangeWidgets()
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
    splitter->addWidget(upper);
    splitter->addWidget(lower);
    splitter->setStretchFactor(0, 1);
    splitter->setCollapsible(0, false);
    columnOf(this)->addWidget(splitter);
}

void StageView::connectPlayback()
{
    using widgets::PlaybackBar;
    connect(m_timeline, &widgets::Timeline::frameScrubbed, m_player, &Player::goTo);
    connect(m_bar, &PlaybackBar::playToggled, m_player, &Player::toggle);
    connect(m_bar, &PlaybackBar::stepAsked, m_player, &Player::step);
    connect(m_bar, &PlaybackBar::firstAsked, m_player, &Player::goToStart);
    connect(m_bar, &PlaybackBar::lastAsked, m_player, &Player::goToEnd);
    connect(m_bar, &PlaybackBar::frameEntered, m_player, &Player::goTo);
    connect(m_bar, &PlaybackBar::loopToggled, this, [this](bool loops) {
        m_context.settings.setLoopsPlayback(loops);
        m_player->setLooping(loops);
    });
    connect(m_player, &Player::frameChanged, this, &StageView::showPlayhead);
    connect(m_player, &Player::playingChanged, m_bar, &PlaybackBar::setPlaying);
    connect(m_player, &Player::playingChanged, m_viewport, &widgets::Viewport::setMoving);
    connect(m_player, &Player::fpsReached, m_bar, &PlaybackBar::setFpsReached);
}

void StageView::followSettings()
{
    m_player->setLooping(m_context.settings.loopsPlayback());
    m_bar->setLooping(m_context.settings.loopsPlayback());
    m_viewport->setMousePreset(m_context.settings.mousePreset());
}

void StageView::connectTimeline()
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
    connect(m_timeline, &Timeline::loopRemovalAsked, this, [this] { setLoop(std::nullopt); });
}

void StageView::setLoop(std::optional<std::pair<int, int>> loop)
{
    m_timeline->setLoop(loop);
    // Who marks a part wants to see it again.
    if (loop && !m_context.settings.loopsPlayback())
        m_context.settings.setLoopsPlayback(true);
    updateRange();
}

void StageView::setLoopStart(int frame)
{
    setLoop(std::pair(frame, std::max(frame, m_timeline->playedRange().second)));
}

void StageView::setLoopEnd(int frame)
{
    setLoop(std::pair(std::min(m_timeline->playedRange().first, frame), frame));
}

void StageView::setUsualUnit(widgets::Timeline::Unit unit)
{
    m_timeline->setUnit(timelineUnit(m_timeline->objectName(), unit));
}

void StageView::setRulerUnit(widgets::Timeline::Unit unit)
{
    if (unit == m_timeline->unit())
        return;
    m_timeline->setUnit(unit);
    setTimelineUnit(m_timeline->objectName(), unit);
}

void StageView::setPlayhead(int frame)
{
    m_timeline->setCurrentFrame(frame);
    m_bar->setCurrentFrame(m_timeline->currentFrame());
}

void StageView::addBelowTimeline(QWidget* widget)
{
    m_lower->addWidget(widget);
}

/// What is shown has another name: it stays as it is, with its frame and the camera.
void StageView::followName(const ChangeEvent& event)
{
    if (event.entry.section != m_stage->section())
        return;
    m_stage->rename(event.before, event.entry.name);
    std::ranges::replace(m_names, event.before, event.entry.name);
    if (m_current == event.before)
        m_current = event.entry.name;
}

void StageView::followDocument()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    m_viewport->setUpAxis(settings.axes.up == UpAxis::Z ? widgets::UpAxis::Z : widgets::UpAxis::Y);
    m_viewport->setRuler(widgets::Ruler(settings.axes.metresPerUnit));
    m_player->setFps(settings.fps);
    m_bar->setFps(settings.fps);
    m_timeline->setFps(settings.fps);
}

void StageView::show(const QStringList& names)
{
    if (std::exchange(m_names, names) != names)
        m_timeline->setLoop(std::nullopt);
    m_stage->show(names);
    m_current = names.value(names.size() - 1);
    updateNames();
    followStage();
}

void StageView::setCurrent(const QString& name)
{
    m_current = name;
    followCharacter();
}

void StageView::followStage()
{
    m_bar->setFrameCount(static_cast<int>(m_stage->frameCount()));
    emit stageChanged();
    updateRange();
    m_bar->setCurrentFrame(m_timeline->currentFrame());
    followCharacter();
}

void StageView::updateRange()
{
    const std::int64_t frames = m_stage->frameCount();
    if (frames == 0) {
        m_player->pause();
        return;
    }
    const auto [first, last] = m_timeline->playedRange();
    m_player->setRange(FrameIndex(std::min<std::int64_t>(first, frames - 1)),
                       FrameIndex(std::min<std::int64_t>(last, frames - 1)));
    if (m_player->frame().value >= frames)
        m_player->goToStart();
    // What had no frames for a while is at the first one; the player tells where it is. Behind the clip,
    // where keys can be put, there is no picture, and the playhead stays.
    if (m_timeline->currentFrame() < frames)
        showPlayhead();
    if (std::exchange(m_playsWhenReady, false))
        m_player->play();
}

void StageView::showPlayhead()
{
    const auto frame = static_cast<int>(m_player->frame().value);
    m_timeline->setCurrentFrame(frame);
    m_bar->setCurrentFrame(frame);
}

void StageView::setNamesShown(bool shown)
{
    m_namesShown = shown;
    updateNames();
}

void StageView::updateNames()
{
    m_viewport->setNamesVisible(m_namesShown && m_stage->isComparing());
}

void StageView::setFollowing(bool follows)
{
    m_follows = follows;
    followCharacter();
}

void StageView::followCharacter()
{
    const int figure = m_stage->figureOf(m_current);
    m_viewport->setAnchor(figure);
    const auto followed = m_follows && figure >= 0 ? std::optional(figure) : std::nullopt;
    if (followed != m_viewport->followed())
        m_viewport->setFollowed(followed);
}

void StageView::setGhostsShown(bool shown)
{
    m_ghostsShown = shown;
    m_stage->ghosts().setInterval(shown ? m_tools->ghostInterval() : 0);
}

void StageView::setLayoutMode(widgets::Viewport::Layout layout)
{
    m_viewport->setLayoutMode(layout);
    if (layout == widgets::Viewport::Layout::Overlay && m_stage->isComparing() &&
        m_viewport->shading() == widgets::Shading::Textured)
        emit clayAsked();
    m_viewport->frameAll();
}

void StageView::setColoredByTool(bool colored)
{
    if (colored == m_isColoredByTool)
        return;
    m_isColoredByTool = colored;
    if (colored)
        m_viewport->setShading(widgets::Shading::Scalar);
    emit coloredByToolChanged();
}

void StageView::frameCurrent()
{
    m_viewport->frameFigure(m_stage->figureOf(m_current));
}

} // namespace quadrille
