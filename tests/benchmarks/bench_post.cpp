// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Post-processing of a clip of the sample (3,161 vertices) on one core: deforming a leg beside the textbook's
// way (everything anew, SVD, LU), and retiming beside interpolating each frame by itself.
#include "model/sequence/contacts.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/synthesis/finishing/legdeformation.h"
#include "model/synthesis/finishing/loop.h"
#include "model/synthesis/finishing/retime.h"
#include "model/transition/poseinterpolation.h"
#include "tests/model/synthesis/clipof.h"
#include "tests/model/synthesis/plainlegdeformation.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

using namespace quadrille;

namespace {

struct Subject
{
    const MeshSequence& take = test::sampleTake("walk 1");
    Clip clip = test::clipOf(take);
    std::vector<ContactSpan> contacts = detectContacts(take);
    Legs legs =
        findLegs(*clip.topology, upright(clip.positions, clip.topology->vertexCount(), UpAxis::Y), 0.07);
    FootShift shift{.pivot = Vec2d::Zero(), .turn = 0.1, .shift = {0.04, 0.02}, .lift = 0.005};
};

const Subject& subject()
{
    static const Subject only;
    return only;
}

void deformLeg(benchmark::State& state)
{
    const Subject& s = subject();
    const LegDeformation leg(*s.clip.topology, s.legs.vertices[0], s.legs.feet[0].vertices, s.legs.reference);
    for (auto _ : state) {
        std::vector<Vec3f> pose(s.clip.frame(7).begin(), s.clip.frame(7).end());
        leg.apply(s.shift, Ground(UpAxis::Y), pose);
        benchmark::DoNotOptimize(pose.data());
    }
}

void deformLegPlainly(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state) {
        std::vector<Vec3f> pose(s.clip.frame(7).begin(), s.clip.frame(7).end());
        test::deformLegPlainly(*s.clip.topology, s.legs.vertices[0], s.legs.feet[0].vertices,
                               s.legs.reference, s.shift, Ground(UpAxis::Y), pose);
        benchmark::DoNotOptimize(pose.data());
    }
}

/// Time is that of a frame.
void correctContacts(benchmark::State& state)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(contactsCorrected(s.clip, s.contacts));
    state.counters["perFrame"] =
        benchmark::Counter(static_cast<double>(state.iterations() * s.clip.frameCount()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void retimeByTwo(benchmark::State& state)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(retimed(s.clip, {.time = RetimeFactor{2}}, UpAxis::Y));
    state.counters["perFrame"] =
        benchmark::Counter(static_cast<double>(state.iterations() * (s.clip.frameCount() - 1)),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void retimeByTwoPlainly(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state) {
        for (std::int64_t f = 0; f + 1 < s.clip.frameCount(); ++f)
            benchmark::DoNotOptimize(
                interpolatePoses(s.clip.topology, s.clip.frame(f), s.clip.frame(f + 1), 0.5));
    }
    state.counters["perFrame"] =
        benchmark::Counter(static_cast<double>(state.iterations() * (s.clip.frameCount() - 1)),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void closeLoop(benchmark::State& state)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    for (auto _ : state)
        benchmark::DoNotOptimize(seamlessLoop(subject().clip, {}, {}));
}

BENCHMARK(deformLeg)->Unit(benchmark::kMillisecond);
BENCHMARK(deformLegPlainly)->Unit(benchmark::kMillisecond);
BENCHMARK(correctContacts)->Unit(benchmark::kMillisecond);
BENCHMARK(retimeByTwo)->Unit(benchmark::kMillisecond);
BENCHMARK(retimeByTwoPlainly)->Unit(benchmark::kMillisecond);
BENCHMARK(closeLoop)->Unit(benchmark::kMillisecond);

} // namespace
