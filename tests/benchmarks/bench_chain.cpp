// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// From meshes to the Essential graph: 5,300 triangles, takes of 50 frames. Compare the rows for how time and
// memory grow; `bytes/table byte` is the peak beside the frames over the tables that are kept.
#include "model/graph/essentialgraph.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitiontable.h"
#include "tests/model/transition/swayingtube.h"

#include <benchmark/benchmark.h>
#include <fstream>
#include <tbb/global_control.h>

namespace quadrille {
namespace {

constexpr std::int64_t takeFrames = 50;

CharacterFrames takes(std::int64_t frames)
{
    constexpr std::uint32_t around = 50;
    static const auto topology = test::tubeTopology(around, 54);
    std::vector<MeshSequence> sequences;
    for (std::int64_t first = 0; first < frames; first += takeFrames)
        sequences.push_back(test::swayingTube(topology, around, takeFrames,
                                              0.05 + 0.002 * static_cast<double>(first % 1000)));
    return CharacterFrames(sequences);
}

/// Kilobytes that /proc/self/status has for a key.
double kilobytes(const std::string& key)
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == key) {
            double value = 0;
            status >> value;
            return value;
        }
    }
    return 0;
}

void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << 5;
}

void BM_MeshesToGraph(benchmark::State& state)
{
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(1)));
    const CharacterFrames character = takes(state.range(0));
    for (auto _ : state) {
        forgetPeak();
        const double before = kilobytes("VmRSS:");
        const PoseDistances poses = poseDistances(character);
        TransitionTable transitions = transitionTable(poses.distances, poses.layout, {.fps = 25});
        const auto pairs = static_cast<double>(poses.distances.size());
        const TransitionCosts costs(poses.layout, static_cast<double>(poses.distances.maxCoeff()),
                                    std::move(transitions.cost).take(), std::move(transitions.length));
        const EssentialGraph essential = essentialGraph(costs, 0.01);
        benchmark::DoNotOptimize(essential.graph.edges().data());
        // Distances and D in single, the costs of walks in double precision, L and two windows in 16 bits.
        const double kept = pairs * (4 + 4 + 8 + 3 * 2);
        state.counters["bytes/table byte"] = 1024 * (kilobytes("VmHWM:") - before) / kept;
    }
}

BENCHMARK(BM_MeshesToGraph)
    ->ArgNames({"frames", "threads"})
    ->ArgsProduct({{500, 1000, 2000, 4000}, {2, 4}})
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

} // namespace
} // namespace quadrille
