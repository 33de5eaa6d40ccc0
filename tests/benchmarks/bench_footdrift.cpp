// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How far transitions drag feet, on one core, beside the plain way: the plan of a clip for each transition,
// and its feet looked at. "items_per_second" are transitions, so that their ratio is the gain.
#include "tests/model/synthesis/draggedfeet.h"

#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

using namespace quadrille;

namespace {

void allDrifts(benchmark::State& state)
{
    const test::Walker walker(1);
    const auto transitions = (walker.transitions.length > 0).count();
    tbb::task_arena arena(1);
    for (auto _ : state)
        arena.execute([&] { benchmark::DoNotOptimize(walker.drifts()); });
    state.SetItemsProcessed(state.iterations() * transitions);
}

void plainDrifts(benchmark::State& state)
{
    const test::Walker walker(1);
    const Table<float> drifts = walker.drifts();
    std::int64_t count = 0;
    for (auto _ : state) {
        for (NodeIndex i = 0; i <= 25; ++i, ++count) {
            const double drift = walker.expected(i, 60);
            if (std::abs(drift - static_cast<double>(drifts(i, 60))) > 1e-5)
                state.SkipWithError("The drifts differ.");
        }
    }
    state.SetItemsProcessed(count);
}

BENCHMARK(allDrifts)->Unit(benchmark::kMillisecond);
BENCHMARK(plainDrifts)->Unit(benchmark::kMillisecond);

} // namespace
