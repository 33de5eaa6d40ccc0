// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"
#include "tests/model/variation/plaindynamics.h"
#include "tests/model/variation/posedloops.h"

#include <Eigen/Cholesky>
#include <benchmark/benchmark.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr Eigen::Index takeFrames = 40;

/// As many takes as frames make.
LatentLoops loopsOf(std::int64_t frames)
{
    return latentLoops(frames / takeFrames, takeFrames);
}

/// Energy and gradient of a trajectory; the argument is training frames.
void energyAndGradient(benchmark::State& run)
{
    const LatentLoops loops = loopsOf(run.range(0));
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix trajectory = loops.trajectory(1) + 0.02 * normals(takeFrames, 3, 1);
    RowMatrix gradient;
    for (auto _ : run)
        benchmark::DoNotOptimize(dynamics.energy(trajectory, &gradient));
}
BENCHMARK(energyAndGradient)->ArgName("frames")->Arg(160)->Arg(1000)->Unit(benchmark::kMillisecond);

/// The energy alone by the formulas as printed, with inverses.
void plainEnergy(benchmark::State& run)
{
    const LatentLoops loops = loopsOf(run.range(0));
    const PlainDynamics dynamics(loops);
    const RowMatrix trajectory = loops.trajectory(1) + 0.02 * normals(takeFrames, 3, 1);
    for (auto _ : run)
        benchmark::DoNotOptimize(dynamics.energy(trajectory));
}
BENCHMARK(plainEnergy)->ArgName("frames")->Arg(160)->Unit(benchmark::kMillisecond);

/// Twenty variations of 40 frames for five parts of 600 vertices.
void twentyVariations(benchmark::State& run)
{
    const PosedLoops posed(loopsOf(200), {}, 600);
    tbb::task_arena arena(static_cast<int>(run.range(0)));
    for (auto _ : run)
        arena.execute([&] {
            tbb::parallel_for(0, 5, [&](int part) {
                const PoseSpread poses(posed.loops.state, posed.rows, posed.loops.spans, 600);
                benchmark::DoNotOptimize(sampleTrajectories(posed.dynamics, poses,
                                                            {posed.loops.trajectory(1)}, 20,
                                                            static_cast<std::uint64_t>(part))
                                             .trajectories.data());
            });
        });
}
BENCHMARK(twentyVariations)->ArgName("threads")->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond)->UseRealTime();

constexpr Eigen::Index coordinates = 9000;

/// Poses of 3,000 vertices from 160 training frames; the argument is how many at a time.
void reconstruction(benchmark::State& run)
{
    const LatentLoops loops = loopsOf(160);
    const RowMatrix rows = loops.state.latents * normals(3, coordinates, 2);
    const PoseReconstruction poses(loops.state, rows, Eigen::RowVectorXd::Zero(coordinates));
    const RowMatrix trajectory = loops.trajectory(1).topRows(run.range(0));
    for (auto _ : run)
        benchmark::DoNotOptimize(poses.means(trajectory).data());
    run.SetItemsProcessed(run.iterations() * run.range(0));
}
BENCHMARK(reconstruction)->ArgName("frames")->Arg(1)->Arg(40)->Unit(benchmark::kMillisecond);

/// The same by eq. 12 with K⁻¹·Y in double precision.
void plainReconstruction(benchmark::State& run)
{
    const LatentLoops loops = loopsOf(160);
    const RowMatrix& X = loops.state.latents;
    const GpdmHyperparameters& p = loops.state.hyperparameters;
    const auto kernel = [&](const RowMatrix& a, const RowMatrix& b) {
        return RowMatrix::NullaryExpr(a.rows(), b.rows(), [&](Eigen::Index i, Eigen::Index j) {
            return p.alpha1 * std::exp(-0.5 * p.alpha2 * (a.row(i) - b.row(j)).squaredNorm());
        });
    };
    RowMatrix covariance = kernel(X, X);
    covariance.diagonal().array() += 1 / p.alpha3;
    const RowMatrix weights = covariance.llt().solve(X * normals(3, coordinates, 2));
    const RowMatrix trajectory = loops.trajectory(1).topRows(run.range(0));
    for (auto _ : run) {
        const RowMatrix cross = kernel(trajectory, X);
        const RowMatrix poses = cross * weights;
        benchmark::DoNotOptimize(poses.data());
    }
    run.SetItemsProcessed(run.iterations() * run.range(0));
}
BENCHMARK(plainReconstruction)->ArgName("frames")->Arg(1)->Arg(40)->Unit(benchmark::kMillisecond);

} // namespace
