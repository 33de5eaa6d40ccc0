// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/surfacevolume.h"
#include "tests/model/codeof.h"
#include "tests/model/transfer/plaindeformationtransfer.h"
#include "tests/model/transfer/transferfixture.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr std::array kinds{FieldKind::Quaternions, FieldKind::Logarithms};

/// A strip of squares along x, flat; folded up and down at each ring by an angle it stays isometric.
Bar strip(int squares, double fold)
{
    TopologyData data;
    Bar bar;
    Vec3d at = Vec3d::Zero();
    for (int i = 0; i <= squares; ++i) {
        for (const float z : {0.0F, 1.0F})
            bar.positions.push_back(at.cast<float>() + Vec3f(0, 0, z));
        at += Eigen::AngleAxisd(i % 2 == 0 ? fold : -fold, Vec3d::UnitZ()) * Vec3d::UnitX();
        if (i == squares)
            break;
        const auto v = static_cast<std::uint32_t>(2 * i);
        data.triangles.push_back({VertexIndex(v), VertexIndex(v + 1), VertexIndex(v + 2)});
        data.triangles.push_back({VertexIndex(v + 1), VertexIndex(v + 3), VertexIndex(v + 2)});
    }
    data.vertexCount = static_cast<std::uint32_t>(bar.positions.size());
    bar.topology = std::make_shared<const Topology>(std::move(data));
    return bar;
}

} // namespace

TEST(TransferSolver, NothingMovesWhereNothingTurns)
{
    const Bar bar = makeBar(9, 3, 1.0F, 0.3F);
    for (const FieldKind kind : kinds) {
        const auto out = transferred(bar, bar.positions, everyTriangle(*bar.topology, 30), kind);
        EXPECT_LT(largestDistance(out, bar.positions), 1e-6);
    }
}

TEST(TransferSolver, RigidMotionsStayRigid)
{
    const Bar bar = makeBar(9, 3, 1.0F, 0.3F);
    for (const double angle : {30.0, 180.0, 300.0}) {
        const std::vector<Vec3f> pose = moved(bar.positions, [angle](const Vec3d& p) -> Vec3d {
            return Eigen::AngleAxisd(angle * degree, Vec3d(2, -1, 1).normalized()) * p + Vec3d(3, 4, 5);
        });
        for (const FieldKind kind : kinds)
            EXPECT_LT(largestDistance(transferred(bar, pose, everyTriangle(*bar.topology, 30), kind), pose),
                      1e-5)
                << angle;
    }
}

TEST(TransferSolver, MeetsRotationsThatFitTogether)
{
    const Bar flat = strip(12, 0);
    const Bar folded = strip(12, 50 * degree);
    for (const FieldKind kind : kinds)
        EXPECT_LT(largestDistance(transferred(flat, folded.positions, everyTriangle(*flat.topology), kind),
                                  folded.positions),
                  1e-5);
}

TEST(TransferSolver, ResultDoesNotDependOnTheOrderOfVertices)
{
    const Bar bar = makeBar(9, 3, 1.0F, 0.3F);
    const std::vector<Vec3f> pose = bent(bar.positions, 1, 70 * degree);
    const std::vector<TriangleIndex> marks = everyTriangle(*bar.topology, 23);
    const std::vector<Vec3f> expected = transferred(bar, pose, marks);

    std::vector<std::uint32_t> place(bar.positions.size());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), std::mt19937(5));
    Bar shuffled;
    shuffled.positions.resize(place.size());
    std::vector<Vec3f> shuffledPose(place.size());
    for (std::size_t v = 0; v < place.size(); ++v) {
        shuffled.positions[place[v]] = bar.positions[v];
        shuffledPose[place[v]] = pose[v];
    }
    TopologyData data{.vertexCount = bar.topology->vertexCount()};
    for (const Triangle& t : bar.topology->triangles())
        data.triangles.push_back(
            {VertexIndex(place[t[0].value]), VertexIndex(place[t[1].value]), VertexIndex(place[t[2].value])});
    shuffled.topology = std::make_shared<const Topology>(std::move(data));
    const std::vector<Vec3f> out = transferred(shuffled, shuffledPose, marks);
    std::vector<Vec3f> back(out.size());
    for (std::size_t v = 0; v < place.size(); ++v)
        back[v] = out[place[v]];
    EXPECT_LT(largestDistance(back, expected), 1e-5);
}

TEST(TransferSolver, LogarithmsTurnEvenlyPastHalfATurn)
{
    const Bar bar = makeBar(21, 3, 1.0F, 0.1F);
    std::vector<TriangleIndex> marks;
    for (std::size_t t = 0; t < bar.topology->triangles().size(); ++t) {
        float low = 1;
        float high = 0;
        for (const VertexIndex v : bar.topology->triangles()[t]) {
            low = std::min(low, bar.positions[v.value].x());
            high = std::max(high, bar.positions[v.value].x());
        }
        if (high < 0.11F || low > 0.89F)
            marks.emplace_back(t);
    }
    const auto endTurned = [&](double angle) {
        return moved(bar.positions, [angle](const Vec3d& p) -> Vec3d {
            return p.x() > 0.5 ? Eigen::AngleAxisd(angle, Vec3d::UnitX()) * p : p;
        });
    };
    for (const FieldKind kind : kinds) {
        MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
        const TransferSolver solver(std::make_shared<const TransferTarget>(*bar.topology, bar.positions),
                                    marks, kind);
        TransferSolver::Scratch scratch;
        std::vector<Vec3f> out(bar.positions.size());
        for (int step = 0; step <= 24; ++step)
            solver.pose(tracker.next(endTurned(step * 10 * degree)), out, scratch);
        // The vertex at a corner of a ring between the marked ends, about the bar's axis. Both know by the
        // way that led there that the end has turned by 240 degrees, not by 120 the other way.
        const std::size_t corner = 5 * 12;
        const auto angleOf = [&](const std::vector<Vec3f>& pose) {
            Vec3f middle = Vec3f::Zero();
            for (std::size_t k = 0; k < 12; ++k)
                middle += pose[corner + k] / 12;
            const Vec3f spoke = pose[corner] - middle;
            return static_cast<double>(std::atan2(spoke.z(), spoke.y())) / degree;
        };
        const double turned = std::remainder(angleOf(out) - angleOf(bar.positions), 360.0);
        if (kind == FieldKind::Logarithms)
            EXPECT_NEAR(turned, 240 * (0.25 - 0.1) / 0.8, 5);
        else
            EXPECT_LT(turned, 32);
        EXPECT_GT(turned, 0);
    }
}

TEST(TransferSolver, LogarithmsKeepMoreVolumeInSharpBends)
{
    const Bar bar = makeBar(41, 4, 1.0F, 0.2F);
    const SurfaceVolume volume(*bar.topology);
    std::vector<TriangleIndex> marks;
    for (std::size_t t = 0; t < bar.topology->triangles().size(); ++t) {
        const float x = bar.positions[bar.topology->triangles()[t][0].value].x();
        if (x < 0.2F || x > 0.8F)
            marks.emplace_back(t);
    }
    const std::vector<Vec3f> pose = moved(bar.positions, [](const Vec3d& p) -> Vec3d {
        return p.x() > 0.5 ? Eigen::AngleAxisd(150 * degree, Vec3d::UnitY()) * p : p;
    });
    const double quaternions = *volume.of(transferred(bar, pose, marks, FieldKind::Quaternions));
    const double logarithms = *volume.of(transferred(bar, pose, marks, FieldKind::Logarithms));
    EXPECT_GT(logarithms, quaternions);
}

TEST(TransferSolver, CarriesComponentsAndLooseVerticesAlong)
{
    // A second bar beside the first, and a vertex that nothing uses; marks are on the first alone.
    const Bar two = makeBar(5, 2, 1.0F, 0.3F, true, 2);
    TopologyData data = two.topology->data();
    ++data.vertexCount;
    Bar bar{std::make_shared<const Topology>(data), two.positions};
    bar.positions.emplace_back(2.0F, 2.0F, 2.0F);
    const std::vector<TriangleIndex> marks{TriangleIndex(3), TriangleIndex(20)};
    const std::vector<Vec3f> pose = moved(
        bar.positions, [](const Vec3d& p) -> Vec3d { return Eigen::AngleAxisd(1.2, Vec3d::UnitY()) * p; });
    EXPECT_LT(largestDistance(transferred(bar, pose, marks), pose), 1e-4);
}

TEST(PlainDeformationTransfer, OntoTheSameMeshIsExact)
{
    const Bar bar = makeBar(9, 3, 1.0F, 0.3F);
    const std::vector<Vec3f> pose = bent(bar.positions, 1, 70 * degree);
    const Eigen::MatrixXd solved =
        PlainDeformationTransfer(*bar.topology, bar.positions, bar.positions).pose(pose);
    std::vector<Vec3f> out;
    for (std::size_t v = 0; v < pose.size(); ++v)
        out.emplace_back(solved.row(static_cast<Eigen::Index>(v)).transpose().cast<float>());
    EXPECT_LT(largestDistance(out, pose), 1e-5);
}

TEST(TransferSolver, RefusesMarksWithoutAnArea)
{
    Bar bar = makeBar(5, 2, 1.0F, 0.3F);
    const Triangle flat = bar.topology->triangles()[10];
    bar.positions[flat[0].value] = bar.positions[flat[1].value];
    const auto target = std::make_shared<const TransferTarget>(*bar.topology, bar.positions);
    for (const std::uint32_t triangle : {10U, 100'000U})
        EXPECT_EQ(codeOf([&] { TransferSolver(target, std::vector{TriangleIndex(triangle)}); }),
                  ErrorCode::TransferTriangleFlat);
}
