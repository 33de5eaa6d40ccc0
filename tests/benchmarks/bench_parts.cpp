// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Curves on a limb of 10,000 vertices and the parts that they cut, on one core, beside what a plain Dijkstra
// search over the whole mesh takes for a single way.
#include "model/geometry/curveedits.h"
#include "model/variation/parts/bodyparts.h"
#include "tests/model/geometry/surfaces.h"

#include <benchmark/benchmark.h>
#include <queue>

using namespace quadrille;

namespace {

constexpr std::uint32_t around = 50;
constexpr std::uint32_t rings = 200;

const test::Surface& limb()
{
    static const test::Surface only = test::jittered(test::makeCapsule(around, rings), 0.02F, 1);
    return only;
}

const std::shared_ptr<const SurfaceGraph>& graph()
{
    static const std::shared_ptr<const SurfaceGraph> only = limb().graph();
    return only;
}

VertexIndex at(std::uint32_t ring, std::uint32_t place)
{
    return VertexIndex(ring * around + place % around);
}

void movePoint(benchmark::State& state)
{
    const auto points = static_cast<std::uint32_t>(state.range(0));
    std::vector<VertexIndex> places;
    for (std::uint32_t i = 0; i < points; ++i)
        places.push_back(at(100, i * around / points));
    SurfaceCurve curve(graph());
    curve.setPoints(places);
    std::uint32_t step = 0;
    for (auto _ : state) {
        curve.move(points - 1, at(98 + ++step % 5, (points - 1) * around / points));
        benchmark::DoNotOptimize(curve.vertices().data());
    }
}

void shorten(benchmark::State& state)
{
    const auto ring = test::ring(around, 100);
    for (auto _ : state)
        benchmark::DoNotOptimize(shortenedCurve(*graph(), ring, 0.5).data());
}

void layBeside(benchmark::State& state)
{
    const auto ring = test::ring(around, 100);
    for (auto _ : state)
        benchmark::DoNotOptimize(parallelCurve(*graph(), ring, 0.5, CurveSide::Smaller).data());
}

/// Five parts in a row.
void cutParts(benchmark::State& state)
{
    std::vector<PartCurve> curves;
    std::vector<PartDescription> parts{{.name = "0", .parent = {}, .curves = {}}};
    for (std::uint32_t i = 1; i < 5; ++i) {
        const std::string name = std::to_string(i);
        curves.push_back({name + "a", test::ring(around, 40 * i)});
        curves.push_back({name + "b", test::ring(around, 40 * i + 8)});
        parts.push_back({name, std::to_string(i - 1), {name + "a", name + "b"}});
    }
    const auto topology = limb().topology();
    for (auto _ : state)
        benchmark::DoNotOptimize(cutIntoParts(*topology, limb().pose, curves, parts).parts.data());
}

void searchPlainly(benchmark::State& state)
{
    for (auto _ : state) {
        std::vector<float> distances(graph()->vertexCount(), 1e9F);
        using Reached = std::pair<float, std::uint32_t>;
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
        queue.emplace(distances[at(100, 0).value] = 0, at(100, 0).value);
        while (!queue.empty()) {
            const auto [distance, v] = queue.top();
            queue.pop();
            if (distance > distances[v])
                continue;
            for (const SurfaceGraph::Edge& edge : graph()->edgesOf(VertexIndex(v))) {
                if (distance + edge.length < distances[edge.to])
                    queue.emplace(distances[edge.to] = distance + edge.length, edge.to);
            }
        }
        benchmark::DoNotOptimize(distances.data());
    }
}

BENCHMARK(movePoint)->ArgName("points")->Arg(1)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK(shorten)->Unit(benchmark::kMillisecond);
BENCHMARK(layBeside)->Unit(benchmark::kMillisecond);
BENCHMARK(cutParts)->Unit(benchmark::kMillisecond);
BENCHMARK(searchPlainly)->Unit(benchmark::kMillisecond);

} // namespace
