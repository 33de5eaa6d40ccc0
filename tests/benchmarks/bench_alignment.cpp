// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/alignment.h"
#include "model/variation/preblend.h"
#include "tests/model/transition/plaininterpolation.h"
#include "tests/model/transition/swayingtube.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <limits>
#include <random>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// 5,320 triangles, 2,680 vertices, as many as a captured figure.
std::vector<TrainingTake> takes(std::int64_t count, std::int64_t frames)
{
    const auto topology = tubeTopology(20, 134);
    std::vector<TrainingTake> result;
    for (std::int64_t t = 0; t < count; ++t)
        result.push_back({swayingTube(topology, 20, frames + 3 * t, 0.03), {}});
    return result;
}

/// Everything: contacts, distances, warps, poses on the template. Arguments are takes, frames and threads.
void align(benchmark::State& state)
{
    const std::vector<TrainingTake> training = takes(state.range(0), state.range(1));
    tbb::task_arena arena(static_cast<int>(state.range(2)));
    for (auto _ : state)
        arena.execute([&] { benchmark::DoNotOptimize(alignTakes(training, 0).takes.data()); });
}
BENCHMARK(align)
    ->ArgNames({"takes", "frames", "threads"})
    ->Args({5, 40, 1})
    ->Args({5, 40, 4})
    ->Args({5, 200, 4})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

Table<float> randomCosts(Eigen::Index size)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> values(0, 1);
    Table<float> costs(size, size);
    for (float& cost : costs.reshaped())
        cost = values(random);
    return costs;
}

void warp(benchmark::State& state)
{
    const Table<float> costs = randomCosts(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(warpWhole(costs, {.longestRun = static_cast<int>(state.range(1))}).cost);
}
BENCHMARK(warp)->ArgNames({"frames", "run"})->Args({200, 0})->Args({200, 3})->Unit(benchmark::kMicrosecond);

/// The textbook's table of sums, without a limit of the slope and without the path.
void plainWarp(benchmark::State& state)
{
    const Table<float> costs = randomCosts(state.range(0));
    const auto size = static_cast<std::size_t>(state.range(0));
    for (auto _ : state) {
        std::vector<std::vector<double>> sums(
            size + 1, std::vector<double>(size + 1, std::numeric_limits<double>::infinity()));
        sums[0][0] = 0;
        for (std::size_t r = 0; r < size; ++r) {
            for (std::size_t c = 0; c < size; ++c)
                sums[r + 1][c + 1] =
                    std::min({sums[r][c], sums[r][c + 1], sums[r + 1][c]}) +
                    double{costs(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c))};
        }
        benchmark::DoNotOptimize(sums[size][size]);
    }
}
BENCHMARK(plainWarp)->ArgName("frames")->Arg(200)->Unit(benchmark::kMicrosecond);

/// A pre-blend of 40 frames; the argument is the number of threads.
void preBlend(benchmark::State& state)
{
    const Alignment alignment = alignTakes(takes(2, 40), 0);
    const auto system = std::make_shared<PoissonSystem>(takes(1, 4).front().sequence.topology);
    tbb::task_arena arena(static_cast<int>(state.range(0)));
    for (auto _ : state)
        arena.execute([&] {
            benchmark::DoNotOptimize(
                blendedTake(system, alignment.takes[0], alignment.takes[1], 0.5, "blend").poses.data());
        });
    state.SetItemsProcessed(state.iterations() * 40);
}
BENCHMARK(preBlend)->ArgName("threads")->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The plain reference for a single frame of it.
void plainPreBlendFrame(benchmark::State& state)
{
    const std::vector<TrainingTake> training = takes(2, 4);
    const Frame a = training[0].sequence.frame(FrameIndex(0));
    const Frame b = training[1].sequence.frame(FrameIndex(3));
    for (auto _ : state)
        benchmark::DoNotOptimize(interpolatePlainly(*training[0].sequence.topology, a.positions(),
                                                    b.positions(), 0.5, InterpolationMethod::Poisson)
                                     .data());
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(plainPreBlendFrame)->Unit(benchmark::kMillisecond);

} // namespace
