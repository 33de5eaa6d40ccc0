// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/liveplayer.h"

#include "model/core/badargument.h"
#include "model/live/groundfit.h"
#include "model/live/movingplace.h"
#include "model/parametric/hybridblend.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

SpacePoint between(const SpacePoint& a, const SpacePoint& b, double share)
{
    SpacePoint place;
    for (std::size_t d = 0; d < place.size(); ++d)
        place[d] = std::lerp(a[d], b[d], share);
    return place;
}

void moveOverGround(const GroundMotion& motion, const Ground& ground, MutablePositions positions)
{
    const RigidMotion inSpace = motion.inSpace(ground);
    const Eigen::Matrix3f turn = inSpace.rotation.toRotationMatrix().cast<float>();
    const Vec3f shift = inSpace.translation.cast<float>();
    for (Vec3f& position : positions)
        position = turn * position + shift;
}

void check(const LiveSettings& settings)
{
    const auto isShare = [](double value) { return value >= 0 && value <= 1; };
    if (settings.ticksPerFrame < 1)
        refuse("A frame has no tick", "Let it have at least one.");
    if (!(settings.fadeSeconds > 0) || !(settings.secondsAcross > 0))
        refuse("Fading, or going over a space, takes no time", "Give both some seconds.");
    if (!(settings.search.latencyWeight > 0) || !(settings.responsiveWeight > 0))
        refuse("A weight of latency is not positive", "Give it one, such as 5.");
    if (!isShare(settings.earliestLeave) || !isShare(settings.latestArrival))
        refuse("A share of a space is not between 0 and 1", "Give it one that is.");
}

} // namespace

const TransitionChoice* LiveDecision::goingOn() const
{
    for (std::size_t i = 1; i < count; ++i) {
        if (choices[i].sourceFrames > choices[0].sourceFrames)
            return &choices[i];
    }
    return nullptr;
}

LivePlayer::LivePlayer(std::shared_ptr<const LiveGraph> graph, const LiveSettings& settings,
                       const LiveStart& start)
    : m_graph(std::move(graph))
    , m_settings(settings)
    , m_other(m_graph->vertexCount())
    , m_fitted(m_graph->vertexCount())
{
    check(m_settings);
    m_settings.search.choices = LiveDecision::mostChoices;
    const std::size_t count = m_graph->spaces.size();
    m_links.resize(count);
    for (std::size_t source = 0; source < count; ++source) {
        m_links[source].resize(count);
        for (std::size_t target = 0; target < count; ++target) {
            const auto& table = m_graph->tables[source][target];
            if (table == nullptr)
                continue;
            const MotionSpace& from = *m_graph->spaces[source];
            const MotionSpace& to = *m_graph->spaces[target];
            TransitionSearchSettings search = m_settings.search;
            search.stepsAFrame =
                stepsAFrame(search.steps, m_settings.secondsAcross, std::max(from.fps, to.fps));
            m_links[source][target].smooth = std::make_unique<TransitionSearch>(table, from, to, search);
            search.latencyWeight = m_settings.responsiveWeight;
            m_links[source][target].responsive = std::make_unique<TransitionSearch>(table, from, to, search);
        }
    }
    this->start(start);
}

void LivePlayer::start(const LiveStart& start)
{
    m_state = {};
    m_decision = {};
    const double last = static_cast<double>(m_graph->spaces[start.space]->frameCount() - 1);
    m_state.track = {.space = start.space,
                     .phase = std::clamp(start.frame, 0.0, last),
                     .place = wantedPlace(start.space, start.parameters),
                     .root = start.root};
    m_state.left = m_state.track;
    m_state.wanted = start.space;
    m_state.home = start.space;
    m_state.homeParameters = start.parameters;
    if (isCyclic(m_state.track))
        return;
    for (std::size_t space = 0; space < m_graph->spaces.size(); ++space) {
        const ParameterMap& map = m_graph->spaces[space]->map;
        if (m_graph->spaces[space]->isCyclic && m_graph->leads(start.space, space)) {
            m_state.home = space;
            m_state.homeParameters = between(map.least, map.greatest, 0.5);
            return;
        }
    }
}

SpacePoint LivePlayer::wantedPlace(std::size_t space, const SpacePoint& parameters) const
{
    const MotionSpace& wanted = *m_graph->spaces[space];
    return wanted.weights.placeOf(wanted.weights.at(wanted.map.placeOf(parameters)));
}

/// A space without a cycle is left for the last one with a cycle where nothing else is wanted.
std::size_t LivePlayer::wantedSpace(const LiveInput& input) const
{
    const bool isPlayed = input.space == m_state.track.space;
    return isPlayed && !isCyclic(m_state.track) ? m_state.home : input.space;
}

bool LivePlayer::mayLeave() const
{
    if (m_state.way == LiveState::Way::Leaving || m_state.fade < 1)
        return false;
    if (isCyclic(m_state.track))
        return true;
    // What is left goes on while it fades, and the trellis has its depth.
    const double last = static_cast<double>(spaceOf(m_state.track).frameCount() - 1);
    return m_state.track.phase >=
           std::min(m_settings.earliestLeave * last, last - fadeFrames() - 0.5 * m_settings.search.depth);
}

void LivePlayer::decide(const LiveInput& input)
{
    const std::size_t wanted = wantedSpace(input);
    if (m_state.way == LiveState::Way::Leaving && m_state.target != wanted)
        m_state.way = LiveState::Way::Free; // something else is wanted meanwhile
    const std::size_t source = m_state.track.space;
    if (wanted == source || !mayLeave() || !m_graph->leads(source, wanted))
        return;
    const MotionSpace& target = *m_graph->spaces[wanted];
    const std::size_t last = target.frameCount() - 1;
    const auto latest = static_cast<std::size_t>(m_settings.latestArrival * static_cast<double>(last));
    // Parameters are of the space that the input names.
    const SpacePoint& parameters = wanted == input.space ? input.parameters : m_state.homeParameters;
    m_decision = {.tick = m_state.tick,
                  .wished = m_state.wished,
                  .source = source,
                  .target = wanted,
                  .state = {m_state.track.phase, m_state.track.place},
                  .goal = {0, target.isCyclic ? last : latest, wantedPlace(wanted, parameters)},
                  .isResponsive = input.isResponsive,
                  .choices = {},
                  .count = 0};
    Link& link = m_links[source][wanted];
    const std::span<const TransitionChoice> found =
        (input.isResponsive ? *link.responsive : *link.smooth).search(m_decision.state, m_decision.goal);
    m_decision.count = std::min(found.size(), LiveDecision::mostChoices);
    std::copy_n(found.begin(), m_decision.count, m_decision.choices.begin());
    if (!isCyclic(m_state.track)) {
        // What is left goes on for half of the fade at least, where one of the best ways lets it.
        const double latestLeave =
            static_cast<double>(spaceOf(m_state.track).frameCount() - 1) - fadeFrames() / 2;
        const auto end = m_decision.choices.begin() + static_cast<std::ptrdiff_t>(m_decision.count);
        const auto good = std::find_if(m_decision.choices.begin(), end, [&](const TransitionChoice& choice) {
            return static_cast<double>(choice.leavingFrame) <= latestLeave;
        });
        if (good != end)
            std::rotate(m_decision.choices.begin(), good, good + 1);
    }
    ++m_state.decisions;
    m_state.choice = m_decision.choices.front();
    m_state.target = wanted;
    m_state.way = LiveState::Way::Leaving;
    m_state.wayStart = m_state.track.place;
    m_state.wayGoal = m_decision.goal.place;
    // The search counts from the nearest whole frame.
    const double frames = static_cast<double>(spaceOf(m_state.track).frameCount());
    const double nearest = static_cast<double>(
        nearestFrame(m_state.track.phase, spaceOf(m_state.track).frameCount(), isCyclic(m_state.track)));
    double ahead = m_state.track.phase - nearest;
    if (ahead > frames / 2)
        ahead -= frames; // the first frame of a cycle, seen from its end
    m_state.wayFrames = ahead;
    m_state.wayEnd = m_state.choice.sourceFrames;
}

/// The target stands where it fits the source best.
void LivePlayer::switchOver()
{
    const TransitionChoice& choice = m_state.choice;
    const double beyond = m_state.wayFrames - m_state.wayEnd; // where it was a part of a frame late
    LiveTrack track{.space = m_state.target,
                    .phase = static_cast<double>(choice.arrivalFrame) + std::max(beyond, 0.0),
                    .place = choice.arrivalPlace,
                    .root = {}};
    const MotionSpace& target = spaceOf(track);
    const double last = static_cast<double>(target.frameCount() - 1);
    track.phase = std::min(track.phase, target.isCyclic ? last + 0.999 : last);
    poseOf(m_state.track, m_other);
    poseOf(track, m_fitted);
    track.root = fitOverGround(m_fitted, m_other, Ground(m_graph->up()));
    m_state.left = m_state.track;
    m_state.track = track;
    m_state.pace = {};
    m_state.fade = 0;
    if (target.isCyclic)
        m_state.home = track.space;
    m_state.way = LiveState::Way::Arriving;
    m_state.wayStart = choice.arrivalPlace;
    m_state.wayFrames = 0;
    m_state.wayEnd = choice.targetFrames;
}

void LivePlayer::movePlace(const LiveInput& input, double seconds)
{
    LiveTrack& track = m_state.track;
    if (m_state.way != LiveState::Way::Free) {
        const bool leaves = m_state.way == LiveState::Way::Leaving;
        if (leaves || m_state.wayFrames < m_state.wayEnd) {
            const SpacePoint before = track.place;
            const double share =
                m_state.wayEnd > 0 ? std::clamp(m_state.wayFrames / m_state.wayEnd, 0.0, 1.0) : 1;
            track.place = between(m_state.wayStart, leaves ? m_state.choice.leavingPlace : m_state.wayGoal,
                                  wayGone(share));
            for (std::size_t d = 0; d < before.size(); ++d)
                m_state.pace[d] = (track.place[d] - before[d]) / seconds;
            return;
        }
        m_state.way = LiveState::Way::Free;
    }
    const SpacePoint wanted =
        input.space == track.space ? wantedPlace(track.space, input.parameters) : track.place;
    const auto [least, greatest] = spaceOf(track).weights.range();
    movePlaceTowards(wanted, least, greatest, m_settings.secondsAcross, seconds, track.place, m_state.pace);
}

double LivePlayer::play(LiveTrack& track, double& seconds, double most) const
{
    const MotionSpace& space = spaceOf(track);
    const NodeWeights weights = space.weights.at(track.place);
    double done = 0;
    while (seconds > 0 && done < most) {
        const auto frame = static_cast<std::size_t>(track.phase);
        if (!space.isCyclic && frame + 1 >= space.frameCount()) {
            // It stays at its end.
            seconds = 0;
            break;
        }
        const double length = blendedSeconds(space, frame, weights);
        const double rest = static_cast<double>(frame + 1) - track.phase;
        const double part = std::min({rest, seconds / length, most - done});
        track.root = track.root * partOf(blendedStep(space, frame, weights), part);
        // Rounding may reach the next frame, too.
        const double phase = track.phase + part;
        const bool isBefore = part < rest && phase < static_cast<double>(frame + 1);
        track.phase = isBefore ? phase : static_cast<double>(space.next(frame));
        seconds = std::max(0.0, seconds - part * length);
        done += part;
    }
    return done;
}

void LivePlayer::playOut(LiveTrack& track, double seconds) const
{
    const MotionSpace& space = spaceOf(track);
    if (space.isCyclic) {
        play(track, seconds, forever);
        return;
    }
    // Stopping at the end would show as long as half of it is seen: the pose comes to rest there, and the
    // body goes on over the ground.
    constexpr double restFrames = 4;
    const double last = static_cast<double>(space.frameCount() - 1);
    const auto frame = static_cast<std::size_t>(std::clamp(track.phase, 0.0, std::max(last - 1, 0.0)));
    const NodeWeights weights = space.weights.at(track.place);
    const double part = seconds / blendedSeconds(space, frame, weights);
    track.root = track.root * partOf(blendedStep(space, frame, weights), part);
    track.phase += part * std::clamp((last - track.phase) / restFrames, 0.0, 1.0);
}

void LivePlayer::tick(const LiveInput& input)
{
    assert(input.space < m_graph->spaces.size());
    ++m_state.tick;
    if (input.space == m_state.home)
        m_state.homeParameters = input.parameters;
    if (const std::size_t wanted = wantedSpace(input); wanted != m_state.wanted) {
        m_state.wanted = wanted;
        m_state.wished = m_state.tick;
    }
    decide(input);
    const double whole = tickSeconds();
    double seconds = whole;
    movePlace(input, seconds);
    double left = whole;
    if (m_state.way == LiveState::Way::Leaving) {
        m_state.wayFrames += play(m_state.track, seconds, std::max(m_state.wayEnd - m_state.wayFrames, 0.0));
        const double last = static_cast<double>(spaceOf(m_state.track).frameCount() - 1);
        const bool hasEnded = !isCyclic(m_state.track) && m_state.track.phase >= last;
        if (m_state.wayFrames >= m_state.wayEnd || hasEnded) {
            switchOver();
            left = seconds; // the rest was played before
        }
    }
    if (m_state.fade < 1) {
        playOut(m_state.left, left);
        m_state.fade = std::min(1.0, m_state.fade + whole / m_settings.fadeSeconds);
    }
    const double played = play(m_state.track, seconds, forever);
    if (m_state.way != LiveState::Way::Free)
        m_state.wayFrames += played;
}

void LivePlayer::poseOf(const LiveTrack& track, MutablePositions out) const
{
    const MotionSpace& space = spaceOf(track);
    blendedPose(space, track.phase, space.weights.at(track.place), out);
    moveOverGround(track.root, Ground(space.up), out);
}

void LivePlayer::pose(MutablePositions out)
{
    poseOf(m_state.track, out);
    if (m_state.fade >= 1)
        return;
    poseOf(m_state.left, m_other);
    const auto weight = static_cast<float>(m_state.takenOver());
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = m_other[v] + weight * (out[v] - m_other[v]);
}

GroundMotion LivePlayer::root() const
{
    if (m_state.fade >= 1)
        return m_state.track.root;
    return m_state.left.root * partOf(m_state.left.root.inverse() * m_state.track.root, m_state.takenOver());
}

void perform(LivePlayer& player, std::span<const LiveInput> inputs,
             const std::function<void(LivePlayer&)>& use, const Progress& progress)
{
    use(player);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        player.tick(inputs[i]);
        use(player);
        progress.report(static_cast<std::int64_t>(i + 1), static_cast<std::int64_t>(inputs.size()));
    }
}

} // namespace quadrille
