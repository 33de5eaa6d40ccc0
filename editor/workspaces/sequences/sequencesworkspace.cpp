// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/sequencesworkspace.h"

#include "editor/application/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/playback/player.h"
#include "editor/playback/sequencestage.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "widgets/timeline/playbackbar.h"
#include "widgets/timeline/timeline.h"
#include "widgets/viewport/viewport.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <utility>

namespace quadrille {

SequencesWorkspace::SequencesWorkspace(EditorContext& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_viewport(new widgets::Viewport)
    , m_timeline(new widgets::Timeline)
    , m_bar(new widgets::PlaybackBar)
    , m_stage(new SequenceStage(*m_viewport, context.media, context.jobs, this))
    , m_player(new Player(*m_stage, this))
    , m_sequenceTimeline(new SequenceTimeline(*m_timeline, context.document, context.media, this))
{
    setObjectName(QStringLiteral("sequencesWorkspace"));
    m_viewport->setObjectName(QStringLiteral("viewport"));
    m_timeline->setObjectName(QStringLiteral("timeline"));
    m_player->setLooping(context.settings.loopsPlayback());
    m_bar->setLooping(context.settings.loopsPlayback());

    auto* lower = new QWidget;
    auto* lowerColumn = new QVBoxLayout(lower);
    lowerColumn->setContentsMargins(0, 0, 0, 0);
    lowerColumn->setSpacing(0);
    lowerColumn->addWidget(m_bar);
    lowerColumn->addWidget(m_timeline, 1);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(m_viewport);
    splitter->addWidget(lower);
    splitter->setStretchFactor(0, 1);
    splitter->setCollapsible(0, false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(splitter);

    makeEditActions();
    makePlaybackActions();
    makeViewActions();
    connectPlayback();
    connect(&context.document, &ProjectDocument::changed, this, &SequencesWorkspace::followDocument);
    connect(&context.selection, &Selection::changed, this, &SequencesWorkspace::followSelection);
    connect(m_stage, &SequenceStage::changed, this, &SequencesWorkspace::followStage);
    connect(m_stage, &SequenceStage::frameFailed, this,
            [this](const QString& name, const Error& error) { m_context.issues.add(error, name); });
    connect(m_sequenceTimeline, &SequenceTimeline::rangeChanged, this, &SequencesWorkspace::followRange);
    retranslates(this, [this] { retranslate(); });
    followDocument();
}

void SequencesWorkspace::connectPlayback()
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
    connect(m_player, &Player::frameChanged, this, [this](qint64 frame) {
        m_timeline->setCurrentFrame(static_cast<int>(frame));
        m_bar->setCurrentFrame(static_cast<int>(frame));
    });
    connect(m_player, &Player::playingChanged, m_bar, &PlaybackBar::setPlaying);
    connect(m_player, &Player::fpsReached, m_bar, &PlaybackBar::setFpsReached);
}

void SequencesWorkspace::followDocument()
{
    const ProjectSettings& settings = m_context.document.project().settings;
    m_viewport->setUpAxis(settings.axes.up == UpAxis::Z ? widgets::UpAxis::Z : widgets::UpAxis::Y);
    m_player->setFps(settings.fps);
    m_bar->setFps(settings.fps);
    m_timeline->setFps(settings.fps);
}

void SequencesWorkspace::followSelection()
{
    const QStringList& names = m_context.selection.sequences();
    m_stage->show(names.size() > 1 ? names : QStringList{m_context.selection.shownSequence()});
    m_viewport->setLayoutMode(widgets::Viewport::Layout::SideBySide);
    followStage();
}

void SequencesWorkspace::followStage()
{
    const std::int64_t frames = m_stage->frameCount();
    m_sequenceTimeline->show(m_context.selection.shownSequence(), m_stage->isComparing() ? frames : 0);
    m_bar->setFrameCount(static_cast<int>(frames));
    followRange();
}

void SequencesWorkspace::followRange()
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

void SequencesWorkspace::retranslate()
{
    m_timeline->setAccessibleName(tr("Timeline"));
    m_viewport->setAccessibleName(tr("View"));
}

} // namespace quadrille
