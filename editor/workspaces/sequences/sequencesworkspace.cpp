// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/sequencesworkspace.h"

#include "editor/application/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/exporting/pictureflow.h"
#include "editor/language/retranslate.h"
#include "editor/playback/player.h"
#include "editor/playback/sequencestage.h"
#include "editor/workspaces/sequences/contactproposal.h"
#include "editor/workspaces/sequences/posecomparison.h"
#include "editor/workspaces/sequences/sequencetimeline.h"
#include "editor/workspaces/sequences/viewtools.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/timeline/playbackbar.h"
#include "widgets/timeline/timeline.h"

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
    , m_contacts(new ContactProposal(context, this))
    , m_message(new widgets::MessageStrip)
    , m_pictures(new PictureFlow(context, *m_viewport, this))
{
    setObjectName(QStringLiteral("sequencesWorkspace"));
    m_viewport->setObjectName(QStringLiteral("viewport"));
    m_timeline->setObjectName(QStringLiteral("timeline"));
    m_message->setObjectName(QStringLiteral("viewMessage"));
    m_player->setLooping(context.settings.loopsPlayback());
    m_bar->setLooping(context.settings.loopsPlayback());

    makeEditActions();
    makePlaybackActions();
    makeViewActions();
    connect(m_comparison, &PoseComparison::changed, this, &SequencesWorkspace::showState);
    m_tools = new ViewTools(context.actions);
    arrangeWidgets();
    connectPlayback();
    connect(m_tools, &ViewTools::ghostIntervalChanged, m_stage, &SequenceStage::setGhostInterval);
    connect(m_contacts, &ContactProposal::foundNothing, this, [this](const QString& name) {
        m_message->show(widgets::MessageStrip::Kind::Info,
                        tr("No foot contacts were found in “%1”.").arg(name),
                        tr("Mark them by hand: draw in the track of a foot in the timeline."));
        m_message->setAction({});
    });
    connect(m_message, &widgets::MessageStrip::actionTriggered, this,
            [this] { m_context.media.retry(m_context.selection.shownSequence()); });
    connect(&context.document, &ProjectDocument::changed, this, &SequencesWorkspace::followDocument);
    connect(&context.selection, &Selection::changed, this, &SequencesWorkspace::followSelection);
    connect(m_stage, &SequenceStage::changed, this, &SequencesWorkspace::followStage);
    connect(m_stage, &SequenceStage::frameFailed, this,
            [this](const QString& name, const Error& error) { m_context.issues.add(error, name); });
    connect(m_sequenceTimeline, &SequenceTimeline::rangeChanged, this, &SequencesWorkspace::followRange);
    retranslates(this, [this] { retranslate(); });
    followDocument();
    m_viewport->setLayoutMode(widgets::Viewport::Layout::SideBySide);
}

void SequencesWorkspace::arrangeWidgets()
{
    auto* upper = new QWidget;
    auto* upperColumn = new QVBoxLayout(upper);
    upperColumn->setContentsMargins(0, 0, 0, 0);
    upperColumn->setSpacing(0);
    upperColumn->addWidget(m_tools);
    upperColumn->addWidget(m_message);
    upperColumn->addWidget(m_viewport, 1);
    auto* lower = new QWidget;
    auto* lowerColumn = new QVBoxLayout(lower);
    lowerColumn->setContentsMargins(0, 0, 0, 0);
    lowerColumn->setSpacing(0);
    lowerColumn->addWidget(m_bar);
    lowerColumn->addWidget(m_timeline, 1);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(upper);
    splitter->addWidget(lower);
    splitter->setStretchFactor(0, 1);
    splitter->setCollapsible(0, false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(splitter);
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
    m_message->clear();
    m_tools->setComparing(m_stage->isComparing());
    followNames();
    followStage();
}

void SequencesWorkspace::followStage()
{
    const std::int64_t frames = m_stage->frameCount();
    m_sequenceTimeline->show(m_context.selection.shownSequence(), m_stage->isComparing() ? frames : 0);
    m_bar->setFrameCount(static_cast<int>(frames));
    followRange();
    followCharacter();
    showState();
}

void SequencesWorkspace::followCharacter()
{
    const bool follows = m_context.actions.action(QStringLiteral("view.follow"))->isChecked();
    const int figure = m_stage->figureOf(m_context.selection.shownSequence());
    const auto followed = follows && figure >= 0 ? std::optional(figure) : std::nullopt;
    if (followed != m_viewport->followed())
        m_viewport->setFollowed(followed);
}

void SequencesWorkspace::followNames()
{
    const bool shown = m_context.actions.action(QStringLiteral("view.names"))->isChecked();
    m_viewport->setNamesVisible(shown && m_stage->isComparing());
}

void SequencesWorkspace::setLayout(widgets::Viewport::Layout layout)
{
    m_viewport->setLayoutMode(layout);
    // Textures look alike where figures stand in one place: only clay has a colour for each.
    if (layout == widgets::Viewport::Layout::Overlay && m_stage->isComparing() &&
        m_viewport->shading() == widgets::Shading::Textured)
        m_context.actions.action(QStringLiteral("view.clay"))->trigger();
    m_viewport->frameAll();
}

/// Says what is on its way or went wrong, where it will be seen.
void SequencesWorkspace::showState()
{
    const QString& name = m_context.selection.shownSequence();
    const auto* medium = m_context.media.medium(name);
    QString notice;
    if (medium == nullptr)
        notice = tr("No sequences yet. Drop files here, or import them from the File menu.");
    else if (medium->state == SequenceMedia::State::Loading && m_stage->isEmpty())
        notice = tr("Opening “%1”…").arg(name);
    else if (medium->state == SequenceMedia::State::Failed && m_stage->isEmpty())
        notice = tr("“%1” cannot be shown.").arg(name);
    m_viewport->setNotice(notice);
    if (medium != nullptr && medium->error) {
        const ErrorText text = describe(*medium->error);
        const QString sentence =
            text.where.isEmpty() ? text.sentence : tr("%1 (%2)").arg(text.sentence, text.where);
        m_message->show(widgets::MessageStrip::Kind::Error, sentence, text.remedy);
        m_message->setAction(tr("Try Again"));
    } else if (const QString problem = m_comparison->problem(); !problem.isEmpty()) {
        m_message->show(widgets::MessageStrip::Kind::Warning, problem, m_comparison->remedy());
        m_message->setAction({});
    } else if (m_message->kind() != widgets::MessageStrip::Kind::Info) {
        m_message->clear();
    }
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
    showState();
}

} // namespace quadrille
