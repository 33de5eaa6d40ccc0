// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/liveworkspace.h"

#include "editor/commands/liveedits.h"
#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/live/gamepad.h"
#include "editor/workspaces/live/livebar.h"
#include "editor/workspaces/live/livekeys.h"
#include "editor/workspaces/live/livepaths.h"
#include "editor/workspaces/live/livesession.h"
#include "editor/workspaces/live/rewindpanel.h"
#include "editor/workspaces/live/spacegraph.h"
#include "editor/workspaces/live/steeringpanel.h"
#include "model/project/document/findentry.h"
#include "model/project/steps/motionspacesteps.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"
#include "widgets/timeline/playbackbar.h"

#include <QAction>
#include <QDeadlineTimer>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

namespace {

/// The ruler need not follow each tick.
constexpr int ticksBetweenRulers = 8;
constexpr double leastRulerSeconds = 10; ///< shown at least: from the first ticks on time runs from the left

} // namespace

LiveWorkspace::LiveWorkspace(EditorContext& context, QWidget* parent)
    : Workspace(parent)
    , m_context(context)
    , m_view(new SceneView(context, source(), QStringLiteral("live")))
    , m_session(new LiveSession(this))
    , m_keys(new LiveKeys(*this))
    , m_gamepad(new Gamepad(this))
    , m_paths(new LivePaths(context, *m_session, m_view->viewport(), this))
    , m_pictures(new FramePictures(context.document, context.media, context.jobs, this))
{
    setObjectName(QStringLiteral("liveWorkspace"));
    makeActions();
    m_bar = new LiveBar(context, *m_session, *m_paths);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_bar);
    column->addWidget(m_view, 1);
    makePanels();
    connectSession();
    connectView();
    connect(&context.document, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
        if (event.kind == ChangeEvent::Kind::Reset)
            m_session->setGraph(nullptr); // what was played is of another project
        follow();
    });
    connect(&context.document, &ProjectDocument::renamed, this, [this](const ChangeEvent& event) {
        if (event.entry.section == Section::Lives && event.before == m_loaded)
            m_loaded = event.entry.name;
    });
    connect(&context.selection, &Selection::changed, this, &LiveWorkspace::followSelection);
    connect(&context.liveGraphs, &LiveGraphResults::changed, this, &LiveWorkspace::followGraph);
    retranslates(this, [this] { showState(); });
}

QString LiveWorkspace::figureName()
{
    return tr("Performer");
}

ClipScene::Source LiveWorkspace::source()
{
    return {.clip = [this](const QString& /*name*/,
                           bool) { return m_session->isReady() ? &m_session->graph()->look : nullptr; },
            .upAxis = [this] { return m_context.media.upAxis(); },
            .drawsWay = false,
            .section = Section::Lives};
}

void LiveWorkspace::makePanels()
{
    auto* graph =
        new SpaceGraph(m_context, *m_session, [this](const QString& space) { return pictureOf(space); });
    connect(m_pictures, &FramePictures::drawn, graph, &SpaceGraph::showPictures);
    m_steering = new SteeringPanel(*graph, *m_session, *m_gamepad);
    m_panels.push_back({"steeringDock", [] { return tr("Steering"); }, m_steering});
    Panel rewind{"rewindDock", [] { return tr("Rewind"); }, new RewindPanel(*m_session)};
    rewind.isLower = true;
    m_panels.push_back(std::move(rewind));
}

void LiveWorkspace::connectSession()
{
    m_session->setSteer([this] {
        m_gamepad->poll();
        const SteeringState keys = m_keys->state();
        return keys.isIdle() ? m_gamepad->state() : keys;
    });
    connect(m_session, &LiveSession::changed, this, &LiveWorkspace::followRunning);
    connect(m_session, &LiveSession::ticked, this, &LiveWorkspace::showPose);
    connect(m_session, &LiveSession::ticked, this, &LiveWorkspace::showTimeline);
    connect(m_session, &LiveSession::decided, this, &LiveWorkspace::showTimeline);
    connect(m_paths, &LivePaths::beginning, this, &LiveWorkspace::finishRecording);
    connect(&m_context.document, &ProjectDocument::settling, this, &LiveWorkspace::finishRecording);
    connect(m_paths, &LivePaths::failed, this, [this](const Error& error) {
        const ErrorText text = describe(error);
        m_help.clear();
        m_view->message().show(widgets::MessageStrip::Kind::Error, text.placed(), text.remedy);
    });
    connect(m_keys, &LiveKeys::spacePressed, m_session, &LiveSession::want);
    connect(m_keys, &LiveKeys::jumpPressed, m_session, &LiveSession::jump);
    connect(m_keys, &LiveKeys::responsivePressed, this,
            [this] { m_session->setResponsive(!m_session->isResponsive()); });
    // A session that runs polls with each tick.
    constexpr int millisecondsBetweenPolls = 100;
    m_gamepadPolls.setInterval(millisecondsBetweenPolls);
    connect(&m_gamepadPolls, &QTimer::timeout, m_gamepad, &Gamepad::poll);
    connect(m_gamepad, &Gamepad::jumpPressed, m_session, &LiveSession::jump);
    connect(m_gamepad, &Gamepad::spacePressed, m_session, &LiveSession::wantNext);
    connect(m_gamepad, &Gamepad::recordPressed, this, &LiveWorkspace::toggleRecording);
    connect(m_gamepad, &Gamepad::connectedChanged, this, [this] {
        if (!m_gamepad->isConnected() && m_session->isRunning()) {
            m_session->pause();
            m_view->message().show(widgets::MessageStrip::Kind::Warning, tr("The gamepad was pulled out."),
                                   tr("Plug it in again, or steer by keys; Space goes on."));
        }
    });
}

void LiveWorkspace::connectView()
{
    m_view->setUsualUnit(widgets::Timeline::Unit::Seconds);
    // The session plays, not the player of clips.
    connect(&player(), &Player::playingChanged, this, [this](bool isPlaying) {
        if (!isPlaying)
            return;
        player().pause();
        toggle();
    });
    // What it shows as it pauses is a frame of the look, not the tick.
    connect(&player(), &Player::frameChanged, this, &LiveWorkspace::showTimeline);
    connect(&m_view->timeline(), &widgets::Timeline::frameScrubbed, m_session, &LiveSession::goTo);
    using widgets::PlaybackBar;
    const PlaybackBar* bar = &m_view->playback();
    connect(bar, &PlaybackBar::frameEntered, m_session, &LiveSession::goTo);
    connect(bar, &PlaybackBar::firstRequested, m_session, [this] { m_session->goTo(0); });
    connect(bar, &PlaybackBar::lastRequested, m_session, [this] { m_session->goTo(m_session->tickCount()); });
    connect(bar, &PlaybackBar::stepRequested, m_session, [this](int ticks) {
        if (m_session->isReady())
            m_session->goTo(m_session->state().tick + ticks);
    });
    connect(m_view, &SceneView::sceneChanged, this, &LiveWorkspace::showTimeline);
    connect(&scene(), &ClipScene::frameShown, this, &LiveWorkspace::showPose);
    connect(&viewport(), &widgets::Viewport::rendered, m_steering, &SteeringPanel::setPictureTime);
    connect(&viewport(), &widgets::Viewport::rendered, this, &LiveWorkspace::measure, Qt::QueuedConnection);
    connect(&m_view->message(), &widgets::MessageStrip::actionTriggered, this, [this] {
        if (!m_failed.isEmpty())
            editSpace(m_failed);
        else if (m_help.isEmpty())
            m_context.liveGraphs.retry(character());
        else
            m_context.actions.action(m_help)->trigger();
    });
}

QString LiveWorkspace::character() const
{
    const Project& project = m_context.document.project();
    if (project.motionSpaces.empty())
        return {};
    if (const SequenceEntry* shown =
            findSequence(project, m_context.selection.shownSequence().toStdString())) {
        const CharacterEntry* own = characterOf(project, *shown);
        if (own != nullptr && !playableSpaces(project, own->name).empty())
            return QString::fromStdString(own->name);
    }
    // No name is one, too.
    return QStringLiteral("") +
           QString::fromStdString(characterNameOf(project, project.motionSpaces.front()));
}

void LiveWorkspace::setActive(bool active)
{
    m_isActive = active;
    if (!active)
        m_session->pause();
    follow();
    followRunning();
    // A performer who is steered leaves the view at once; the menu's wish is put in for each workspace first.
    if (active)
        QMetaObject::invokeMethod(
            this, [this] { m_view->setFollowing(true); }, Qt::QueuedConnection);
}

/// Spaces are computed only while somebody looks.
void LiveWorkspace::follow()
{
    if (!m_isActive)
        return;
    m_context.liveGraphs.want(character());
    followGraph();
    showTimeline();
}

void LiveWorkspace::followGraph()
{
    if (!m_isActive)
        return;
    const LiveGraphResults::State* state = m_context.liveGraphs.resultState(character());
    const OpenedLiveGraphPointer graph = state == nullptr ? nullptr : state->graph;
    if (graph != m_session->graph()) {
        if (!m_session->plays(graph))
            finishRecording();
        if (!m_session->setGraph(graph)) {
            m_loaded.clear();
            m_view->show(QStringList());
        }
        if (graph != nullptr) {
            m_view->show({figureName()});
            scene().update(figureName());
        }
        followSelection();
    }
    const bool isComputed = state != nullptr && state->phase == ResultPhase::Computing;
    m_bar->showProgress(isComputed && state->job ? state->job->fraction() : -1);
    if (isComputed && state->job && m_job != state->job) {
        m_job = state->job;
        connect(m_job, &Job::changed, m_bar, [this] {
            if (m_job)
                m_bar->showProgress(m_job->fraction());
        });
    }
    showState();
}

/// A performance that is selected is played again.
void LiveWorkspace::followSelection()
{
    if (!m_isActive)
        return;
    const EntryRef& current = m_context.selection.current();
    const LiveEntry* entry = current.section == Section::Lives
                                 ? findLive(m_context.document.project(), current.name.toStdString())
                                 : nullptr;
    if (entry != nullptr && current.name != m_loaded && m_session->graph() != nullptr &&
        !m_session->isRecording()) {
        m_loaded = current.name;
        m_session->load(*entry, m_context.document.project().settings.axes);
    }
    offerClip();
}

void LiveWorkspace::followRunning()
{
    const bool isRunning = m_session->isRunning();
    m_keys->setEnabled(m_isActive && isRunning);
    m_gamepadPolls.stop();
    if (m_isActive && m_session->isReady() && !isRunning)
        m_gamepadPolls.start();
    if (m_session->isReady())
        m_view->setPictureRate(1 / m_session->tickSeconds());
    viewport().setMoving(isRunning);
    m_view->playback().setPlaying(isRunning);
    const auto icon = isRunning ? QStringLiteral("pause") : QStringLiteral("play");
    m_context.actions.action(QStringLiteral("live.run"))->setIcon(widgets::icons::icon(icon));
    for (const char* id : {"live.run", "live.record", "live.restart"})
        m_context.actions.action(QLatin1String(id))->setEnabled(m_session->isReady());
    if (isRunning)
        m_view->message().clear();
    else
        m_rate.restart();
    showTimeline();
}

void LiveWorkspace::measure()
{
    if (!m_session->isRunning())
        return;
    const double now = 1e-9 * static_cast<double>(QDeadlineTimer::current().deadlineNSecs());
    m_rate.painted(m_session->state().tick, now);
    if (const auto reached = m_rate.report(now))
        m_view->playback().setFpsReached(*reached);
}

QImage LiveWorkspace::pictureOf(const QString& space)
{
    const MotionSpaceEntry* entry = findMotionSpace(m_context.document.project(), space.toStdString());
    if (entry == nullptr || entry->takes.empty())
        return {};
    const QString take = QString::fromStdString(entry->takes.front().sequence);
    const MeshSequence* sequence = m_context.media.sequence(take);
    return sequence == nullptr ? QImage() : m_pictures->picture(take, FrameIndex(sequence->frameCount() / 2));
}

void LiveWorkspace::showPose()
{
    const int figure = scene().figureOf(figureName());
    if (!m_session->isReady() || figure < 0)
        return;
    viewport().setPositions(figure, m_session->pose());
    // Its texture is that of the captured frame, which comes as soon as it is read.
    const FrameIndex look = m_session->graph()->lookOf(m_session->provenance());
    if (look != scene().comingFrame())
        scene().showFrame(look, 1);
}

void LiveWorkspace::showTimeline()
{
    widgets::Timeline& timeline = m_view->timeline();
    if (!m_session->isReady()) {
        timeline.setFrameCount(0);
        timeline.setTracks({});
        m_shownTicks = 0;
        return;
    }
    const auto ticks = static_cast<int>(m_session->tickCount());
    const bool isDue = ticks < m_shownTicks || ticks >= m_shownTicks + ticksBetweenRulers;
    if (!m_session->isRunning() || isDue || ticks >= timeline.frameCount()) {
        m_shownTicks = ticks;
        timeline.setFps(1 / m_session->tickSeconds());
        const auto least = static_cast<int>(leastRulerSeconds / m_session->tickSeconds());
        const int coming = m_session->isRunning() ? ticksBetweenRulers : 0; // till it is measured again
        timeline.setFrameCount(std::max(ticks + 1 + coming, least));
        timeline.setRange(std::pair(0, ticks));
        m_view->playback().setFps(1 / m_session->tickSeconds());
        widgets::TimelineTrack track{.id = QStringLiteral("spaces"), .title = tr("Spaces")};
        for (const LiveSession::Visit& visit : m_session->visits()) {
            if (!track.spans.empty())
                track.spans.back().last = static_cast<int>(visit.first) - 1;
            track.spans.push_back({.id = static_cast<int>(track.spans.size()),
                                   .first = static_cast<int>(visit.first),
                                   .last = ticks,
                                   .text = QString::fromStdString(m_session->graph()->spaces[visit.space]),
                                   .color = widgets::Theme::categorical(static_cast<int>(visit.space))});
        }
        timeline.setTracks({std::move(track)});
    }
    m_view->playback().setFrameCount(ticks + 1);
    m_view->setPlayhead(static_cast<int>(m_session->state().tick));
}

/// The motion space whose settings are to be mended; empty where trying again may help: a file that is not
/// there may come.
QString LiveWorkspace::failedSpace(const Error& error) const
{
    const auto& values = error.context().values;
    const auto step = std::ranges::find(values, "step", &std::pair<std::string, std::string>::first);
    if (step == values.end() || !error.context().file.empty())
        return {};
    const std::string space = motionSpaceOfStep(step->second);
    return findMotionSpace(m_context.document.project(), space) == nullptr ? QString()
                                                                           : QString::fromStdString(space);
}

void LiveWorkspace::editSpace(const QString& name)
{
    m_context.selection.select({Section::MotionSpaces, name});
    m_context.actions.action(QStringLiteral("edit.properties"))->trigger();
}

/// Says what is missing or went wrong, and offers what helps.
void LiveWorkspace::showState()
{
    using Kind = widgets::MessageStrip::Kind;
    const Project& project = m_context.document.project();
    widgets::MessageStrip& message = m_view->message();
    const LiveGraphResults::State* state = m_context.liveGraphs.resultState(character());
    m_help.clear();
    m_failed.clear();
    viewport().setNotice(
        project.sequences.empty() ? tr("Import takes of somebody first: walks, turns, jumps.") : QString());
    if (!project.sequences.empty() && project.motionSpaces.empty()) {
        message.show(Kind::Info,
                     tr("Here takes of one kind become a movement that you steer: walks by their speed."),
                     tr("Select some takes and make a motion space of them."));
        m_help = QStringLiteral("motionSpaces.new");
        message.setAction(tr("New motion space"));
    } else if (state != nullptr && state->phase == ResultPhase::Failed && state->error) {
        const ErrorText text = describe(*state->error);
        message.show(Kind::Error, text.placed(), text.remedy);
        m_failed = failedSpace(*state->error);
        message.setAction(m_failed.isEmpty() ? tr("Try again") : tr("Edit the motion space"));
    } else {
        message.clear();
    }
}

} // namespace quadrille

#include "moc_liveworkspace.cpp"
