// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/loop.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/synthesis/clips/clipsize.h"
#include "model/synthesis/clips/frameprovenance.h"
#include "model/synthesis/clips/makeclip.h"
#include "model/synthesis/clips/transitionmotion.h"
#include "model/synthesis/finishing/ownperiod.h"
#include "model/transition/posedistance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace quadrille {

namespace {

/// The frames of a clip near its two ends that a closure may use: 0 … early, and late … the last.
struct Ends
{
    NodeIndex early = 0;
    NodeIndex late = 0;
    NodeIndex last = 0;

    // As a character of two sequences: the beginning, then the end.
    NodeIndex nodeOfLate(NodeIndex frame) const { return early + 1 + frame - late; }
    NodeIndex frameOfLate(NodeIndex node) const { return node - early - 1 + late; }
};

NodeIndex framesOf(const std::optional<Seconds>& cut, const Clip& clip, int shortest)
{
    const auto count = static_cast<double>(clip.frameCount());
    if (!cut)
        return static_cast<NodeIndex>(std::max(count / 3, shortest - 1.0));
    if (!(cut->value >= 0) || !std::isfinite(cut->value))
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("A loop can only cut a time that is not negative")},
                      {"remedy", QUADRILLE_MESSAGE("Give a number of seconds, 0 or more.")}}});
    const double frames = std::floor(cut->value * clip.fps + 1e-6);
    if (frames < shortest - 1)
        throw Error(ErrorCode::LoopCutTooShort, {{},
                                                 {},
                                                 {{"given", std::to_string(static_cast<int>(frames))},
                                                  {"needed", std::to_string(shortest - 1)}}});
    return static_cast<NodeIndex>(std::min(frames, count - 1));
}

Ends endsOf(const Clip& clip, const LoopSettings& settings, const TransitionSettings& transitions,
            const FrameRange& asked)
{
    const int shortest = transitions.shortest();
    if (clip.frameCount() < 2 * std::int64_t{shortest})
        throw Error(ErrorCode::LoopTooShort, {{},
                                              {},
                                              {{"frames", std::to_string(clip.frameCount())},
                                               {"needed", std::to_string(2 * shortest)}}});
    const auto last = static_cast<NodeIndex>(clip.frameCount() - 1);
    Ends ends{.early = framesOf(settings.cutStart, clip, shortest),
              .late = last - framesOf(settings.cutEnd, clip, shortest),
              .last = last};
    if (asked.count() > 0) {
        const auto from = static_cast<NodeIndex>(asked.first.value);
        const auto to = static_cast<NodeIndex>(asked.last.value);
        ends.early = std::min(ends.early, std::max(from, shortest - 1));
        ends.late = std::max(ends.late, std::min(to, last - (shortest - 1)));
    }
    return ends;
}

/// The least pace along a path, 1 where both windows go on at every step and 0 where the pose stands still:
/// what the blend shows of the steps of the two windows.
double leastPace(const Transition& transition)
{
    double least = 1;
    const auto& path = transition.path;
    for (std::size_t t = 1; t < path.size(); ++t) {
        const double lambda = (static_cast<double>(t) - 0.5) / (static_cast<double>(path.size()) - 1);
        const double pace = (1 - lambda) * (path[t].source - path[t - 1].source) +
                            lambda * (path[t].destination - path[t - 1].destination);
        least = std::min(least, pace);
    }
    return least;
}

/// The best closure in nodes; nothing where there is none.
std::optional<Transition> bestClosure(const TransitionTable& table, const WarpPaths& paths, const Ends& ends)
{
    struct Candidate
    {
        Transition transition; ///< in nodes
        double cost;
        int period; ///< of the cycle, frames
    };
    std::vector<Candidate> candidates;
    const auto add = [&](std::optional<Transition> transition) {
        if (!transition)
            return;
        // Poses that differ by rounding only are at some 1e-5 from each other.
        constexpr double rounding = 1e-4;
        const double mean = static_cast<double>(transition->cost) / transition->length() + rounding;
        const auto [source, destination] = transition->frames;
        const int period = ends.frameOfLate(source) - destination + transition->length() - 1;
        // A pose that stands still for a moment shows more than one that is twice as far.
        const double cost = mean * (2 - leastPace(*transition));
        candidates.push_back({std::move(*transition), cost, period});
    };
    for (NodeIndex frame = ends.late; frame <= ends.last; ++frame) {
        for (NodeIndex column = 0; column <= std::min(ends.early, frame - 1); ++column) {
            const FramePair nodes{ends.nodeOfLate(frame), column};
            add(paths.of(table, nodes));
            add(paths.linear(nodes));
        }
    }
    if (candidates.empty())
        return {};
    const double least = std::ranges::min(candidates, {}, &Candidate::cost).cost;
    std::erase_if(candidates, [least](const Candidate& c) { return c.cost > 1.05 * least; });
    return std::move(std::ranges::max_element(candidates, {}, &Candidate::period)->transition);
}

[[noreturn]] void refuseWithoutPath(const Ends& ends, int shortest)
{
    throw Error(ErrorCode::NoTransition, {{},
                                          {},
                                          {{"source", std::to_string(ends.last)},
                                           {"destination", "0"},
                                           {"needed", std::to_string(shortest)},
                                           {"after", std::to_string(ends.last - ends.late + 1)},
                                           {"before", std::to_string(ends.early + 1)}}});
}

/// A closure and the frames of two clips that it takes part of, as a character of two sequences: those of the
/// second clip, up to the frame that the closure leads to, then those of the first, from the one it leaves.
class Closing
{
public:
    Closing(const Clip& from, const Clip& to, const Transition& closure)
        : m_from(from), m_to(to), m_transition(closure)
    {
        const auto [source, destination] = closure.frames;
        NodeIndex latest = source;
        m_earliest = destination;
        for (const FramePair& cell : closure.path) {
            latest = std::max(latest, cell.source);
            m_earliest = std::min(m_earliest, cell.destination);
        }
        m_source = source;
        m_count = destination - m_earliest + 1;
        m_character.emplace(std::vector{partOf(to, m_earliest, destination), partOf(from, source, latest)});
        m_transition.frames = nodesOf(closure.frames);
        for (FramePair& cell : m_transition.path)
            cell = nodesOf(cell);
    }

    const CharacterFrames& character() const { return *m_character; }
    const Transition& transition() const { return m_transition; } ///< in nodes
    const FrameProvenance& originOf(NodeIndex node) const
    {
        const NodeIndex frame = node < m_count ? m_earliest + node : m_source + node - m_count;
        return (node < m_count ? m_to : m_from).origins[static_cast<std::size_t>(frame)];
    }

private:
    FramePair nodesOf(const FramePair& frames) const
    {
        return {m_count + frames.source - m_source, frames.destination - m_earliest};
    }

    const Clip& m_from;
    const Clip& m_to;
    Transition m_transition;
    std::optional<CharacterFrames> m_character;
    NodeIndex m_source = 0;   ///< frame that the first node of the first clip shows
    NodeIndex m_earliest = 0; ///< frame that the first node of the second clip shows
    NodeIndex m_count = 0;    ///< nodes of the second clip
};

} // namespace

ClosingBlend closingBlend(const Clip& from, const Clip& to, const Transition& closure,
                          const BlendMethod& method, const Progress& progress)
{
    const Closing closing(from, to, closure);
    const RootPoses roots = rootPoses(closing.character(), method.up, progress.part(0, 0.3));
    ClosingBlend result{.travel = transitionMotion(roots, closing.transition(), method.blend).exit(),
                        .between = blendTransition(closing.character(), roots, closing.transition(),
                                                   {.start = {}, .blend = method.blend}, method.interpolation,
                                                   progress.part(0.3, 1))};
    // The first and the last are frames of the clips.
    Clip& between = result.between;
    const auto vertices = static_cast<std::ptrdiff_t>(from.topology->vertexCount());
    between.positions.erase(between.positions.end() - vertices, between.positions.end());
    between.positions.erase(between.positions.begin(), between.positions.begin() + vertices);
    between.origins.pop_back();
    between.origins.erase(between.origins.begin());
    for (FrameProvenance& origin : between.origins)
        origin = originBetween(closing.originOf(origin.source), closing.originOf(origin.destination),
                               origin.lambda);
    return result;
}

Loop seamlessLoop(const Clip& clip, const LoopSettings& settings, const BlendMethod& method,
                  const FrameRange& asked, const Progress& progress)
{
    progress.report(0.0);
    TransitionSettings transitions = method.transitions;
    transitions.fps = clip.fps;
    // Least sums have short windows, which hardly repeat frames; least means let poses stand still.
    transitions.cost = TransitionCost::Sum;
    checkSettings(transitions);
    Loop loop{.cycle = {.topology = clip.topology, .fps = clip.fps, .positions = {}, .origins = {}},
              .travel = {},
              .closure = {}};
    const auto takeFrames = [&](std::int64_t first, std::int64_t last) {
        const auto vertices = static_cast<std::ptrdiff_t>(clip.topology->vertexCount());
        loop.cycle.positions.assign(clip.positions.begin() + first * vertices,
                                    clip.positions.begin() + (last + 1) * vertices);
        loop.cycle.origins.assign(clip.origins.begin() + first, clip.origins.begin() + last + 1);
    };
    if (const auto own = ownPeriod(clip, method.up, method.pose); own && asked.last.value < own->frames) {
        takeFrames(0, own->frames - 1);
        loop.travel = own->travel;
        loop.closure.frames = {static_cast<NodeIndex>(own->frames - 1), 0};
        loop.closure.cost = own->distance;
        return settings.inPlace ? inPlace(std::move(loop), method.up) : loop;
    }
    const Ends ends = endsOf(clip, settings, transitions, asked);
    const CharacterFrames character(
        std::vector{partOf(clip, 0, ends.early), partOf(clip, ends.late, ends.last)});
    const PoseDistances distances = poseDistances(character, method.pose, progress.part(0, 0.4));
    const TransitionTable table =
        transitionTable(distances.distances, distances.layout, transitions, progress.part(0.4, 0.6));
    auto found = bestClosure(table, WarpPaths(distances.distances, distances.layout, transitions), ends);
    if (!found)
        refuseWithoutPath(ends, transitions.shortest());
    Transition& closure = loop.closure = std::move(*found);
    closure.frames.source = ends.frameOfLate(closure.frames.source);
    for (FramePair& cell : closure.path)
        cell.source = ends.frameOfLate(cell.source);
    const ClosingBlend closing = closingBlend(clip, clip, closure, method, progress.part(0.6, 1));
    loop.travel = closing.travel;
    takeFrames(closure.frames.destination, closure.frames.source);
    append(closing.between, loop.cycle);
    if (settings.inPlace)
        loop = inPlace(std::move(loop), method.up);
    progress.report(1.0);
    return loop;
}

Loop inPlace(Loop loop, UpAxis up)
{
    const std::int64_t count = loop.cycle.frameCount();
    for (std::int64_t f = 1; f < count; ++f) {
        const double share = static_cast<double>(f) / static_cast<double>(count);
        moveFrame(loop.cycle.frame(f), partOf(loop.travel, share).inverse(), Ground(up));
    }
    loop.travel = {};
    return loop;
}

void checkPlayings(int playings)
{
    if (playings < 1 || playings > 10000)
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("A loop can be repeated 1 to 10,000 times")},
                      {"remedy", QUADRILLE_MESSAGE("Give a number of repeats in between.")}}});
}

Clip repeated(const Loop& loop, int cycles, UpAxis up)
{
    checkPlayings(cycles);
    const std::size_t frames = loop.cycle.origins.size();
    const std::size_t positions = loop.cycle.positions.size();
    Clip clip = loop.cycle;
    checkClipSize(static_cast<std::int64_t>(frames) * cycles, positions / std::max<std::size_t>(frames, 1));
    clip.positions.resize(positions * static_cast<std::size_t>(cycles));
    clip.origins.resize(frames * static_cast<std::size_t>(cycles));
    for (int k = 1; k < cycles; ++k) {
        const std::size_t place = static_cast<std::size_t>(k) * positions;
        std::copy_n(loop.cycle.origins.begin(), frames,
                    clip.origins.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k) * frames));
        std::copy_n(loop.cycle.positions.begin(), positions,
                    clip.positions.begin() + static_cast<std::ptrdiff_t>(place));
        moveFrame(MutablePositions(clip.positions).subspan(place, positions), repeatedTravel(loop.travel, k),
                  Ground(up));
    }
    return clip;
}

Clip closedCycle(const Loop& loop, UpAxis up)
{
    Clip closed = loop.cycle;
    closed.origins.push_back(loop.cycle.origins.front());
    closed.positions.insert(closed.positions.end(), loop.cycle.frame(0).begin(), loop.cycle.frame(0).end());
    moveFrame(closed.frame(loop.cycle.frameCount()), loop.travel, Ground(up));
    return closed;
}

GroundMotion repeatedTravel(const GroundMotion& travel, int cycles)
{
    GroundMotion motion;
    for (int k = 0; k < cycles; ++k)
        motion = travel * motion;
    return motion;
}

void append(const Clip& clip, Clip& to)
{
    to.positions.insert(to.positions.end(), clip.positions.begin(), clip.positions.end());
    to.origins.insert(to.origins.end(), clip.origins.begin(), clip.origins.end());
}

void moveFrame(MutablePositions positions, const GroundMotion& motion, const Ground& ground)
{
    if (motion == GroundMotion())
        return;
    const RigidMotion inSpace = motion.inSpace(ground);
    const Eigen::Matrix3d rotation = inSpace.rotation.toRotationMatrix();
    for (Vec3f& p : positions)
        p = (rotation * p.cast<double>() + inSpace.translation).cast<float>();
}

} // namespace quadrille
