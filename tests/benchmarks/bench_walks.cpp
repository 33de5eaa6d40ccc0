// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Constrained walks through the Essential graph of real takes (1,150 frames), beside plain references.
#include "model/synthesis/keywalk.h"
#include "tests/model/synthesis/realcharacter.h"

#include <benchmark/benchmark.h>
#include <random>

using namespace quadrille;
using testing::RealCharacter;

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
    const RealCharacter* character = testing::realCharacter();
    if (!character) {
        state.SkipWithError("no real takes");
        return;
    }
    const WalkGraph graph(character->essential.graph, character->costs, RealCharacter::alpha, {});
    const std::vector<PoseKey> wanted = tenKeys(graph, static_cast<std::uint32_t>(state.range(0)));
    const double beta = RealCharacter::alpha * static_cast<double>(state.range(2));
    KeyWalk walk;
    for (auto _ : state) {
        walk =
            state.range(1) != 0
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

} // namespace

BENCHMARK(keys)->ArgsProduct({{1, 2}, {0, 1}, {1, 3, 10}})->Unit(benchmark::kMillisecond);
