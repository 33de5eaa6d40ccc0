// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/posedistance.h"
#include "tests/model/transition/plainposedistance.h"
#include "tests/model/transition/swayingtube.h"

#include <benchmark/benchmark.h>
#include <map>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// 5,320 triangles, 2,680 vertices.
const CharacterFrames& figure(std::int64_t frames)
{
    static std::map<std::int64_t, CharacterFrames> figures;
    const auto found = figures.find(frames);
    if (found != figures.end())
        return found->second;
    const MeshSequence sequence = swayingTube(tubeTopology(20, 134), 20, frames, 0.04);
    return figures.emplace(frames, CharacterFrames(std::span(&sequence, 1))).first->second;
}

void setPairs(benchmark::State& state, double pairs)
{
    state.SetItemsProcessed(
        static_cast<std::int64_t>(static_cast<double>(state.iterations()) * pairs *
                                  static_cast<double>(figure(2).triangles().size()))); // triangle pairs
}

/// Everything, meshes to table; arguments are frames and threads.
void allPairs(benchmark::State& state)
{
    const CharacterFrames& frames = figure(state.range(0));
    const auto metric = static_cast<PoseMetric>(state.range(2));
    tbb::task_arena arena(static_cast<int>(state.range(1)));
    for (auto _ : state)
        arena.execute(
            [&] { benchmark::DoNotOptimize(poseDistances(frames, {.metric = metric}).distances.data()); });
    const auto n = static_cast<double>(state.range(0));
    setPairs(state, n * (n - 1) / 2);
}
BENCHMARK(allPairs)
    ->ArgNames({"frames", "threads", "metric"})
    ->Args({200, 1, 0})
    ->Args({1000, 1, 0})
    ->Args({1000, 4, 0})
    ->Args({1000, 1, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// By some of the triangles, beside all of them.
void someTriangles(benchmark::State& state)
{
    const CharacterFrames& frames = figure(1000);
    PoseDistanceSettings settings;
    if (state.range(0) > 0)
        settings.triangles = state.range(0);
    tbb::task_arena arena(1);
    for (auto _ : state)
        arena.execute([&] { benchmark::DoNotOptimize(poseDistances(frames, settings).distances.data()); });
}
BENCHMARK(someTriangles)
    ->ArgName("triangles")
    ->Arg(0)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// Both metrics and the trace of covariances; by one pass over all pairs or by one for each.
void allTables(benchmark::State& state)
{
    const CharacterFrames& frames = figure(1000);
    const std::vector<PoseDistanceSettings> metrics{{}, {.metric = PoseMetric::Euclidean}};
    const OfCovariance trace = [](const Eigen::Matrix3d& covariance) { return covariance.trace(); };
    const bool isTogether = state.range(0) != 0;
    tbb::task_arena arena(1);
    for (auto _ : state)
        arena.execute([&] {
            if (isTogether) {
                benchmark::DoNotOptimize(posePairs(frames, metrics, trace).ofCovariances.data());
                return;
            }
            for (const PoseDistanceSettings& metric : metrics)
                benchmark::DoNotOptimize(poseDistances(frames, metric).distances.data());
            benchmark::DoNotOptimize(posePairs(frames, {}, trace).ofCovariances.data());
        });
}
BENCHMARK(allTables)->ArgName("together")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The plain reference: Kabsch and polar decompositions by SVD, double precision.
void plainPair(benchmark::State& state)
{
    const CharacterFrames& frames = figure(200);
    NodeIndex other = 0;
    for (auto _ : state) {
        other = other % 199 + 1;
        benchmark::DoNotOptimize(plainSurfaceDistance(
            frames.frame(0).positions(), frames.frame(other).positions(), frames.triangles(), 0.01));
    }
    setPairs(state, 1);
}
BENCHMARK(plainPair)->Unit(benchmark::kMillisecond);

/// One pair in double precision by the closed form.
void singlePair(benchmark::State& state)
{
    const CharacterFrames& frames = figure(200);
    NodeIndex other = 0;
    for (auto _ : state) {
        other = other % 199 + 1;
        benchmark::DoNotOptimize(surfaceDistance(frames.frame(0).positions(), frames.frame(other).positions(),
                                                 frames.triangles()));
    }
    setPairs(state, 1);
}
BENCHMARK(singlePair)->Unit(benchmark::kMillisecond);

} // namespace
