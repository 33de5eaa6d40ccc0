// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Stitching of five parts of a body of 3,000 vertices, with its steps, on one core and on all, beside the
// plain reference: the boundary by a search from every vertex, gradients by singular value decompositions, a
// factorisation by Eigen at each call.
#include "model/variation/parts/stitching.h"
#include "tests/model/variation/handmadeparts.h"
#include "tests/model/variation/plainstitching.h"

#include <benchmark/benchmark.h>
#include <cmath>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr int frameCount = 40;

/// A bar of 3,002 vertices in five parts, each with an overlap of eight rings of 40 vertices.
struct Subject
{
    PartedBar parted{75, 10, 2.0F, 0.3F, true, 8};
    Stitching stitching{parted.bar.topology, parted.parts, parted.bar.positions};
    std::vector<std::vector<Vec3f>> sequences{5};

    Subject()
    {
        for (int f = 0; f < frameCount; ++f) {
            for (std::size_t p = 0; p < sequences.size(); ++p) {
                const double t = 0.2 * f + 0.3 * static_cast<double>(p);
                const std::vector<Vec3f> whole = bent(twisted(parted.bar.positions, 2.0, 0.5 * std::sin(t)),
                                                      2.0, 1.0 + 0.5 * std::cos(1.3 * t));
                const std::vector<Vec3f> part = cutPose(parted.parts, whole)[p];
                sequences[p].insert(sequences[p].end(), part.begin(), part.end());
            }
        }
    }
    std::vector<Positions> firstFrame() const
    {
        std::vector<Positions> poses;
        for (const std::vector<Vec3f>& sequence : sequences)
            poses.push_back(Positions(sequence).first(sequence.size() / frameCount));
        return poses;
    }
};

const Subject& subject()
{
    static const Subject only;
    return only;
}

/// The overlap of the second part and what its edges cost.
struct Cut
{
    PartOverlap overlap{*subject().parted.bar.topology, subject().parted.parts.parts[1],
                        subject().parted.bar.positions};
    std::vector<Vec3f> places;
    std::vector<Vec3d> differences;
    std::vector<double> costs = std::vector<double>(overlap.edgeCount(), 0.0);

    Cut()
    {
        for (const VertexIndex v : subject().parted.parts.parts[1].overlap) {
            places.push_back(subject().parted.bar.positions[v.value]);
            const Vec3d place = places.back().cast<double>();
            differences.emplace_back(0.02 * std::sin(9 * place.x()), 0.01 * std::cos(20 * place.y()),
                                     0.01 * std::sin(15 * place.z()));
        }
        overlap.addCosts(differences, costs);
    }
};

const Cut& cut()
{
    static const Cut only;
    return only;
}

/// A frame by itself, with a search for its boundaries.
void stitchOneFrame(benchmark::State& state)
{
    const std::vector<Positions> poses = subject().firstFrame();
    std::vector<Vec3f> out(subject().parted.bar.positions.size());
    for (auto _ : state) {
        subject().stitching.stitch(poses, out);
        benchmark::DoNotOptimize(out.data());
    }
}

/// A frame along given boundaries.
void stitchAlongSeams(benchmark::State& state)
{
    const std::vector<Positions> poses = subject().firstFrame();
    std::vector<Vec3f> out(subject().parted.bar.positions.size());
    const Stitching::Seams seams = subject().stitching.stitch(poses, out);
    for (auto _ : state) {
        subject().stitching.stitch(poses, seams, out);
        benchmark::DoNotOptimize(out.data());
    }
}

/// The same, and no triangle stretches further than in some poses.
void stitchKeepingShapes(benchmark::State& state)
{
    const Subject& s = subject();
    const std::vector<Vec3f>& rest = s.parted.bar.positions;
    const Stitching stitching(s.parted.bar.topology, s.parted.parts, rest, std::vector<Positions>{rest});
    const std::vector<Positions> poses = s.firstFrame();
    std::vector<Vec3f> out(rest.size());
    const Stitching::Seams seams = stitching.stitch(poses, out);
    for (auto _ : state) {
        stitching.stitch(poses, seams, out);
        benchmark::DoNotOptimize(out.data());
    }
}

void stitchOneFramePlainly(benchmark::State& state)
{
    const Subject& s = subject();
    const std::vector<Positions> poses = s.firstFrame();
    std::vector<Vec3f> out(s.parted.bar.positions.size());
    const Stitching::Seams seams = s.stitching.stitch(poses, out);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            plainStitch(*s.parted.bar.topology, s.parted.parts, s.parted.bar.positions, poses, seams.curves));
    }
}

/// 40 frames along one set of boundaries, on all cores.
void stitchManyFrames(benchmark::State& state)
{
    const std::vector<Positions> parts = viewed(subject().sequences);
    for (auto _ : state)
        benchmark::DoNotOptimize(stitchFrames(subject().stitching, parts));
    state.SetItemsProcessed(state.iterations() * frameCount);
}

void prepareStitching(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(Stitching(s.parted.bar.topology, s.parted.parts, s.parted.bar.positions));
}

void edgeCosts(benchmark::State& state)
{
    std::vector<double> costs(cut().overlap.edgeCount(), 0.0);
    for (auto _ : state) {
        cut().overlap.addCosts(cut().differences, costs);
        benchmark::DoNotOptimize(costs.data());
    }
}

void boundary(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(cut().overlap.cheapestSeam(cut().costs));
}

void boundaryPlainly(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(plainSeam(cut().overlap, cut().places, cut().costs));
}

void shares(benchmark::State& state)
{
    const std::vector<std::uint32_t> seam = cut().overlap.cheapestSeam(cut().costs);
    for (auto _ : state)
        benchmark::DoNotOptimize(cut().overlap.shares(seam));
}

} // namespace

BENCHMARK(stitchOneFrame)->Unit(benchmark::kMicrosecond);
BENCHMARK(stitchAlongSeams)->Unit(benchmark::kMicrosecond);
BENCHMARK(stitchKeepingShapes)->Unit(benchmark::kMicrosecond);
BENCHMARK(stitchOneFramePlainly)->Unit(benchmark::kMicrosecond);
BENCHMARK(stitchManyFrames)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(prepareStitching)->Unit(benchmark::kMicrosecond);
BENCHMARK(edgeCosts)->Unit(benchmark::kMicrosecond);
BENCHMARK(boundary)->Unit(benchmark::kMicrosecond);
BENCHMARK(boundaryPlainly)->Unit(benchmark::kMicrosecond);
BENCHMARK(shares)->Unit(benchmark::kMicrosecond);
