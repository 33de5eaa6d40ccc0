// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/loopplayings.h"

#include "model/synthesis/clips/clipsize.h"
#include "model/synthesis/finishing/variedplan.h"
#include "model/transition/poseinterpolation.h"

#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace quadrille {

namespace {

/// Some frames of a clip, both ends included.
Clip framesOf(const Clip& clip, std::int64_t first, std::int64_t last)
{
    const auto vertices = static_cast<std::ptrdiff_t>(clip.topology->vertexCount());
    return {.topology = clip.topology,
            .fps = clip.fps,
            .positions = {clip.positions.begin() + first * vertices,
                          clip.positions.begin() + (last + 1) * vertices},
            .origins = {clip.origins.begin() + first, clip.origins.begin() + last + 1}};
}

/// A clip that comes from another one and goes back to it.
Clip easedFrom(const Clip& usual, Clip clip, double frames, InterpolationMethod method,
               const Progress& progress)
{
    const std::vector<double> weights =
        easedWeights(static_cast<std::size_t>(clip.frameCount()), true, true, frames);
    std::vector<Positions> sources;
    std::vector<Positions> targets;
    std::vector<BlendStep> steps;
    std::vector<std::int64_t> eased;
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const double weight = weights[static_cast<std::size_t>(f)];
        if (weight == 1)
            continue;
        const int step = static_cast<int>(steps.size());
        sources.push_back(usual.frame(f));
        targets.push_back(std::as_const(clip).frame(f));
        steps.push_back(
            {.source = step, .target = step, .lambda = weight, .placeSource = {}, .placeTarget = {}});
        eased.push_back(f);
    }
    const std::vector<Vec3f> blended = blendPoses(std::make_shared<const PoissonSystem>(clip.topology),
                                                  sources, targets, steps, method, progress);
    const std::size_t vertices = clip.topology->vertexCount();
    for (std::size_t i = 0; i < eased.size(); ++i)
        std::ranges::copy(Positions(blended).subspan(i * vertices, vertices), clip.frame(eased[i]).begin());
    return clip;
}

/// The frames of a playing, and how the next one lies behind it.
struct Playing
{
    Clip frames;
    GroundMotion travel;
};

/// Makes playings; those of the same clips once.
class Player
{
public:
    Player(const Loop& loop, const BlendMethod& method, double easeSeconds, std::shared_ptr<const Clip> usual)
        : m_loop(loop), m_method(method), m_easeSeconds(easeSeconds), m_usual(std::move(usual))
    {
    }

    const Playing& playing(const std::shared_ptr<const Clip>& clip, const std::shared_ptr<const Clip>& next,
                           const Progress& progress)
    {
        const auto [found, isNew] = m_made.try_emplace({clip, next});
        if (isNew)
            found->second = make(clip, next, progress);
        return found->second;
    }

private:
    Playing make(const std::shared_ptr<const Clip>& clip, const std::shared_ptr<const Clip>& next,
                 const Progress& progress) const
    {
        const auto [source, destination] = m_loop.closure.frames;
        Playing playing{.frames = framesOf(*clip, destination, source), .travel = m_loop.travel};
        if (m_loop.closure.path.empty()) {
            if (clip != m_usual)
                playing.frames = easedFrom(m_loop.cycle, std::move(playing.frames), m_easeSeconds * clip->fps,
                                           m_method.interpolation, progress);
            return playing;
        }
        const ClosingBlend closing = closingBlend(*clip, *next, m_loop.closure, m_method, progress);
        playing.travel = closing.travel;
        append(closing.between, playing.frames);
        return playing;
    }

    const Loop& m_loop;
    const BlendMethod& m_method;
    double m_easeSeconds;
    std::shared_ptr<const Clip> m_usual;
    std::map<std::pair<std::shared_ptr<const Clip>, std::shared_ptr<const Clip>>, Playing> m_made;
};

} // namespace

LoopPlayings playedAs(const Loop& loop, int playings, const PlayingClip& clipOf, const BlendMethod& method,
                      double easeSeconds, const Progress& progress)
{
    checkPlayings(playings);
    checkClipSize(loop.cycle.frameCount() * playings, loop.cycle.topology->vertexCount());
    const std::shared_ptr<const Clip> first = clipOf(0, Progress(progress.token()));
    LoopPlayings result{.loop = {.cycle = {.topology = loop.cycle.topology,
                                           .fps = loop.cycle.fps,
                                           .positions = {},
                                           .origins = {}},
                                 .travel = {},
                                 .closure = loop.closure},
                        .travels = {}};
    Player player(loop, method, easeSeconds, first);
    std::shared_ptr<const Clip> clip = first;
    Loop& whole = result.loop;
    for (int k = 0; k < playings; ++k) {
        const auto share = [&](int playing) { return static_cast<double>(playing) / playings; };
        const Progress part = progress.part(share(k), share(k + 1));
        part.report(0.0);
        const std::shared_ptr<const Clip> next = k + 1 < playings ? clipOf(k + 1, part.part(0, 0.7)) : first;
        const Playing& playing = player.playing(clip, next, part.part(0.7, 1));
        assert(playing.frames.frameCount() == loop.cycle.frameCount());
        const std::size_t place = whole.cycle.positions.size();
        append(playing.frames, whole.cycle);
        moveFrame(MutablePositions(whole.cycle.positions).subspan(place), whole.travel, Ground(method.up));
        whole.travel = whole.travel * playing.travel;
        result.travels.push_back(playing.travel);
        clip = next;
    }
    return result;
}

LoopPlayings inPlace(LoopPlayings playings, UpAxis up)
{
    Clip& cycle = playings.loop.cycle;
    const std::int64_t count = playings.framesOfEach();
    GroundMotion before;
    std::int64_t frame = 0;
    for (GroundMotion& travel : playings.travels) {
        for (std::int64_t f = 0; f < count; ++f, ++frame) {
            const double share = static_cast<double>(f) / static_cast<double>(count);
            moveFrame(cycle.frame(frame), (before * partOf(travel, share)).inverse(), Ground(up));
        }
        before = before * travel;
        travel = {};
    }
    playings.loop.travel = {};
    return playings;
}

} // namespace quadrille
