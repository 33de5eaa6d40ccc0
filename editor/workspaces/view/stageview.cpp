// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/view/stageview.h"

#include "editor/application/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/view/viewtools.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/playbackbar.h"

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
    m_player->setLooping(context.settings.loopsPlayback());
    m_bar->setLooping(context.settings.loopsPlayback());
    arrangeWidgets();
    connectPlayback();
    connect(m_tools, &ViewTools::ghostIntervalChanged, this, [this] { setGhostsShown(m_ghostsShown); });
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
    upperColumn->addWidget(m_message);
    upperColumn->addWidget(m_viewport, 1);
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
    connect(&m_context.settings, &Settings::changed, this, [this] {
        m_player->setLooping(m_context.settings.loopsPlayback());
        m_bar->setLooping(m_context.settings.loopsPlayback());
    });
    connect(m_bar, &PlaybackBar::loopToggled, this, [this](bool loops) {
        m_context.settings.setLoopsPlayback(loops);
        m_player->setLooping(loops);
    });
    connect(m_player, &Player::frameChanged, this, [this](qint64 frame) {
        m_timeline->setCurrentFrame(static_cast<int>(frame));
        m_bar->setCurrentFrame(static_cast<int>(frame));
    });
    connect(m_player, &Player::playingChanged, m_bar, &PlaybackBar::setPlaying);
    connect(m_player, &Player::fpsReached, m_bar, &PlaybackBar::setFpsReached);
}

void StageView::addBelowTimeline(QWidget* widget)
{
    m_lower->addWidget(widget);
}

void StageView::followDocument()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    m_viewport->setUpAxis(settings.axes.up == UpAxis::Z ? widgets::UpAxis::Z : widgets::UpAxis::Y);
    m_player->setFps(settings.fps);
    m_bar->setFps(settings.fps);
    m_timeline->setFps(settings.fps);
}

void StageView::show(const QStringList& names)
{
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
    followCharacter();
}

void StageView::updateRange()
{
    const std::int64_t frames = m_stage->frameCount();
    if (frames == 0) {
        m_player->pause();
        return;
    }
    const auto [first, last] = m_timeline->range();
    m_player->setRange(FrameIndex(std::min<std::int64_t>(first, frames - 1)),
                       FrameIndex(std::min<std::int64_t>(last, frames - 1)));
    if (m_player->frame().value >= frames)
        m_player->goToStart();
    if (std::exchange(m_playsWhenReady, false))
        m_player->play();
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
    const auto followed = m_follows && figure >= 0 ? std::optional(figure) : std::nullopt;
    if (followed != m_viewport->followed())
        m_viewport->setFollowed(followed);
}

void StageView::setGhostsShown(bool shown)
{
    m_ghostsShown = shown;
    m_stage->setGhostInterval(shown ? m_tools->ghostInterval() : 0);
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
