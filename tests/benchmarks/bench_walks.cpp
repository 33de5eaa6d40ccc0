// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Constrained walks through the Essential graph of real takes (1,150 frames), beside plain references.
#include "model/synthesis/walks/findwalk.h"
#include "model/synthesis/walks/keywalk.h"
#include "tests/model/synthesis/pathreference.h"
#include "tests/model/synthesis/realcharacter.h"

#include <benchmark/benchmark.h>
#include <chrono>
#include <numbers>
#include <numeric>
#include <random>

using namespace quadrille;
using test::RealCharacter;

namespace {

/// Ten frames of the takes in any order, spread over 1,800 output frames.
std::vector<PoseKey> tenKeys(const WalkGraph& graph, std::uint32_t seed)
{
    const WalkGraph::Ways ways = graph.waysTo(600);
    std::mt19937 engine(seed);
    std::vector<PoseKey> keys;
    while (keys.size() < 10) {
        const auto frame = static_cast<NodeIndex>(engine() % static_cast<std::uint32_t>(graph.nodeCount()));
        const auto [first, end] = graph.from(frame);
        const bool isEntered =
            std::any_of(graph.moves().begin(), graph.moves().end(),
                        [&](const WalkMove& m) { return m.to == frame && m.kind == EdgeKind::Transition; });
        if (isEntered && end - first > 1)
            keys.push_back({frame, 200.0 * static_cast<double>(keys.size())});
    }
    return keys;
}

void keys(benchmark::State& state)
{
    const RealCharacter* character = test::wholeRealCharacter();
    if (!character) {
        state.SkipWithError("no real takes");
        return;
    }
    const WalkGraph graph(character->essential.graph, character->costs, RealCharacter::alpha, {});
    const std::vector<PoseKey> wanted = tenKeys(graph, static_cast<std::uint32_t>(state.range(0)));
    const double beta = RealCharacter::alpha * static_cast<double>(state.range(2));
    KeyWalk walk;
    for (auto _ : state) {
        walk = state.range(1) != 0
                   ? walkOverAllKeys(graph, {wanted.front().frame}, wanted, beta, 100'000'000)
                   : walkFromKeyToKey(graph, {wanted.front().frame}, wanted, beta, 100'000'000);
        benchmark::DoNotOptimize(walk);
    }
    state.counters["cost"] = walk.edges + walk.timing;
    state.counters["timing"] = walk.timing;
    state.counters["expansions"] = static_cast<double>(walk.expansions);
    state.counters["optimal"] = walk.optimal;
    state.counters["edges"] = static_cast<double>(graph.moves().size());
}

/// An S of 13.6 m, as an animator would draw it, of which a stretch demands a label.
WalkConstraints sCurve(const RealCharacter& character, const std::string& label, double from, double to)
{
    const Ground ground(UpAxis::Y);
    std::vector<Vec3d> through;
    for (const Vec2d& point : {Vec2d(0, 0), Vec2d(3, 1.5), Vec2d(6, 0), Vec2d(9, -1.5), Vec2d(12, 0)})
        through.push_back(ground.at(point, 0));
    return {.path =
                PathConstraint{.points = sampleCurve(through, 0.02),
                               .spans = {{.from = from, .to = to, .demanded = character.framesOf(label)}}}};
}

const std::array<std::tuple<const char*, double, double>, 3> demands{
    {{"run", 5, 8}, {"kick", 5, 6}, {"walk", 4, 9}}};

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

WalkMaterial materialOf(const RealCharacter& character, const WarpPaths& warps)
{
    return {.graph = character.essential.graph,
            .costs = character.costs,
            .alpha = RealCharacter::alpha,
            .motion = {.roots = &character.roots, .transition = [&](const FramePair& frames) {
                           return *warps.of(character.table, frames);
                       }}};
}

/// The product's search: when its first walk was there, and what it had after two seconds and in the end.
/// The last argument is how far walks are steered, degrees a metre.
void path(benchmark::State& state)
{
    const RealCharacter* character = test::wholeRealCharacter();
    if (!character) {
        state.SkipWithError("no real takes");
        return;
    }
    const WarpPaths warps(character->distances, character->layout, character->settings);
    const WalkMaterial material = materialOf(*character, warps);
    const auto& [label, from, to] = demands[static_cast<std::size_t>(state.range(0))];
    const WalkConstraints constraints = sCurve(*character, label, from, to);
    const double perMetre = static_cast<double>(state.range(2)) * std::numbers::pi / 180;
    const SearchSettings settings{.budget = state.range(1),
                                  .steering = {.perMetre = perMetre, .perFrame = 0.05 * perMetre}};
    for (auto _ : state) {
        const Clock::time_point begin = Clock::now();
        double first = 0;
        double firstCost = 0;
        double soon = 0;
        const WalkSolution best =
            findWalk(material, constraints, settings, {}, [&](const WalkSolution& solution) {
                const double seconds = secondsSince(begin);
                if (first == 0) {
                    first = seconds;
                    firstCost = solution.totalCost;
                }
                if (seconds < 2)
                    soon = solution.totalCost;
            });
        state.counters["first_s"] = first;
        state.counters["first_cost"] = firstCost;
        state.counters["cost_at_2s"] = soon;
        state.counters["cost"] = best.totalCost;
        state.counters["deviation_m"] = best.meanDeviation;
        state.counters["greatest_m"] = best.greatestDeviation;
        state.counters["frames"] = static_cast<double>(best.frameCount);
        state.counters["transitions"] = static_cast<double>(best.walk.transitionCount());
    }
}

/// A transition in the middle of a walk is banned: the rest of the walk kept, or all of it sought anew.
void ban(benchmark::State& state)
{
    const RealCharacter* character = test::wholeRealCharacter();
    if (!character) {
        state.SkipWithError("no real takes");
        return;
    }
    const WarpPaths warps(character->distances, character->layout, character->settings);
    const WalkMaterial material = materialOf(*character, warps);
    const auto& [label, from, to] = demands[2];
    WalkConstraints constraints = sCurve(*character, label, from, to);
    const SearchSettings settings = SearchSettings::calm();
    const WalkSolution before = findWalk(material, constraints, settings);
    constraints.junctions.banned = {before.walk.transition(before.walk.transitionCount() / 2)};
    if (state.range(0) != 0)
        constraints.junctions.walk = before.walk;
    WalkSolution after;
    for (auto _ : state)
        after = findWalk(material, constraints, settings);
    state.counters["cost"] = after.totalCost;
    state.counters["cost_before"] = before.totalCost;
    state.counters["deviation_m"] = after.meanDeviation;
}

/// The paper's incremental branch and bound, look-ahead 20 frames, from one start after the other for 20 s.
void incremental(benchmark::State& state)
{
    const RealCharacter* character = test::wholeRealCharacter();
    if (!character) {
        state.SkipWithError("no real takes");
        return;
    }
    const auto& [label, from, to] = demands[static_cast<std::size_t>(state.range(0))];
    const WalkConstraints constraints = sCurve(*character, label, from, to);
    const WalkGraph graph(character->essential.graph, character->costs, RealCharacter::alpha, {});
    const WarpPaths warps(character->distances, character->layout, character->settings);
    const WalkMotion motion{.roots = &character->roots, .transition = [&](const FramePair& frames) {
                                return *warps.of(character->table, frames);
                            }};
    const ConstraintAutomaton automaton(graph, constraints, 0.1, 0.1);
    const PathCourse course(*constraints.path, UpAxis::Y);
    const PathCosts costs(course, constraints.path->spans, graph.nodeCount(), 0.1);
    std::vector<NodeIndex> starts(static_cast<std::size_t>(graph.nodeCount()));
    std::iota(starts.begin(), starts.end(), 0);
    for (auto _ : state) {
        MoveMotions motions(graph, motion, course);
        PathProblem problem{graph, automaton, course, costs, motions, starts, 0.1};
        const Clock::time_point begin = Clock::now();
        test::BranchAndBound search(
            problem, [&] { return secondsSince(begin) > static_cast<double>(state.range(1)); });
        state.counters["cost"] = search.incrementalFromAll(20);
        state.counters["expansions"] = static_cast<double>(search.expansions());
    }
}

} // namespace

BENCHMARK(path)
    ->ArgsProduct({{0, 1, 2}, {60'000, 400'000}, {0, 30}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(ban)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(incremental)->ArgsProduct({{0, 1, 2}, {2, 20}})->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(keys)->ArgsProduct({{1, 2}, {0, 1}, {1, 3, 10}})->Unit(benchmark::kMillisecond);
