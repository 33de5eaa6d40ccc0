// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// A tick of live playing with all that a picture needs – transition, pose over the ground, normals –, beside
// the same by plain loops over takes and references. Wanted: 1 ms at 3,000 vertices, 6 ms at 20,000.
#include "model/live/livepath.h"
#include "model/render/shading.h"
#include "tests/model/parametric/spacefixture.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <ctime>
#include <map>

namespace quadrille {
namespace {

std::shared_ptr<const LiveGraph> graphOf(std::uint32_t vertices)
{
    static std::map<std::uint32_t, std::shared_ptr<const LiveGraph>> graphs;
    std::shared_ptr<const LiveGraph>& graph = graphs[vertices];
    if (graph != nullptr)
        return graph;
    std::vector<std::shared_ptr<const MotionSpace>> spaces;
    for (const std::uint64_t seed : {1, 2}) {
        MotionSpace space =
            test::makeSpace({.seed = seed, .frames = 30, .vertices = vertices, .bisections = 1});
        space.parameters = {{"speed", SpaceMeasure::Speed, {}}};
        space.map =
            fitParameterMap(space.weights, space.parameters, [](const SpacePoint& place) { return place; });
        spaces.push_back(std::make_shared<const MotionSpace>(std::move(space)));
    }
    return graph = std::make_shared<const LiveGraph>(makeLiveGraph(std::move(spaces), 30));
}

/// The other space is wanted every two seconds.
LiveInput inputAt(std::int64_t tick)
{
    constexpr std::int64_t ticks = 120;
    return {.space = static_cast<std::size_t>(tick / ticks % 2), .parameters = {2.2}};
}

void liveTick(benchmark::State& state)
{
    const auto graph = graphOf(static_cast<std::uint32_t>(state.range(0)));
    LivePlayer player(graph, {}, {});
    std::vector<Vec3f> pose(graph->vertexCount());
    const auto& triangles = graph->topology().triangles();
    const IncidentTriangles neighbours = trianglesOfVertices(triangles, graph->topology().vertexCount());
    for (auto _ : state) {
        player.tick(inputAt(player.state().tick));
        player.pose(pose);
        benchmark::DoNotOptimize(vertexNormals(pose, triangles, neighbours).data());
    }
}
BENCHMARK(liveTick)->ArgName("vertices")->Arg(3000)->Arg(20000)->Unit(benchmark::kMicrosecond);

/// The tick alone, with its transitions.
void liveDecisions(benchmark::State& state)
{
    LivePlayer player(graphOf(3000), {}, {});
    for (auto _ : state)
        player.tick(inputAt(player.state().tick));
    benchmark::DoNotOptimize(player.state().tick);
}
BENCHMARK(liveDecisions)->Unit(benchmark::kMicrosecond);

/// A tick along a path, with its share of a plan: some seconds of an S of 40 m. Wanted: 1 ms at most, which
/// “worst” tells, in microseconds of processor time.
void followedTick(benchmark::State& state)
{
    const auto graph = graphOf(3000);
    const Ground ground(graph->up());
    PathConstraint path;
    for (int i = 0; i <= 400; ++i)
        path.points.push_back(ground.at({0.1 * i, std::sin(0.1 * i)}, 0));
    LivePathFollower follower(graph, {}, path);
    LivePlayer player(graph, {}, follower.start());
    const LiveState start = player.state();
    std::clock_t worst = 0;
    for (auto _ : state) {
        const std::clock_t before = std::clock();
        player.tick(follower.next(player.state()));
        worst = std::max(worst, std::clock() - before);
        if (follower.isDone()) {
            player.restore(start);
            follower.resume(start, 0);
        }
    }
    state.counters["worst"] = 1e6 * static_cast<double>(worst) / CLOCKS_PER_SEC;
}
BENCHMARK(followedTick)->Unit(benchmark::kMicrosecond);

/// The pose of one space by plain loops in double precision: cubics of all takes and displacements of all
/// references, then the motion over the ground.
void plainPose(benchmark::State& state)
{
    const auto graph = graphOf(static_cast<std::uint32_t>(state.range(0)));
    const MotionSpace& space = *graph->spaces.front();
    const Ground ground(space.up);
    std::vector<Vec3d> pose(graph->vertexCount());
    std::size_t frame = 0;
    for (auto _ : state) {
        frame = space.next(frame);
        const std::size_t frames = space.frameCount();
        const std::array<double, 4> cubic{-0.0625, 0.5625, 0.5625, -0.0625};
        for (std::size_t v = 0; v < pose.size(); ++v) {
            Vec3d sum = Vec3d::Zero();
            for (const SpaceTake& take : space.takes) {
                for (std::size_t i = 0; i < cubic.size(); ++i)
                    sum += cubic.at(i) * 0.5 *
                           take.poses[(frame + frames - 1 + i) % frames * pose.size() + v].cast<double>();
            }
            pose[v] = sum;
        }
        for (const SpaceReference& reference : space.references) {
            for (std::uint32_t i = reference.starts[frame]; i < reference.starts[frame + 1]; ++i) {
                const auto& d = reference.displacements[i];
                pose[reference.vertices[i]] +=
                    0.5 * static_cast<double>(reference.unit) * Vec3d(d[0], d[1], d[2]);
            }
        }
        const GroundMotion root{0.3, Vec2d(1, 2)};
        for (Vec3d& point : pose)
            point = root(point, ground);
        benchmark::DoNotOptimize(pose.data());
    }
}
BENCHMARK(plainPose)->ArgName("vertices")->Arg(3000)->Arg(20000)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace quadrille
