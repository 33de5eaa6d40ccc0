// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Pose interpolation of 2,700 vertices on one core, with its parts, beside the plain reference: no caching,
// polar factors by SVD, a factorisation by Eigen at each call.
#include "model/transition/poseinterpolation.h"
#include "tests/model/transition/bars.h"
#include "tests/model/transition/plaininterpolation.h"

#include <benchmark/benchmark.h>

using namespace quadrille;

namespace {

/// A bar of 2,702 vertices and 5,400 triangles, and its poses.
struct Subject
{
    Bar bar = makeBar(75, 9, 2.0F, 0.4F);
    std::shared_ptr<const PoissonSystem> system = std::make_shared<const PoissonSystem>(bar.topology);
    std::vector<Vec3f> source = shaken(bar.positions, 0.003, 1);
    std::vector<Vec3f> target = bent(shaken(bar.positions, 0.003, 2), 2.0, 1.5);
    std::shared_ptr<const PreparedPose> preparedSource = std::make_shared<const PreparedPose>(system, source);
    std::shared_ptr<const PreparedPose> preparedTarget = std::make_shared<const PreparedPose>(system, target);
};

const Subject& subject()
{
    static const Subject only;
    return only;
}

/// Another λ between two poses.
void interpolateAnew(benchmark::State& state)
{
    const Subject& s = subject();
    const PoseInterpolation between(s.preparedSource, s.preparedTarget);
    std::vector<Vec3f> out(s.source.size());
    for (auto _ : state) {
        between.at(0.3, out);
        benchmark::DoNotOptimize(out.data());
    }
}

/// A new pair of poses whose factorisations are there: a frame of a blend.
void interpolateNewPair(benchmark::State& state)
{
    const Subject& s = subject();
    std::vector<Vec3f> out(s.source.size());
    for (auto _ : state) {
        PoseInterpolation(s.preparedSource, s.preparedTarget)
            .at(0.3, out, static_cast<InterpolationMethod>(state.range(0)));
        benchmark::DoNotOptimize(out.data());
    }
}

/// Both poses factorised first.
void interpolateNewPoses(benchmark::State& state)
{
    const Subject& s = subject();
    std::vector<Vec3f> out(s.source.size());
    for (auto _ : state) {
        PoseInterpolation(std::make_shared<const PreparedPose>(s.system, s.source),
                          std::make_shared<const PreparedPose>(s.system, s.target))
            .at(0.3, out);
        benchmark::DoNotOptimize(out.data());
    }
}

void interpolatePlainlyAnew(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            interpolatePlainly(*s.bar.topology, s.source, s.target, 0.3, InterpolationMethod::Poisson));
    }
}

/// Symbolic factorisation and what else a topology needs once.
void prepareTopology(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(PoissonSystem(subject().bar.topology));
}

void preparePose(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(PreparedPose(subject().system, subject().source));
}

void frames(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(poseFrames(subject().bar.topology->triangles(), subject().source));
}

void factorise(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(PoissonPose(*s.system, s.preparedSource->frames()));
}

void logarithms(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state) {
        TriangleLogs logs = triangleLogs(s.preparedSource->frames(), s.preparedTarget->frames(),
                                         Eigen::Quaterniond::Identity());
        chooseBranches(*s.system, logs);
        benchmark::DoNotOptimize(logs.u1.data());
    }
}

void edges(benchmark::State& state)
{
    const Subject& s = subject();
    const TriangleLogs logs =
        triangleLogs(s.preparedSource->frames(), s.preparedTarget->frames(), Eigen::Quaterniond::Identity());
    std::vector<TriangleEdges> out(logs.size());
    for (auto _ : state) {
        deformEdges(s.preparedSource->frames(), logs, 0.3, StretchPath::Geodesic, out);
        benchmark::DoNotOptimize(out.data());
    }
}

void solveOnce(benchmark::State& state)
{
    const Subject& s = subject();
    const TriangleLogs logs =
        triangleLogs(s.preparedSource->frames(), s.preparedTarget->frames(), Eigen::Quaterniond::Identity());
    std::vector<TriangleEdges> out(logs.size());
    deformEdges(s.preparedSource->frames(), logs, 0.3, StretchPath::Geodesic, out);
    std::vector<double> x;
    for (auto _ : state) {
        s.preparedSource->poisson().solve(out, x);
        benchmark::DoNotOptimize(x.data());
    }
}

} // namespace

BENCHMARK(interpolateAnew)->Unit(benchmark::kMicrosecond);
BENCHMARK(interpolateNewPair)->Unit(benchmark::kMicrosecond)->Arg(0)->Arg(1)->Arg(2);
BENCHMARK(interpolateNewPoses)->Unit(benchmark::kMicrosecond);
BENCHMARK(interpolatePlainlyAnew)->Unit(benchmark::kMicrosecond);
BENCHMARK(prepareTopology)->Unit(benchmark::kMicrosecond);
BENCHMARK(preparePose)->Unit(benchmark::kMicrosecond);
BENCHMARK(frames)->Unit(benchmark::kMicrosecond);
BENCHMARK(factorise)->Unit(benchmark::kMicrosecond);
BENCHMARK(logarithms)->Unit(benchmark::kMicrosecond);
BENCHMARK(edges)->Unit(benchmark::kMicrosecond);
BENCHMARK(solveOnce)->Unit(benchmark::kMicrosecond);
