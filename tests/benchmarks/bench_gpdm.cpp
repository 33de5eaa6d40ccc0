// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/gpdm.h"
#include "tests/model/variation/plaingpdm.h"
#include "tests/model/variation/smoothmovement.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <benchmark/benchmark.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Four takes of as many coordinates as a part of 530 vertices has.
SmoothMovement movementOf(Eigen::Index frames)
{
    return smoothMovement(4, frames / 4, 1590, 1);
}

GpdmState stateOf(const SmoothMovement& movement)
{
    GpdmState state{principalLatents(gramMatrix(movement.rows), 3), {}};
    state.hyperparameters.alpha1 = 0.02;
    state.hyperparameters.alpha3 = 1e5;
    return state;
}

/// Objective and gradient, dynamics included; the argument is frames.
void objectiveAndGradient(benchmark::State& run)
{
    const SmoothMovement movement = movementOf(run.range(0));
    const GpdmState state = stateOf(movement);
    const RowMatrix gram = gramMatrix(movement.rows);
    GpdmObjective objective(gram, movement.rows.cols(), movement.spans);
    GpdmObjective::Gradient gradient;
    for (auto _ : run)
        benchmark::DoNotOptimize(objective.value(state, gradient));
}
BENCHMARK(objectiveAndGradient)
    ->ArgName("frames")
    ->Arg(160)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

/// The same by dense matrices that form K⁻¹·Y.
void plainObjectiveAndGradient(benchmark::State& run)
{
    const SmoothMovement movement = movementOf(run.range(0));
    const GpdmState state = stateOf(movement);
    GpdmObjective::Gradient gradient;
    for (auto _ : run)
        benchmark::DoNotOptimize(plainObjective(movement.rows, movement.spans, state, &gradient));
}
BENCHMARK(plainObjectiveAndGradient)
    ->ArgName("frames")
    ->Arg(160)
    ->Arg(200)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

/// Five parts of 3,000 vertices together, 200 frames, in parallel; the argument is threads.
void learning(benchmark::State& run)
{
    constexpr std::array<Eigen::Index, 5> vertices{1200, 400, 400, 500, 500};
    std::vector<SmoothMovement> parts;
    for (const Eigen::Index count : vertices)
        parts.push_back(smoothMovement(5, 40, 3 * count, static_cast<std::uint64_t>(count)));
    tbb::task_arena arena(static_cast<int>(run.range(0)));
    std::array<std::size_t, vertices.size()> iterations{};
    std::atomic<bool> allConverged = true;
    for (auto _ : run) {
        arena.execute([&] {
            tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
                const GpdmLearning learned = learnGpdm(parts[i].rows, parts[i].spans, {});
                iterations[i] = learned.objective.size() - 1;
                if (learned.stop != GpdmStop::Converged)
                    allConverged = false;
            });
        });
    }
    run.counters["converged"] = allConverged ? 1 : 0;
    run.counters["iterations"] = static_cast<double>(*std::max_element(iterations.begin(), iterations.end()));
}
BENCHMARK(learning)->ArgName("threads")->Arg(4)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

} // namespace
