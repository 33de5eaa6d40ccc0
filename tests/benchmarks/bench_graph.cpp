// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The Essential graph from the tables of transitions, beside Boost.Graph's Floyd–Warshall and a plain test of
// every edge ("equal" is 1 when both have the same edges); what the editor waits for when α changes; growth.
// Takes of 50 frames at 25 fps that walk, so that the tables are as smooth as those of real takes.
#include "model/graph/comparison.h"
#include "model/graph/essentialedges.h"
#include "model/graph/measuredgraphs.h"
#include "model/graph/shortestpath.h"
#include "model/transition/transitiontable.h"
#include "tests/model/transition/transitiontables.h"

#include <benchmark/benchmark.h>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/floyd_warshall_shortest.hpp>
#include <map>
#include <tbb/task_arena.h>

using namespace quadrille;

namespace {

constexpr std::int64_t takeFrames = 50;

const TransitionCosts& costsOf(std::int64_t frames)
{
    static std::map<std::int64_t, TransitionCosts> known;
    const auto found = known.find(frames);
    if (found != known.end())
        return found->second;
    const std::vector<std::int64_t> counts(static_cast<std::size_t>(frames / takeFrames), takeFrames);
    const FrameLayout layout(counts);
    const Table<float> distances = walkingDistances(static_cast<int>(frames), 1);
    TransitionTable table = transitionTable(distances, layout, {});
    return known
        .try_emplace(frames, layout, distances.maxCoeff(), std::move(table.cost).take(),
                     std::move(table.length))
        .first->second;
}

double alphaOf(const benchmark::State& state)
{
    return static_cast<double>(state.range(1)) / 1000;
}

/// The edges that the definition keeps, from the shortest paths of Boost.Graph.
std::vector<FramePair> boostEssential(const Table<double>& weights)
{
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                        boost::property<boost::edge_weight_t, double>>;
    const auto frames = static_cast<std::size_t>(weights.rows());
    Graph graph(frames);
    for (Eigen::Index i = 0; i < weights.rows(); ++i)
        for (Eigen::Index j = 0; j < weights.cols(); ++j)
            if (weights(i, j) < unreachable)
                boost::add_edge(static_cast<std::size_t>(i), static_cast<std::size_t>(j), weights(i, j),
                                graph);
    std::vector<std::vector<double>> paths(frames, std::vector<double>(frames));
    boost::floyd_warshall_all_pairs_shortest_paths(graph, paths);
    const auto isReplaceable = [&](std::size_t i, std::size_t j, double weight) {
        for (std::size_t k = 0; k < frames; ++k)
            if (k != i && k != j && paths[i][k] + paths[k][j] <= weight * (1 + 1e-7))
                return true;
        return false;
    };
    std::vector<FramePair> edges;
    for (std::size_t i = 0; i < frames; ++i) {
        for (std::size_t j = 0; j < frames; ++j) {
            const auto from = static_cast<NodeIndex>(i);
            const auto to = static_cast<NodeIndex>(j);
            if (weights(from, to) < unreachable && !isReplaceable(i, j, weights(from, to)))
                edges.push_back({from, to});
        }
    }
    return edges;
}

std::vector<FramePair> pairsOf(const Digraph& graph)
{
    std::vector<FramePair> pairs;
    for (const Edge& edge : graph.edges())
        pairs.push_back({edge.from, edge.to});
    return pairs;
}

void withBoost(benchmark::State& state)
{
    const TransitionCosts& costs = costsOf(state.range(0));
    std::vector<FramePair> edges;
    for (auto _ : state)
        edges = boostEssential(completeWeights(costs, alphaOf(state)));
    state.counters["edges"] = static_cast<double>(edges.size());
    state.counters["equal"] = edges == pairsOf(essentialGraph(costs, alphaOf(state)).graph);
}

void essential(benchmark::State& state)
{
    const TransitionCosts& costs = costsOf(state.range(0));
    tbb::task_arena arena(static_cast<int>(state.range(2)));
    EssentialGraph result;
    for (auto _ : state)
        arena.execute([&] { result = essentialGraph(costs, alphaOf(state)); });
    state.counters["edges"] = static_cast<double>(result.graph.edges().size());
    state.SetComplexityN(state.range(0));
}

/// The same edges without tables of all pairs ("equal" is 1 when they are); beside `growth`.
void edgesAlone(benchmark::State& state)
{
    const TransitionCosts& costs = costsOf(state.range(0));
    tbb::task_arena arena(static_cast<int>(state.range(2)));
    Digraph edges;
    for (auto _ : state)
        arena.execute([&] { edges = essentialEdges(costs, alphaOf(state)); });
    state.counters["edges"] = static_cast<double>(edges.edges().size());
    state.counters["equal"] = edges == essentialGraph(costs, alphaOf(state)).graph;
}

/// What the shortest paths of the Essential graph cost: in a table of all pairs, or some rows at a time.
void pathCosts(benchmark::State& state)
{
    const Digraph graph = essentialGraph(costsOf(state.range(0)), alphaOf(state)).graph;
    const bool isTabled = state.range(2) != 0;
    double mean = 0;
    for (auto _ : state)
        mean = (isTabled ? summarizePathCosts(shortestPathCosts(graph)) : measuredPathCosts(graph)).mean;
    state.counters["mean"] = mean;
}

/// Edges and density of both graphs.
void edgesOfBoth(benchmark::State& state)
{
    const TransitionCosts& costs = costsOf(state.range(0));
    const auto minima = costMinima(costs);
    for (auto _ : state) {
        benchmark::DoNotOptimize(essentialEdges(costs, alphaOf(state)).density());
        benchmark::DoNotOptimize(motionGraph(costs, minima, alphaOf(state)).density());
    }
}

/// And what their shortest paths cost.
void meanCostsOfBoth(benchmark::State& state)
{
    const TransitionCosts& costs = costsOf(state.range(0));
    const auto minima = costMinima(costs);
    double ofEssential = 0;
    double ofMotion = 0;
    for (auto _ : state) {
        ofEssential = summarizePathCosts(essentialGraph(costs, alphaOf(state)).pathCosts).mean;
        ofMotion = summarizePathCosts(shortestPathCosts(motionGraph(costs, minima, alphaOf(state)))).mean;
    }
    state.counters["essential"] = ofEssential;
    state.counters["motion"] = ofMotion;
}

void minima(benchmark::State& state)
{
    const TransitionCosts& costs = costsOf(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(costMinima(costs));
}

BENCHMARK(withBoost)
    ->ArgNames({"frames", "alpha_1000"})
    ->Args({1000, 10})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(essential)
    ->ArgNames({"frames", "alpha_1000", "cores"})
    ->Args({1000, 10, 1})
    ->Args({1000, 10, 4})
    ->Args({1000, 200, 4})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(essential)
    ->Name("growth")
    ->ArgNames({"frames", "alpha_1000", "cores"})
    ->ArgsProduct({{500, 1000, 2000, 4000}, {10}, {4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity();
BENCHMARK(edgesAlone)
    ->ArgNames({"frames", "alpha_1000", "cores"})
    ->ArgsProduct({{1000, 2000, 4000}, {10, 200}, {4}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(pathCosts)
    ->ArgNames({"frames", "alpha_1000", "tabled"})
    ->ArgsProduct({{1000, 2000, 4000}, {10}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(edgesOfBoth)
    ->ArgNames({"frames", "alpha_1000"})
    ->Args({1000, 10})
    ->Args({1000, 200})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(meanCostsOfBoth)
    ->ArgNames({"frames", "alpha_1000"})
    ->Args({1000, 10})
    ->Args({1000, 200})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(minima)->ArgNames({"frames"})->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
