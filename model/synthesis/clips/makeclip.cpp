// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/makeclip.h"

#include "model/synthesis/clips/clipsize.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <map>
#include <tbb/parallel_for.h>
#include <utility>

namespace quadrille {

namespace {

/// Blended frames whose poses are in memory at the same time.
constexpr std::size_t chunkSize = 128;

void move(Positions positions, const GroundMotion& motion, const Ground& ground, MutablePositions out)
{
    std::ranges::transform(positions, out.begin(),
                           [placed = motion.inSpace(ground)](const Vec3f& position) -> Vec3f {
                               return placed(position.cast<double>()).cast<float>();
                           });
}

/// The pose of a moment. Between captured frames vertices go straight.
Frame poseAt(const CharacterFrames& character, const FrameTime& time)
{
    Frame here = character.frame(time.frame);
    if (time.part == 0)
        return here;
    const Frame next = character.frame(time.next());
    const auto positions = std::make_shared<std::vector<Vec3f>>(here.positions().size());
    std::ranges::transform(here.positions(), next.positions(), positions->begin(),
                           [part = static_cast<float>(time.part)](const Vec3f& a, const Vec3f& b) -> Vec3f {
                               return a + part * (b - a);
                           });
    return {*positions, positions};
}

} // namespace

ClipPlayer::ClipPlayer(CharacterFrames character, ClipPlan plan, InterpolationMethod method)
    : m_character(std::move(character))
    , m_plan(std::move(plan))
    , m_method(method)
    , m_system(std::make_shared<const PoissonSystem>(m_character.sequences().front().topology))
{
}

std::vector<Vec3f> ClipPlayer::frame(std::int64_t frame) const
{
    const PlannedFrame& planned = m_plan.frames[static_cast<std::size_t>(frame)];
    const Ground ground(m_plan.up);
    std::vector<Vec3f> out(m_character.vertexCount());
    const Frame source = poseAt(m_character, planned.times.source);
    if (planned.isSingle()) {
        move(source.positions(), planned.placeSource, ground, out);
        return out;
    }
    const Frame destination = poseAt(m_character, planned.times.destination);
    const PoseInterpolation between(std::make_shared<const PreparedPose>(m_system, source.positions()),
                                    std::make_shared<const PreparedPose>(m_system, destination.positions()));
    between.at(planned.lambda, out, m_method, planned.placeSource.inSpace(ground),
               planned.placeDestination.inSpace(ground));
    return out;
}

void ClipPlayer::blendInto(Clip& clip, std::span<const std::int64_t> frames, const Progress& progress) const
{
    std::map<std::pair<NodeIndex, double>, int> indices;
    std::vector<Frame> loaded;
    std::vector<Positions> positions;
    const auto indexOf = [&](const FrameTime& time) {
        const auto [found, isNew] =
            indices.try_emplace({time.frame, time.part}, static_cast<int>(loaded.size()));
        if (isNew) {
            loaded.push_back(poseAt(m_character, time));
            positions.push_back(loaded.back().positions());
        }
        return found->second;
    };
    const Ground ground(m_plan.up);
    std::vector<BlendStep> steps;
    for (const std::int64_t frame : frames) {
        const PlannedFrame& planned = m_plan.frames[static_cast<std::size_t>(frame)];
        steps.push_back({.source = indexOf(planned.times.source),
                         .target = indexOf(planned.times.destination),
                         .lambda = planned.lambda,
                         .placeSource = planned.placeSource.inSpace(ground),
                         .placeTarget = planned.placeDestination.inSpace(ground)});
    }
    const std::vector<Vec3f> blended = blendPoses(m_system, positions, positions, steps, m_method, progress);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::ranges::copy(
            Positions(blended).subspan(i * m_character.vertexCount(), m_character.vertexCount()),
            clip.frame(frames[i]).begin());
    }
}

Clip ClipPlayer::clip(const Progress& progress) const
{
    const std::size_t count = m_plan.frames.size();
    checkClipSize(static_cast<std::int64_t>(count), m_character.vertexCount());
    Clip clip{.topology = m_character.sequences().front().topology,
              .fps = m_character.sequences().front().fps,
              .positions = std::vector<Vec3f>(count * m_character.vertexCount()),
              .origins = {}};
    std::vector<std::int64_t> captured;
    std::vector<std::int64_t> blended;
    for (const PlannedFrame& planned : m_plan.frames) {
        (planned.isSingle() ? captured : blended).push_back(clip.frameCount());
        clip.origins.push_back(planned.origin);
    }
    const Ground ground(m_plan.up);
    const double share = blended.empty() ? 1 : 0.1;
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, captured.size(), [&](std::size_t i) {
        const PlannedFrame& planned = m_plan.frames[static_cast<std::size_t>(captured[i])];
        move(m_character.frame(planned.times.source.frame).positions(), planned.placeSource, ground,
             clip.frame(captured[i]));
        progress.part(0, share).report(++done, static_cast<std::int64_t>(captured.size()));
    });
    const auto shareAt = [&](std::size_t frame) {
        return share + (1 - share) * static_cast<double>(frame) / static_cast<double>(blended.size());
    };
    for (std::size_t from = 0; from < blended.size(); from += chunkSize) {
        const std::size_t size = std::min(chunkSize, blended.size() - from);
        blendInto(clip, std::span(blended).subspan(from, size),
                  progress.part(shareAt(from), shareAt(from + size)));
    }
    progress.report(1.0);
    return clip;
}

Clip makeClip(const CharacterFrames& character, const ClipPlan& plan, InterpolationMethod method,
              const Progress& progress)
{
    return ClipPlayer(character, plan, method).clip(progress);
}

Clip blendTransition(const CharacterFrames& character, const RootPoses& roots, const Transition& transition,
                     const PlanOptions& options, InterpolationMethod method, const Progress& progress)
{
    const FramePair& frames = transition.frames;
    const Walk walk{{{frames.source, frames.source}, {frames.destination, frames.destination}}};
    return makeClip(character, planClip(roots, walk, std::span(&transition, 1), options), method, progress);
}

} // namespace quadrille
