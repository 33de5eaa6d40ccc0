// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Poses of a target of about 43,800 triangles by 50 marks on one core, beside deformation transfer (Sumner &
// Popović 2004), and what is done once: the set-up of a target, and of marks.
#include "model/transfer/stretchtracker.h"
#include "model/transfer/transfersolver.h"
#include "tests/model/transfer/plaindeformationtransfer.h"
#include "tests/model/transition/bars.h"

#include <benchmark/benchmark.h>

using namespace quadrille;

namespace {

struct Subject
{
    Bar bar = makeBar(274, 20, 2.0F, 0.4F);
    std::vector<Vec3f> pose = bent(bar.positions, 2.0, 1.5);
    std::shared_ptr<const TransferTarget> target =
        std::make_shared<const TransferTarget>(*bar.topology, bar.positions);
    std::vector<TriangleIndex> marks;
    std::vector<Triangle> marked;

    Subject()
    {
        const std::size_t count = bar.topology->triangles().size();
        for (std::size_t m = 0; m < 50; ++m) {
            marks.emplace_back(m * count / 50);
            marked.push_back(bar.topology->triangles()[marks.back().value]);
        }
    }
};

const Subject& subject()
{
    static const Subject only;
    return only;
}

void poseByMarks(benchmark::State& state)
{
    const Subject& s = subject();
    const bool asPublished = state.range(1) == 0;
    const TransferSolver solver(s.target, s.marks, static_cast<FieldKind>(state.range(0)), !asPublished);
    std::vector<TrianglePair> pairs;
    for (const TriangleIndex mark : s.marks)
        pairs.push_back({mark, mark});
    const PosedMesh mesh{s.bar.topology, s.bar.positions};
    const PosedSurface rest(mesh);
    MarkTracker tracker(asPublished ? singleTriangles(s.marked)
                                    : patchesAbout(rest, pairs, PatchReach::NextMark),
                        s.bar.positions);
    const StretchTracker stretches(patchesAbout(rest, pairs, PatchReach::Whole), s.bar.positions);
    TransferSolver::Scratch scratch;
    std::vector<Vec3f> out(s.pose.size());
    for (auto _ : state) {
        MarkDeformations deformations = tracker.next(s.pose);
        if (!asPublished)
            deformations.stretches = stretches.next(s.pose);
        solver.pose(deformations, out, scratch);
        benchmark::DoNotOptimize(out.data());
    }
    state.counters["triangles"] = static_cast<double>(s.bar.topology->triangles().size());
}

void poseByDeformationTransfer(benchmark::State& state)
{
    const Subject& s = subject();
    static const PlainDeformationTransfer transfer(*s.bar.topology, s.bar.positions, s.bar.positions);
    for (auto _ : state)
        benchmark::DoNotOptimize(transfer.pose(s.pose));
}

void setUpTarget(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(TransferTarget(*s.bar.topology, s.bar.positions).edges().data());
}

void setUpMarks(benchmark::State& state)
{
    const Subject& s = subject();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            TransferSolver(s.target, s.marks, FieldKind::Quaternions, state.range(0) != 0));
}

} // namespace

BENCHMARK(poseByMarks)
    ->ArgNames({"field", "stretch and surroundings"})
    ->ArgsProduct({{static_cast<int>(FieldKind::Quaternions), static_cast<int>(FieldKind::Logarithms)},
                   {0, 1}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(poseByDeformationTransfer)->Unit(benchmark::kMillisecond);
BENCHMARK(setUpTarget)->Unit(benchmark::kMillisecond);
BENCHMARK(setUpMarks)->ArgName("surroundings")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
