// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/curveedits.h"
#include "model/geometry/curveneighbourhood.h"
#include "tests/model/codeof.h"
#include "tests/model/geometry/curvechecks.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using namespace test;
using test::codeOf;

constexpr std::uint32_t around = 24;
const float side = 2 * std::sin(std::numbers::pi_v<float> / around);

/// Thinnest at ring 30, twice as thick at the ends.
Surface hourglass()
{
    const auto radius = [](std::uint32_t r) { return 1 + std::abs(static_cast<float>(r) - 30) / 30; };
    return withTips(makeTube(around, 61, side, radius), around, 0.5F);
}

/// Up and down around a limb, about ring r.
std::vector<VertexIndex> wave(std::uint32_t r)
{
    std::vector<VertexIndex> curve;
    for (std::uint32_t k = 0; k < around; ++k) {
        curve.emplace_back(r * around + k);
        if (k % 4 == 0)
            curve.emplace_back((r + 1) * around + k);
        if (k % 4 == 0)
            curve.emplace_back((r + 1) * around + (k + 1) % around);
    }
    return curve;
}

TEST(ShortenedCurve, SettlesOnTheWaist)
{
    const auto graph = hourglass().graph();
    const auto curve = shortenedCurve(*graph, ring(around, 35), 3);
    EXPECT_EQ(setOf(curve), setOf(ring(around, 30)));
    EXPECT_NEAR(lengthOf(*graph, curve), around * side, 1e-4);
}

TEST(ShortenedCurve, TravelsNoFartherThanAllowed)
{
    const auto graph = hourglass().graph();
    const auto start = ring(around, 40);
    const float travel = 3.2F * side;
    const auto curve = shortenedCurve(*graph, start, travel);
    ASSERT_TRUE(isSimpleLoop(*graph, curve));
    EXPECT_LT(lengthOf(*graph, curve), lengthOf(*graph, start) * 0.95);
    const auto offsets = neighbourhoodOf(*graph, start)->offsets;
    for (const VertexIndex v : curve)
        EXPECT_LE(std::abs(offsets[v.value]), travel);
}

TEST(ShortenedCurve, SmoothsAWaveToARing)
{
    const auto graph = makeCapsule(around, 60).graph();
    const auto curve = shortenedCurve(*graph, wave(30), 2 * side);
    ASSERT_EQ(curve.size(), around);
    EXPECT_NEAR(lengthOf(*graph, curve), around * side, 1e-4);
}

TEST(ShortenedCurve, DoesNotCollapseOverTheEndOfALimb)
{
    // Towards the tip the limb grows thinner all the way, so that every shortening step leads there.
    const auto radius = [](std::uint32_t r) { return 1 - static_cast<float>(r) / 45; };
    const auto graph = withTips(makeTube(around, 41, side, radius), around, 0.1F).graph();
    auto curve = ring(around, 10);
    for (int i = 0; i < 8; ++i) {
        curve = shortenedCurve(*graph, curve, 100);
        ASSERT_TRUE(isSimpleLoop(*graph, curve));
        ASSERT_TRUE(separates(*graph, curve));
        // The tips stay on either side.
        const auto around1 = neighbourhoodOf(*graph, curve);
        ASSERT_TRUE(around1.has_value());
        const float bottom = around1->offsets[around * 41];
        const float top = around1->offsets[around * 41 + 1];
        EXPECT_LT(bottom * top, 0);
    }
    EXPECT_LT(lengthOf(*graph, curve), 0.5 * lengthOf(*graph, ring(around, 10)));
}

TEST(ShortenedCurve, LeavesOtherCurvesAlone)
{
    const auto graph = hourglass().graph();
    const auto curve = shortenedCurve(*graph, ring(around, 35), 3, ring(around, 32));
    for (const VertexIndex v : curve)
        EXPECT_NE(v.value / around, 32U);
    EXPECT_TRUE(separates(*graph, curve));
}

TEST(ParallelCurve, IsTheRingBeside)
{
    const auto graph = makeCapsule(around, 60).graph();
    const double distance = 5 * static_cast<double>(side);
    const auto start = ring(around, 20);
    EXPECT_EQ(setOf(parallelCurve(*graph, start, distance, CurveSide::Smaller)), setOf(ring(around, 15)));
    EXPECT_EQ(setOf(parallelCurve(*graph, start, distance, CurveSide::Larger)), setOf(ring(around, 25)));
    // The side is the surface's, not that of the curve's direction.
    const std::vector<VertexIndex> back(start.rbegin(), start.rend());
    EXPECT_EQ(setOf(parallelCurve(*graph, back, distance, CurveSide::Smaller)), setOf(ring(around, 15)));
}

TEST(ParallelCurve, SaysWhereThereIsNone)
{
    const auto graph = makeCapsule(around, 60).graph();
    const auto parallel = [&](double metres, const std::vector<VertexIndex>& obstacles) {
        return codeOf(
            [&] { parallelCurve(*graph, ring(around, 10), metres, CurveSide::Smaller, obstacles); });
    };
    EXPECT_EQ(parallel(30, {}), ErrorCode::CurveNoParallel);
    EXPECT_EQ(parallel(0, {}), ErrorCode::CurveNoParallel);
    // A row from end to end that no curve gets past.
    std::vector<VertexIndex> row;
    for (std::uint32_t r = 0; r < 60; ++r)
        row.emplace_back(r * around);
    EXPECT_EQ(parallel(1, row), ErrorCode::CurveNoParallel);
    const auto torus = makeTorus(12, 30, 4, 1).graph();
    EXPECT_EQ(codeOf([&] { parallelCurve(*torus, ring(12, 0), 1, CurveSide::Smaller); }),
              ErrorCode::CurveBoundsNothing);
    EXPECT_EQ(codeOf([&] { shortenedCurve(*torus, ring(12, 0), 1); }), ErrorCode::CurveBoundsNothing);
}

TEST(GuidesOf, LeadBackAlongTheCurve)
{
    const auto graph = jittered(makeCapsule(around, 60), 0.02F, 2).graph();
    SurfaceCurve drawn(graph);
    drawn.setPoints({VertexIndex(30 * around), VertexIndex(36 * around + 8), VertexIndex(27 * around + 17)});
    const auto guides = guidesOf(graph, drawn.vertices());
    EXPECT_GE(guides.size(), 3U);
    EXPECT_LE(guides.size(), 12U);
    SurfaceCurve led(graph);
    led.setPoints(guides);
    for (const VertexIndex v : drawn.vertices()) {
        float nearest = 1e9F;
        for (const VertexIndex w : led.vertices())
            nearest = std::min(nearest, (graph->pose()[v.value] - graph->pose()[w.value]).norm());
        EXPECT_LE(nearest, 1.5F * graph->meanEdge());
    }
}

TEST(MirroredCurve, IsTheCounterpartVertexByVertex)
{
    // Slanting edges slant the other way on the other side, where other vertices have to step in.
    const auto graph = makeCapsule(around, 60).graph();
    Symmetry symmetry;
    for (std::uint32_t v = 0; v < graph->vertexCount(); ++v) {
        const std::uint32_t place = v % around;
        const bool isTip = v >= 60 * around;
        symmetry.opposite.emplace_back(isTip ? v : v - place + (around - place) % around);
    }
    const std::vector<VertexIndex> points{VertexIndex(30 * around + 2), VertexIndex(36 * around + 8),
                                          VertexIndex(27 * around + 17)};
    SurfaceCurve curve(graph);
    curve.setPoints(points);
    const GuidedCurve mirrored = mirroredCurve(graph, symmetry, {points, curve.vertices()});
    EXPECT_TRUE(isSimpleLoop(*graph, mirrored.vertices));
    EXPECT_TRUE(separates(*graph, mirrored.vertices));
    EXPECT_GT(mirrored.vertices.size(), curve.vertices().size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(mirrored.points[i], symmetry.opposite[points[i].value]);
    const auto found = setOf(mirrored.vertices);
    for (const VertexIndex v : curve.vertices())
        EXPECT_TRUE(found.contains(symmetry.opposite[v.value]));
    // A ring has no slanting edges.
    EXPECT_EQ(setOf(mirroredCurve(graph, symmetry, {{}, ring(around, 30)}).vertices),
              setOf(ring(around, 30)));
}

/// A symmetry that knows shapes only: across the plane z = 0, the nearest vertex and some triangle at it.
Symmetry shapeOnly(const SurfaceGraph& graph)
{
    Symmetry symmetry;
    for (const Vec3f& p : graph.pose()) {
        const Vec3f reflected(p.x(), p.y(), -p.z());
        const auto nearest = std::ranges::min_element(graph.pose(), {},
                                                      [&](const Vec3f& q) { return (q - reflected).norm(); });
        const VertexIndex v(nearest - graph.pose().begin());
        Triangle t = graph.topology().triangles()[graph.trianglesOf(v).front()];
        std::rotate(t.begin(), std::ranges::find(t, v), t.end());
        symmetry.points.push_back({.corners = t, .weights = {0.8F, 0.1F, 0.1F}});
    }
    return symmetry;
}

TEST(MirroredCurve, OfAnUnevenMeshLeadsThroughOppositePlaces)
{
    const auto graph = jittered(makeCapsule(around, 60), 0.03F, 2).graph();
    const Symmetry symmetry = shapeOnly(*graph);
    SurfaceCurve drawn(graph);
    drawn.setPoints({VertexIndex(30 * around), VertexIndex(36 * around + 8), VertexIndex(27 * around + 17)});
    for (const bool hasPoints : {true, false}) {
        const GuidedCurve curve{hasPoints ? drawn.points() : std::vector<VertexIndex>(), drawn.vertices()};
        const GuidedCurve mirrored = mirroredCurve(graph, symmetry, curve);
        ASSERT_TRUE(isSimpleLoop(*graph, mirrored.vertices));
        EXPECT_TRUE(separates(*graph, mirrored.vertices));
        EXPECT_GE(mirrored.points.size(), 3U);
        for (const VertexIndex v : drawn.vertices()) {
            const Vec3f& p = graph->pose()[v.value];
            float nearest = 1e9F;
            for (const VertexIndex w : mirrored.vertices)
                nearest = std::min(nearest, (Vec3f(p.x(), p.y(), -p.z()) - graph->pose()[w.value]).norm());
            EXPECT_LT(nearest, 2.5F * graph->meanEdge());
        }
    }
}

} // namespace
} // namespace quadrille
