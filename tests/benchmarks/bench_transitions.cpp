// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Transitions between all pairs of frames at 25 fps (windows of 9 to 50 frames), on one core, beside the
// plain computation: every pair, every pair of windows, a dynamic programme of its own. The plain one does
// some pairs and compares cost, length and windows with the table; "items_per_second" are pairs, so that
// their ratio is the gain.
#include "model/transition/transitiontable.h"
#include "model/transition/warppath.h"
#include "tests/model/transition/plainwarppath.h"
#include "tests/model/transition/transitiontables.h"
#include "tests/model/transition/warpreference.h"

#include <array>
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

using namespace quadrille;

namespace {

enum Kind : std::int64_t
{
    Noise,
    Walk,
};

constexpr std::int64_t sequenceFrames = 250;

struct Input
{
    Table<float> distances;
    FrameLayout layout;
};

Input inputOf(std::int64_t kind, int frames)
{
    const std::vector<std::int64_t> counts(static_cast<std::size_t>(frames / sequenceFrames), sequenceFrames);
    return {.distances = kind == Noise ? randomDistances(frames, 1) : walkingDistances(frames, 1),
            .layout = FrameLayout(counts)};
}

TransitionTable onThreads(int threads, const Input& input, const TransitionSettings& settings)
{
    tbb::task_arena arena(threads);
    return arena.execute([&] { return transitionTable(input.distances, input.layout, settings); });
}

TransitionSettings settingsOf(std::int64_t cost)
{
    TransitionSettings settings;
    settings.cost = cost == 0 ? TransitionCost::Sum : TransitionCost::Mean;
    return settings;
}

void allPairs(benchmark::State& state)
{
    const auto frames = static_cast<int>(state.range(2));
    const Input input = inputOf(state.range(0), frames);
    const TransitionSettings settings = settingsOf(state.range(1));
    for (auto _ : state)
        benchmark::DoNotOptimize(onThreads(static_cast<int>(state.range(3)), input, settings));
    state.SetItemsProcessed(state.iterations() * frames * frames);
}

void plainPairs(benchmark::State& state)
{
    constexpr int frames = 1000;
    const Input input = inputOf(state.range(0), frames);
    const TransitionSettings settings = settingsOf(state.range(1));
    const TransitionTable table = onThreads(4, input, settings);
    WarpReference reference(input.distances, input.layout, settings);
    // Pairs with room for all windows, spread over the table.
    constexpr std::array<std::array<NodeIndex, 2>, 4> pairs{{{10, 990}, {333, 95}, {520, 440}, {801, 702}}};
    for (auto _ : state) {
        for (const auto& [i, j] : pairs) {
            const std::optional<WarpReference::Best> best = reference.find(i, j);
            const bool mean = settings.cost == TransitionCost::Mean;
            if (!best ||
                table.cost(i, j) != static_cast<float>(mean ? best->sum / best->length : best->sum) ||
                table.length(i, j) != best->length || table.sourceWindow(i, j) != best->sourceWindow ||
                table.destinationWindow(i, j) != best->destinationWindow)
                state.SkipWithError("the table differs from the plain computation");
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs.size()));
}

constexpr int pathWindow = 40;

/// The path of a transition whose windows are known, as for each edge of a graph.
void knownPath(benchmark::State& state)
{
    const Input input = inputOf(Walk, 500);
    const WarpPaths paths(input.distances, input.layout, settingsOf(0));
    NodeIndex source = 0;
    for (auto _ : state) {
        source = (source + 1) % 200;
        benchmark::DoNotOptimize(
            paths.between({.source = source, .destination = 400}, pathWindow, pathWindow));
    }
}

void plainPath(benchmark::State& state)
{
    const Input input = inputOf(Walk, 500);
    NodeIndex source = 0;
    for (auto _ : state) {
        source = (source + 1) % 200;
        benchmark::DoNotOptimize(plainWarpPath(
            input.distances.block(source, 401 - pathWindow, pathWindow, pathWindow), settingsOf(0).slope));
    }
}

} // namespace

BENCHMARK(allPairs)
    ->ArgNames({"walk", "mean", "frames", "threads"})
    ->ArgsProduct({{Noise, Walk}, {0, 1}, {1000}, {1}})
    ->Args({Noise, 0, 1000, 4})
    ->Args({Walk, 0, 1000, 4})
    ->Args({Walk, 1, 1000, 4})
    ->Args({Walk, 0, 4000, 4})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(plainPairs)
    ->ArgNames({"walk", "mean"})
    ->ArgsProduct({{Noise, Walk}, {0}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(knownPath)->Unit(benchmark::kMicrosecond);
BENCHMARK(plainPath)->Unit(benchmark::kMicrosecond);
