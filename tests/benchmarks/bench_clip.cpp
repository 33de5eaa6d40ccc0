// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A blended transition and a whole clip of a body of 2,702 vertices, beside plain references: every frame
// interpolated for itself, nothing prepared before nor kept behind.
#include "model/synthesis/clips/makeclip.h"
#include "tests/model/transition/bars.h"
#include "tests/model/transition/plaininterpolation.h"

#include <benchmark/benchmark.h>
#include <cmath>

using namespace quadrille;

namespace {

/// Takes of 120 frames of a bar of 2,702 vertices and 5,400 triangles that bends and goes its way.
std::vector<MeshSequence> bendingTakes(int count)
{
    const Bar bar = makeBar(75, 9, 2.0F, 0.4F);
    const auto vertexCount = static_cast<std::uint32_t>(bar.positions.size());
    std::vector<MeshSequence> takes;
    for (int take = 0; take < count; ++take) {
        std::vector<Vec3f> positions;
        for (int f = 0; f < 120; ++f) {
            const double time = 0.05 * f + take;
            for (Vec3f position : bent(shaken(bar.positions, 0.003, 1), 2.0, 0.3 + std::sin(time))) {
                position.z() += 0.02F * static_cast<float>(f);
                positions.push_back(position);
            }
        }
        takes.push_back(makeSequence("take", bar.topology,
                                     std::make_shared<MemoryFrames>(std::move(positions), vertexCount), 25));
    }
    return takes;
}

/// Two takes, and a walk of 12 transitions of 25 frames between them.
struct Subject
{
    CharacterFrames character{bendingTakes(2)};
    RootPoses roots = rootPoses(character, UpAxis::Y);
    Walk walk;
    std::vector<Transition> transitions;
    ClipPlan plan;

    Subject()
    {
        for (int k = 0; k <= 12; ++k) {
            const NodeIndex first = 120 * (k % 2) + 40 + k;
            walk.spans.push_back({first, first + 20});
        }
        for (std::size_t t = 0; t < walk.transitionCount(); ++t)
            transitions.push_back(transitionOf(walk.transition(t)));
        plan = planClip(roots, walk, transitions);
    }
    static Transition transitionOf(FramePair frames)
    {
        Transition transition{.frames = frames, .sourceWindow = 25, .destinationWindow = 25, .path = {}};
        for (int t = 0; t < 25; ++t)
            transition.path.push_back({frames.source + t, frames.destination - 24 + t});
        return transition;
    }
};

const Subject& subject()
{
    static const Subject only;
    return only;
}

void countFrames(benchmark::State& state, std::int64_t frames)
{
    state.counters["per frame"] =
        benchmark::Counter(static_cast<double>(state.iterations() * frames),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The frames of a plan one by one, by the reference of pose interpolation.
void showPlainly(const ClipPlan& plan)
{
    const Subject& s = subject();
    const Ground ground(UpAxis::Y);
    const auto placed = [&](NodeIndex node, const GroundMotion& motion) {
        std::vector<Vec3f> positions;
        const Frame frame = s.character.frame(node);
        for (const Vec3f& position : frame.positions())
            positions.push_back(motion(position.cast<double>(), ground).cast<float>());
        return positions;
    };
    for (const PlannedFrame& frame : plan.frames) {
        const std::vector<Vec3f> source = placed(frame.origin.source, frame.placeSource);
        if (frame.isCaptured())
            continue;
        benchmark::DoNotOptimize(interpolatePlainly(*s.character.sequences().front().topology, source,
                                                    placed(frame.origin.destination, frame.placeDestination),
                                                    frame.lambda, InterpolationMethod::Poisson));
    }
}

ClipPlan planOfOne()
{
    const Subject& s = subject();
    const FramePair frames = s.transitions.front().frames;
    return planClip(s.roots, {{{frames.source, frames.source}, {frames.destination, frames.destination}}},
                    std::span(s.transitions).first(1));
}

void blendOne(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            blendTransition(s.character, s.roots, s.transitions.front()).positions.data());
    countFrames(state, s.transitions.front().length());
}

void blendOnePlainly(benchmark::State& state)
{
    const ClipPlan plan = planOfOne();
    for (auto _ : state)
        showPlainly(plan);
    countFrames(state, plan.frameCount());
}

void planWhole(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(planClip(s.roots, s.walk, s.transitions).frames.data());
    countFrames(state, s.plan.frameCount());
}

void makeWhole(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(makeClip(s.character, s.plan).positions.data());
    countFrames(state, s.plan.frameCount());
}

/// Poses between captured frames: nothing prepared serves two frames.
void makeWholeGently(benchmark::State& state)
{
    const Subject& s = subject();
    std::vector<Transition> warped = s.transitions;
    for (Transition& transition : warped) {
        // Stops the source for a frame, so that moments fall between frames.
        transition.path.insert(transition.path.begin() + 12, transition.path[12]);
        for (std::size_t t = 0; t <= 12; ++t)
            --transition.path[t].destination;
        ++transition.destinationWindow;
    }
    const ClipPlan plan =
        planClip(s.roots, s.walk, warped, {.start = {}, .blend = {.timing = BlendTiming::Smooth}});
    for (auto _ : state)
        benchmark::DoNotOptimize(makeClip(s.character, plan).positions.data());
    countFrames(state, plan.frameCount());
}

void makeWholePlainly(benchmark::State& state)
{
    for (auto _ : state)
        showPlainly(subject().plan);
    countFrames(state, subject().plan.frameCount());
}

/// A blended frame on demand, as for scrubbing.
void showOneFrame(benchmark::State& state)
{
    const Subject& s = subject();
    const ClipPlayer player(s.character, s.plan);
    const std::int64_t frame = s.plan.junctions.front().first + 12;
    for (auto _ : state)
        benchmark::DoNotOptimize(player.frame(frame).data());
}

} // namespace

BENCHMARK(blendOne)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(blendOnePlainly)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(planWhole)->Unit(benchmark::kMicrosecond);
BENCHMARK(makeWhole)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(makeWholeGently)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(makeWholePlainly)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(showOneFrame)->Unit(benchmark::kMillisecond)->UseRealTime();
