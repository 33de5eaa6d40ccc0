// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/livesession.h"

#include "model/project/steps/livework.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr int mostTicksAtOnce = 4; ///< where the computer is too slow, time goes slower
constexpr double measuredSeconds = 0.5;
constexpr std::int64_t mostTicks = 1'000'000;

std::vector<SteeredParameter> steeredBy(const MotionSpace& space)
{
    std::vector<SteeredParameter> steered;
    for (std::size_t p = 0; p < space.parameters.size(); ++p)
        steered.push_back({space.parameters[p].measure, space.map.least.at(p), space.map.greatest.at(p)});
    return steered;
}

} // namespace

LiveSession::LiveSession(QObject* parent) : QObject(parent)
{
    constexpr int milliseconds = 4; // more often than pictures are drawn
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(milliseconds);
    connect(&m_timer, &QTimer::timeout, this, &LiveSession::catchUp);
}

LiveSession::~LiveSession() = default;

bool LiveSession::plays(const OpenedLiveGraphPointer& graph) const
{
    if (graph == nullptr || m_graph == nullptr)
        return false;
    return graph->content == m_graph->content && graph->graph->fps == m_graph->graph->fps &&
           graph->metresPerUnit == m_graph->metresPerUnit;
}

bool LiveSession::setGraph(OpenedLiveGraphPointer graph)
{
    if (graph == m_graph)
        return true;
    if (plays(graph)) {
        m_graph = std::move(graph); // names may be others
        emit decided();
        emit changed();
        return true;
    }
    m_timer.stop();
    m_graph = std::move(graph);
    m_player.reset();
    m_follower.reset();
    m_recordedFrom.reset();
    m_entry = {};
    m_inputs.clear();
    m_states.clear();
    m_visits.clear();
    m_decisions.clear();
    if (m_graph != nullptr) {
        LiveStart start;
        const auto& spaces = m_graph->graph->spaces;
        const auto cyclic = std::ranges::find_if(spaces, [](const auto& space) { return space->isCyclic; });
        start.space = cyclic == spaces.end() ? 0 : static_cast<std::size_t>(cyclic - spaces.begin());
        m_steering.setParameters(steeredBy(*spaces[start.space]));
        start.parameters = m_steering.values();
        m_wanted = start.space;
        begin(start, {});
    }
    emit decided();
    emit changed();
    emit ticked();
    return false;
}

void LiveSession::begin(const LiveStart& start, const LiveSettings& settings)
{
    m_start = start;
    m_player = std::make_unique<LivePlayer>(m_graph->graph, settings, start);
    m_pose.resize(m_graph->graph->vertexCount());
    m_inputs.clear();
    m_states.assign(1, m_player->state());
    m_visits.assign(1, {0, start.space});
    m_decisions.clear();
}

void LiveSession::run()
{
    if (!isReady() || isRunning())
        return;
    m_due = 0;
    m_clock.start();
    m_timer.start();
    emit changed();
}

void LiveSession::takeOver()
{
    const auto shown = static_cast<std::size_t>(state().tick);
    if (shown >= m_inputs.size())
        return;
    m_inputs.resize(shown);
    m_states.resize(shown + 1);
    std::erase_if(m_decisions, [this](const LiveDecision& each) { return each.tick > state().tick; });
    std::erase_if(m_visits, [this](const Visit& each) { return each.first > state().tick; });
    if (m_recordedFrom && *m_recordedFrom > state().tick)
        m_recordedFrom = state().tick;
    emit decided();
}

void LiveSession::pause()
{
    if (!isRunning())
        return;
    m_timer.stop();
    emit changed();
}

void LiveSession::restart()
{
    if (!isReady())
        return;
    m_recordedFrom.reset();
    const LiveSettings settings = m_player->settings();
    begin(m_start, settings);
    m_wanted = m_start.space;
    followSpace();
    m_followedTick = -1;
    emit decided();
    emit changed();
    emit ticked();
}

void LiveSession::followSpace()
{
    m_steering.setParameters(steeredBy(*m_graph->graph->spaces[m_wanted]));
}

void LiveSession::want(int space)
{
    if (!isReady() || space < 0 || space >= static_cast<int>(m_graph->spaces.size()))
        return;
    takeOver();
    leavePath();
    m_wanted = static_cast<std::size_t>(space);
    followSpace();
    emit changed();
}

void LiveSession::setParameter(std::size_t parameter, double value)
{
    takeOver();
    leavePath();
    m_steering.setValue(parameter, value);
}

void LiveSession::wantNext(int by)
{
    if (!isReady())
        return;
    const auto& spaces = m_graph->graph->spaces;
    const auto count = static_cast<int>(spaces.size());
    for (int i = 1; i <= count; ++i) {
        const int next = ((static_cast<int>(m_wanted) + by * i) % count + count) % count;
        if (spaces[static_cast<std::size_t>(next)]->isCyclic) {
            want(next);
            return;
        }
    }
}

void LiveSession::jump()
{
    if (!isReady())
        return;
    const auto& spaces = m_graph->graph->spaces;
    const auto once = std::ranges::find_if(spaces, [](const auto& space) { return !space->isCyclic; });
    if (once != spaces.end())
        want(static_cast<int>(once - spaces.begin()));
}

void LiveSession::setResponsive(bool responsive)
{
    m_isResponsive = responsive;
    emit changed();
}

void LiveSession::catchUp()
{
    m_due += static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
    m_clock.start();
    const double length = tickSeconds();
    int ticks = 0;
    for (; m_due >= length && ticks < mostTicksAtOnce; ++ticks) {
        m_due -= length;
        step();
    }
    m_due = std::min(m_due, length);
    if (tickCount() >= mostTicks)
        pause();
}

void LiveSession::step()
{
    if (!isReady())
        return;
    const SteeringState steered = m_steer ? m_steer() : SteeringState();
    if (isReplaying() && !steered.isIdle())
        takeOver();
    if (isReplaying()) {
        m_player->restore(stateAt(state().tick + 1));
        wantAsThen();
        if (!isReplaying())
            pause();
    } else {
        if (!steered.isIdle())
            leavePath();
        if (m_follower == nullptr) {
            m_steering.advance(steered, tickSeconds());
        } else if (!followOn()) {
            pause();
            return;
        }
        const std::size_t wanted = m_wanted;
        if (tick({.space = m_wanted, .parameters = m_steering.values(), .isResponsive = m_isResponsive}))
            emit decided();
        if (m_wanted != wanted)
            emit changed();
    }
    emit ticked();
}

bool LiveSession::tick(const LiveInput& input)
{
    if (m_inputs.empty() && (input.space != m_start.space || input.parameters != m_start.parameters)) {
        // It begins as it is wanted first: an entry of the project need not say that twice.
        LiveStart start = m_start;
        start.space = input.space;
        start.parameters = input.parameters;
        begin(start, LiveSettings(m_player->settings()));
    }
    QElapsedTimer timer;
    timer.start();
    const std::int64_t before = state().decisions;
    m_player->tick(input);
    m_inputs.push_back(input);
    m_states.push_back(state());
    m_tickMilliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    const std::size_t played = state().track.space;
    if (played != m_visits.back().space)
        m_visits.push_back({state().tick, played});
    // What has no cycle is played once.
    if (!m_graph->graph->spaces[m_wanted]->isCyclic && played == m_wanted && state().home != m_wanted) {
        m_wanted = state().home;
        followSpace();
    }
    if (state().decisions == before)
        return false;
    m_decisions.push_back(m_player->decision());
    return true;
}

std::span<const float> LiveSession::pose()
{
    QElapsedTimer timer;
    timer.start();
    m_player->pose(m_pose);
    const auto units = static_cast<float>(1 / m_graph->metresPerUnit);
    if (units != 1) {
        for (Vec3f& position : m_pose)
            position *= units;
    }
    m_poseMilliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    return {m_pose.front().data(), 3 * m_pose.size()};
}

void LiveSession::goTo(std::int64_t tick)
{
    if (!isReady())
        return;
    pause();
    m_player->restore(stateAt(std::clamp<std::int64_t>(tick, 0, tickCount())));
    wantAsThen();
    emit changed();
    emit ticked();
}

void LiveSession::wantAsThen()
{
    if (state().tick == 0)
        return;
    const LiveInput& input = m_inputs[static_cast<std::size_t>(state().tick - 1)];
    const bool isOther = m_wanted != input.space || m_isResponsive != input.isResponsive;
    m_wanted = input.space;
    m_isResponsive = input.isResponsive;
    followSpace();
    m_steering.setValues(input.parameters);
    if (isOther)
        emit changed();
}

const LiveDecision* LiveSession::lastDecision() const
{
    const auto after = std::ranges::upper_bound(m_decisions, state().tick, {}, &LiveDecision::tick);
    return after == m_decisions.begin() ? nullptr : &*(after - 1);
}

std::pair<double, double> LiveSession::measuredMotion() const
{
    const LiveTrack& now = m_player->state().track;
    const MotionSpace& space = *m_graph->graph->spaces[now.space];
    const auto frames = static_cast<double>(space.frameCount());
    double way = 0;
    double turn = 0;
    double played = 0; // frames
    std::int64_t t = state().tick;
    // A body that goes straight on turns with each step: over a whole cycle that counts for nothing.
    for (; t > 0 && (space.isCyclic ? played < frames : (state().tick - t) * tickSeconds() < measuredSeconds);
         --t) {
        const LiveTrack& a = stateAt(t - 1).track;
        const LiveTrack& b = stateAt(t).track;
        if (a.space != b.space)
            break; // the body is laid anew
        way += (b.root.shift - a.root.shift).norm();
        turn += b.root.turn - a.root.turn;
        played += b.phase - a.phase + (b.phase < a.phase ? frames : 0);
    }
    if (t == state().tick)
        return {0, 0};
    const double seconds = static_cast<double>(state().tick - t) * tickSeconds();
    return {way / seconds, turn * 180 / std::numbers::pi / seconds};
}

void LiveSession::startRecording()
{
    if (!isReady())
        return;
    takeOver();
    run();
    m_recordedFrom = state().tick;
    emit changed();
}

std::optional<LiveEntry> LiveSession::stopRecording()
{
    if (!m_recordedFrom)
        return std::nullopt;
    const std::int64_t from = *m_recordedFrom;
    m_recordedFrom.reset();
    pause();
    emit changed();
    if (tickCount() <= from)
        return std::nullopt;
    LiveEntry entry = m_entry;
    entry.spaces = m_graph->spaces;
    entry.inputs = changesOf(m_inputs);
    entry.ticks = tickCount();
    entry.from = from;
    return entry;
}

bool LiveSession::load(const LiveEntry& entry, const CoordinateSystem& axes)
{
    if (m_graph == nullptr || entry.inputs.empty())
        return false;
    std::vector<std::size_t> places;
    for (const std::string& space : entry.spaces) {
        const auto found = std::ranges::find(m_graph->spaces, space);
        if (found == m_graph->spaces.end())
            return false;
        places.push_back(static_cast<std::size_t>(found - m_graph->spaces.begin()));
    }
    m_timer.stop();
    m_follower.reset();
    m_recordedFrom.reset();
    LiveStart start = startOf(entry, axes);
    start.space = places.at(start.space);
    m_entry = entry;
    begin(start, settingsOf(entry));
    for (LiveInput input : inputsOf(entry)) {
        input.space = places.at(input.space);
        m_wanted = input.space;
        tick(input);
    }
    goTo(entry.from);
    emit decided();
    return true;
}

} // namespace quadrille

#include "moc_livesession.cpp"
