// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/parametric/plainsimilarity.h"
#include "tests/model/parametric/plaintransitions.h"
#include "tests/model/parametric/spacefixture.h"

#include <benchmark/benchmark.h>
#include <map>
#include <numbers>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Takes that swing smoothly, each with its own phase and amplitude, so that costs vary as those of captures
/// do: 40 frames of 3,000 vertices, or fewer.
MotionSpace swingingSpace(int dimension, std::uint32_t vertices, double phase)
{
    RandomSpace made{.frames = 40, .vertices = vertices, .dimension = dimension, .bisections = 2};
    if (dimension == 2)
        made.places = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    if (dimension == 3)
        made.places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                       {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    MotionSpace space = makeSpace(made);
    for (std::size_t t = 0; t < space.takes.size(); ++t) {
        const SpacePoint& place = made.places[t];
        SpaceTake& take = space.takes[t];
        for (std::size_t f = 0; f < made.frames; ++f) {
            const double angle =
                2 * std::numbers::pi * static_cast<double>(f) / static_cast<double>(made.frames) + phase;
            for (std::uint32_t v = 0; v < vertices; ++v) {
                const double height = static_cast<double>(v) / vertices;
                take.poses[f * vertices + v] =
                    Vec3d(height + 0.1 * place[2] * std::sin(2 * angle),
                          (0.3 + 0.2 * place[0]) * std::sin(angle + 3 * height + 0.3 * place[1]),
                          0.3 * place[1] * std::cos(angle + 5 * height) + 0.1 * phase)
                        .cast<float>();
            }
            take.steps[f] = {0, Vec2d(0.03 + 0.05 * place[0], 0)};
            take.seconds[f] = 0.04;
        }
    }
    for (SpaceReference& reference : space.references)
        reference.unit = 1e-5F;
    return space;
}

/// Two spaces, and requests between them.
struct Spaces
{
    MotionSpace source;
    MotionSpace target;
    std::shared_ptr<const SimilarityTable> table;
};

const Spaces& spacesOf(int dimension)
{
    static std::map<int, Spaces> all;
    const auto found = all.find(dimension);
    if (found != all.end())
        return found->second;
    Spaces spaces{swingingSpace(dimension, 300, 0), swingingSpace(dimension, 300, 1), {}};
    spaces.table = std::make_shared<const SimilarityTable>(similarities(spaces.source, spaces.target));
    return all.emplace(dimension, std::move(spaces)).first->second;
}

struct Request
{
    SpaceState state;
    TransitionGoal goal;
};

std::vector<Request> requests(const Spaces& spaces, int dimension, bool isAnyFrame)
{
    Random random(11);
    std::vector<Request> all(50);
    for (Request& request : all) {
        request.state.frame = random.between(0, static_cast<double>(spaces.source.frameCount()));
        request.goal.firstFrame = isAnyFrame ? 0 : random.next() % spaces.target.frameCount();
        request.goal.lastFrame = isAnyFrame ? spaces.target.frameCount() - 1 : request.goal.firstFrame;
        for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
            request.state.place[d] = dimension == 1 ? random.between(1, 3) : random.unit();
            request.goal.place[d] = dimension == 1 ? random.between(1, 3) : random.unit();
        }
    }
    return all;
}

void tables(benchmark::State& state)
{
    const MotionSpace source = swingingSpace(1, 3000, 0);
    const MotionSpace target = swingingSpace(1, 3000, 1);
    tbb::task_arena arena(static_cast<int>(state.range(0)));
    for (auto _ : state)
        arena.execute([&] { benchmark::DoNotOptimize(similarities(source, target).greatest); });
}
BENCHMARK(tables)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void plainTables(benchmark::State& state)
{
    const MotionSpace source = swingingSpace(1, 3000, 0);
    const MotionSpace target = swingingSpace(1, 3000, 1);
    for (auto _ : state)
        benchmark::DoNotOptimize(plainSimilarities(source, target, 1).data());
}
BENCHMARK(plainTables)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One of 50 requests.
void searches(benchmark::State& state)
{
    const auto dimension = static_cast<int>(state.range(0));
    const Spaces& spaces = spacesOf(dimension);
    TransitionSearch search(
        spaces.table, spaces.source, spaces.target,
        {.depth = static_cast<int>(state.range(1)), .choices = static_cast<std::size_t>(state.range(2))});
    const std::vector<Request> all = requests(spaces, dimension, state.range(3) != 0);
    std::size_t next = 0;
    for (auto _ : state) {
        const Request& request = all[next++ % all.size()];
        benchmark::DoNotOptimize(search.search(request.state, request.goal).data());
    }
}
BENCHMARK(searches)
    ->ArgNames({"dimension", "depth", "choices", "anyFrame"})
    ->ArgsProduct({{1, 2, 3}, {10, 12}, {1, 6}, {0}})
    ->ArgsProduct({{1, 2, 3}, {12}, {1}, {1}})
    ->Unit(benchmark::kMicrosecond);

void plainSearches(benchmark::State& state)
{
    const auto dimension = static_cast<int>(state.range(0));
    const Spaces& spaces = spacesOf(dimension);
    const std::vector<Request> all = requests(spaces, dimension, false);
    std::size_t next = 0;
    for (auto _ : state) {
        const Request& request = all[next++ % all.size()];
        benchmark::DoNotOptimize(plainTransitions(*spaces.table, spaces.source, spaces.target, request.state,
                                                  request.goal,
                                                  {.depth = static_cast<int>(state.range(1)), .choices = 1})
                                     .data());
    }
}
BENCHMARK(plainSearches)
    ->ArgNames({"dimension", "depth"})
    ->ArgsProduct({{1, 2}, {10, 12}})
    ->Unit(benchmark::kMicrosecond);

} // namespace
