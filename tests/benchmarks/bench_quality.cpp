// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What the quality report of a variation costs, by its parts, on a body of 7,744 triangles, on one core,
// beside plain versions: all pairs of triangles whose boxes meet; one pair of poses after the other.
#include "model/geometry/selfintersections.h"
#include "model/geometry/surfacevolume.h"
#include "model/transition/nearestposes.h"
#include "model/transition/posedistance.h"
#include "tests/model/transition/bars.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

using namespace quadrille;

namespace {

/// A bar of 7,744 triangles that is bent until its ends go through each other.
struct Subject
{
    Bar bar = makeBar(97, 10, 2.0F, 0.2F);
    SelfIntersections intersections{bar.topology, bar.positions};
    SurfaceVolume volume{*bar.topology};
    std::vector<Vec3f> pose = bent(shaken(bar.positions, 0.002, 1), 2.0, 6.5);
    std::vector<std::vector<Vec3f>> training;

    Subject()
    {
        for (int i = 0; i < 200; ++i)
            training.push_back(bent(bar.positions, 2.0, 0.2 + 0.01 * i));
    }
};

const Subject& subject()
{
    static const Subject only;
    return only;
}

void findSelfIntersections(benchmark::State& state)
{
    std::size_t found = 0;
    for (auto _ : state) {
        found = subject().intersections.find(subject().pose).size();
        benchmark::DoNotOptimize(found);
    }
    state.counters["pairs"] = static_cast<double>(found);
    state.counters["triangles"] = static_cast<double>(subject().bar.topology->triangles().size());
}

void findSelfIntersectionsPlainly(benchmark::State& state)
{
    const std::vector<Triangle>& triangles = subject().bar.topology->triangles();
    const std::vector<Vec3f>& pose = subject().pose;
    std::size_t found = 0;
    for (auto _ : state) {
        found = 0;
        std::vector<Eigen::AlignedBox3f> boxes;
        for (const auto& [a, b, c] : triangles) {
            Eigen::AlignedBox3f box(pose[a.value]);
            boxes.push_back(box.extend(pose[b.value]).extend(pose[c.value]));
        }
        const auto corners = [&](std::size_t t) {
            return std::array{pose[triangles[t][0].value], pose[triangles[t][1].value],
                              pose[triangles[t][2].value]};
        };
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            for (std::size_t j = i + 1; j < triangles.size(); ++j) {
                if (boxes[i].intersects(boxes[j]) &&
                    std::ranges::find_first_of(triangles[i], triangles[j]) == triangles[i].end() &&
                    trianglesCross(corners(i), corners(j)))
                    ++found;
            }
        }
        benchmark::DoNotOptimize(found);
    }
    state.counters["pairs"] = static_cast<double>(found);
}

void volume(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(subject().volume.of(subject().pose));
}

/// The nearest of 200 poses of 3,882 vertices for each of ten.
void findNearestPoses(benchmark::State& state)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const std::vector<Positions> others(subject().training.begin(), subject().training.end());
    const std::vector<Positions> own(10, Positions(subject().pose));
    for (auto _ : state)
        benchmark::DoNotOptimize(nearestPoses(own, others));
}

void findNearestPosesPlainly(benchmark::State& state)
{
    for (auto _ : state) {
        for (int i = 0; i < 10; ++i) {
            double least = 1e300;
            for (const std::vector<Vec3f>& other : subject().training)
                least = std::min(least, euclideanDistance(subject().pose, other));
            benchmark::DoNotOptimize(least);
        }
    }
}

} // namespace

BENCHMARK(findSelfIntersections)->Unit(benchmark::kMicrosecond);
BENCHMARK(findSelfIntersectionsPlainly)->Unit(benchmark::kMicrosecond);
BENCHMARK(volume)->Unit(benchmark::kMicrosecond);
BENCHMARK(findNearestPoses)->Unit(benchmark::kMicrosecond);
BENCHMARK(findNearestPosesPlainly)->Unit(benchmark::kMicrosecond);
