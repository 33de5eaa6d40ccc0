// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfacecurve.h"
#include "model/geometry/surfacedistances.h"
#include "tests/model/codeof.h"
#include "tests/model/geometry/curvechecks.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <limits>

namespace quadrille {
namespace {

using namespace test;
using test::codeOf;

constexpr float infinite = std::numeric_limits<float>::infinity();

VertexIndex onTube(std::uint32_t ring, std::uint32_t place, std::uint32_t around = 24)
{
    return VertexIndex(ring * around + place);
}

TEST(SurfaceDistances, AreStraightInAPlane)
{
    const auto graph = makeSheet(20, 15).graph();
    SurfaceDistances distances(*graph);
    distances.add({VertexIndex(0), 0}, 0);
    distances.growTo(infinite);
    for (std::uint32_t v = 1; v < graph->vertexCount(); ++v) {
        const float straight = graph->pose()[v].norm();
        EXPECT_NEAR(distances.at(SheetVertex{VertexIndex(v)}) / straight, 1, 1e-4F) << v; // rounding
    }
}

TEST(SurfaceDistances, FollowAnUnrolledTube)
{
    constexpr std::uint32_t around = 24;
    const auto graph = makeTube(around, 30, 0.25F, 1).graph();
    SurfaceDistances distances(*graph);
    distances.add({VertexIndex(0), 0}, 0);
    distances.growTo(infinite);
    const float side = 2 * std::sin(std::numbers::pi_v<float> / around);
    for (std::uint32_t v = 1; v < graph->vertexCount(); ++v) {
        const auto turns = static_cast<float>(std::min(v % around, around - v % around));
        const float straight = std::hypot(turns * side, graph->pose()[v].y());
        EXPECT_NEAR(distances.at(SheetVertex{VertexIndex(v)}) / straight, 1, 1e-4F) << v;
    }
}

TEST(SurfaceDistances, StayNearTheTruthOnWildTriangles)
{
    // Angles of up to 140 degrees; none is folded over.
    Surface sheet = jittered(makeSheet(30, 30), 0.3F, 5);
    for (Vec3f& p : sheet.pose)
        p.y() = 0;
    const auto graph = sheet.graph();
    SurfaceDistances distances(*graph);
    const VertexIndex middle(15 * 30 + 15);
    distances.add({middle, 0}, 0);
    distances.growTo(infinite);
    for (std::uint32_t v = 0; v < graph->vertexCount(); ++v) {
        const float straight = (graph->pose()[v] - graph->pose()[middle.value]).norm();
        // A jagged rim forces detours.
        if (straight < 12) {
            EXPECT_NEAR(distances.at(SheetVertex{VertexIndex(v)}), straight, 0.02F * straight) << v;
        }
    }
}

TEST(CrossCut, TellsSheetsOnItsLeftAlsoBesideAHole)
{
    constexpr std::uint32_t columns = 7;
    Surface sheet = makeSheet(columns, 7);
    const auto at = [](std::uint32_t column, std::uint32_t row) {
        return VertexIndex(row * columns + column);
    };
    // Two triangles above the middle of the cut are missing, so that a turn around it is interrupted.
    std::erase_if(sheet.data.triangles,
                  [&](const Triangle& t) { return hasCorner(t, at(3, 3)) && hasCorner(t, at(3, 4)); });
    const auto graph = sheet.graph();
    const CrossCut cut(*graph, {at(1, 3), at(2, 3), at(3, 3), at(4, 3), at(5, 3)});
    for (std::uint32_t v = 0; v < graph->vertexCount(); ++v) {
        for (const SurfaceGraph::Edge& edge : graph->edgesOf(VertexIndex(v))) {
            const bool leaves = v / columns == 3 && v % columns > 1 && v % columns < 5;
            const bool enters = edge.to / columns == 3 && edge.to % columns > 1 && edge.to % columns < 5;
            const int expected = leaves && edge.to / columns == 4 ? 1 : enters && v / columns == 4 ? -1 : 0;
            EXPECT_EQ(cut.crossing(VertexIndex(v), VertexIndex(edge.to)), expected) << v << " " << edge.to;
        }
    }
    // Once around one end.
    const std::vector<VertexIndex> round{at(3, 2), at(4, 2), at(5, 2), at(6, 2),
                                         at(6, 3), at(5, 4), at(4, 4), at(4, 3)};
    EXPECT_EQ(std::abs(cut.climbOf(round)), 1);
}

TEST(SurfaceCurve, OfOnePointIsTheRingThroughIt)
{
    const auto graph = makeCapsule(24, 60).graph();
    SurfaceCurve curve(graph);
    curve.setPoints({onTube(31, 7)});
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 31)));
    EXPECT_EQ(curve.vertices().front(), onTube(31, 7));
    EXPECT_NEAR(lengthOf(*graph, curve.vertices()), 48 * std::sin(std::numbers::pi / 24), 1e-5);
}

TEST(SurfaceCurve, OfOnePointSurroundsAnOpenTube)
{
    const auto graph = makeTube(24, 60, 0.2F, 1).graph();
    SurfaceCurve curve(graph);
    curve.setPoints({onTube(20, 0)});
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 20)));
}

TEST(SurfaceCurve, OfTwoPointsLeadsAroundThroughBoth)
{
    const auto graph = makeCapsule(24, 60).graph();
    SurfaceCurve curve(graph);
    curve.setPoints({onTube(30, 2), onTube(30, 9)});
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 30)));
    curve.setPoints({onTube(28, 0), onTube(32, 12)});
    EXPECT_TRUE(isSimpleLoop(*graph, curve.vertices()));
    EXPECT_TRUE(separates(*graph, curve.vertices()));
    const double side = 2 * std::sin(std::numbers::pi / 24);
    const double straight = 2 * std::hypot(12 * side, 4 * side);
    // Edges slant one way only: over twelve columns and four rows the shortest way over edges is 8 % longer
    // than the straight line where they do, and 26 % where they do not.
    EXPECT_LT(lengthOf(*graph, curve.vertices()), 1.18 * straight);
    EXPECT_GE(lengthOf(*graph, curve.vertices()), straight);
}

TEST(SurfaceCurve, OfPointsOnOneSideStillSurroundsTheLimb)
{
    const auto graph = makeCapsule(24, 60).graph();
    SurfaceCurve curve(graph);
    curve.setPoints({onTube(30, 0), onTube(30, 2), onTube(30, 5)});
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 30)));
    // Also after an edit that re-routes the piece that goes round, wherever on the ring.
    for (std::uint32_t k = 0; k < 24; ++k) {
        curve.setPoints({onTube(30, k), onTube(30, (k + 2) % 24), onTube(30, (k + 5) % 24)});
        curve.move(0, onTube(30, (k + 1) % 24));
        EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 30))) << k;
    }
    // The same in another order of clicks.
    curve.setPoints({onTube(30, 2), onTube(30, 5), onTube(30, 0)});
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 30)));
}

TEST(SurfaceCurve, PassesItsPointsInOrder)
{
    const auto graph = makeCapsule(24, 60).graph();
    SurfaceCurve curve(graph);
    const std::vector<VertexIndex> points{onTube(30, 3), onTube(33, 9), onTube(28, 16), onTube(31, 21)};
    curve.setPoints(points);
    EXPECT_EQ(curve.points(), points);
    ASSERT_EQ(curve.places().size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(curve.vertices()[curve.places()[i]], points[i]);
    EXPECT_TRUE(std::ranges::is_sorted(curve.places()));
    EXPECT_EQ(curve.pointAfter(curve.places()[2]), 3U);
    EXPECT_EQ(curve.pointAfter(curve.places()[3] + 1), 4U);
}

TEST(SurfaceCurve, HasNothingToSurroundOnASheet)
{
    SurfaceCurve curve(makeSheet(9, 9).graph());
    curve.setPoints({VertexIndex(40)});
    EXPECT_TRUE(curve.vertices().empty());
    curve.insert(1, VertexIndex(43));
    EXPECT_TRUE(curve.vertices().empty());
    curve.insert(2, VertexIndex(70));
    EXPECT_GE(curve.vertices().size(), 3U);
}

TEST(SurfaceCurve, EditsLeaveThePiecesBeyondAlone)
{
    const auto graph = jittered(makeCapsule(24, 60), 0.02F, 3).graph();
    SurfaceCurve curve(graph);
    curve.setPoints({onTube(30, 0), onTube(31, 6), onTube(30, 12), onTube(29, 18)});
    const auto pieceFrom = [&](VertexIndex a, VertexIndex b) {
        const auto& v = curve.vertices();
        return std::vector<VertexIndex>(std::ranges::find(v, a), std::ranges::find(v, b));
    };
    const auto kept = pieceFrom(onTube(31, 6), onTube(30, 12));
    curve.move(3, onTube(34, 18));
    EXPECT_EQ(pieceFrom(onTube(31, 6), onTube(30, 12)), kept);
    EXPECT_TRUE(isSimpleLoop(*graph, curve.vertices()));
    EXPECT_TRUE(setOf(curve.vertices()).contains(onTube(34, 18)));
    curve.insert(1, onTube(32, 3));
    EXPECT_EQ(pieceFrom(onTube(31, 6), onTube(30, 12)), kept);
    EXPECT_EQ(curve.points().size(), 5U);
    curve.remove(1);
    curve.move(3, onTube(29, 18));
    SurfaceCurve fresh(graph);
    fresh.setPoints({onTube(30, 0), onTube(31, 6), onTube(30, 12), onTube(29, 18)});
    EXPECT_EQ(curve.vertices(), fresh.vertices());
    curve.remove(0);
    EXPECT_EQ(curve.points().front(), onTube(31, 6));
    EXPECT_TRUE(isSimpleLoop(*graph, curve.vertices()));
    while (!curve.points().empty())
        curve.remove(0);
    EXPECT_TRUE(curve.vertices().empty());
}

TEST(SurfaceCurve, GoesAroundOtherCurves)
{
    const auto graph = makeCapsule(24, 60).graph();
    SurfaceCurve curve(graph);
    const std::vector<VertexIndex> obstacles{onTube(30, 4), onTube(30, 5), onTube(29, 5), onTube(31, 5)};
    curve.setObstacles(obstacles);
    curve.setPoints({onTube(30, 0)});
    EXPECT_TRUE(isSimpleLoop(*graph, curve.vertices()));
    EXPECT_TRUE(separates(*graph, curve.vertices()));
    for (const VertexIndex v : obstacles)
        EXPECT_FALSE(setOf(curve.vertices()).contains(v));
}

TEST(SurfaceCurve, SaysWhatCannotBe)
{
    const auto graph = together(makeCapsule(24, 60), makeCapsule(6, 8)).graph();
    SurfaceCurve curve(graph);
    curve.setPoints({onTube(30, 0), onTube(30, 8), onTube(30, 16)});
    const auto before = curve.vertices();
    EXPECT_EQ(codeOf([&] { curve.move(1, VertexIndex(9999)); }), ErrorCode::CurveVertexOutside);
    EXPECT_EQ(codeOf([&] { curve.insert(2, onTube(30, 16)); }), ErrorCode::CurvePointTwice);
    curve.setObstacles(ring(24, 40));
    EXPECT_EQ(codeOf([&] { curve.move(0, onTube(40, 3)); }), ErrorCode::CurvePointTaken);
    // Beyond a closed curve, and on another component.
    EXPECT_EQ(codeOf([&] { curve.move(0, onTube(45, 3)); }), ErrorCode::CurveNoRoute);
    EXPECT_EQ(codeOf([&] { curve.move(0, VertexIndex(24 * 60 + 2 + 9)); }), ErrorCode::CurveNoRoute);
    EXPECT_EQ(curve.vertices(), before);
    EXPECT_EQ(curve.points()[0], onTube(30, 0));
}

TEST(SurfaceCurve, TakesUpWhatWasStored)
{
    const auto graph = makeCapsule(24, 60).graph();
    std::vector<VertexIndex> stored = ring(24, 30);
    SurfaceCurve curve(graph);
    const std::vector<VertexIndex> points{onTube(30, 20), onTube(30, 4), onTube(30, 11)};
    curve.restore(points, stored);
    EXPECT_EQ(curve.points(), points);
    EXPECT_EQ(setOf(curve.vertices()), setOf(stored));
    EXPECT_EQ(curve.vertices()[curve.places()[2]], points[2]);
    // Against its direction.
    curve.restore({onTube(30, 11), onTube(30, 4), onTube(30, 20)}, stored);
    EXPECT_EQ(curve.vertices()[1], onTube(30, 10));
    EXPECT_EQ(curve.vertices()[curve.places()[1]], onTube(30, 4));
    // One that passes elsewhere is led through its points.
    curve.restore({onTube(33, 11), onTube(33, 4), onTube(33, 20)}, stored);
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 33)));
    curve.restore({}, stored);
    EXPECT_EQ(curve.vertices(), stored);
    // One from another mesh, too.
    stored[3] = VertexIndex(40000);
    curve.restore(points, stored);
    EXPECT_EQ(setOf(curve.vertices()), setOf(ring(24, 30)));
    EXPECT_EQ(codeOf([&] { curve.restore({VertexIndex(40000)}, stored); }), ErrorCode::CurveVertexOutside);
    curve.restore({}, stored);
    EXPECT_TRUE(curve.vertices().empty());
}

TEST(SurfaceCurve, IsTheSameWhereverTheBodyStands)
{
    const Surface capsule = jittered(makeCapsule(24, 60), 0.03F, 9);
    Surface moved = capsule;
    const Eigen::Affine3f motion =
        Eigen::Translation3f(3, -1, 2) * Eigen::AngleAxisf(1.1F, Vec3f(1, 2, 3).normalized());
    for (Vec3f& p : moved.pose)
        p = motion * p;
    const std::vector<VertexIndex> points{onTube(30, 3), onTube(36, 11), onTube(28, 19)};
    SurfaceCurve here(capsule.graph());
    here.setPoints(points);
    SurfaceCurve there(moved.graph());
    there.setPoints(points);
    EXPECT_EQ(here.vertices(), there.vertices());
}

TEST(SurfaceCurve, DoesNotDependOnNumbers)
{
    const Surface capsule = jittered(makeCapsule(24, 60), 0.03F, 9);
    const auto places = shuffledPlaces(capsule.data.vertexCount, 4);
    SurfaceCurve here(capsule.graph());
    here.setPoints({onTube(30, 3), onTube(36, 11), onTube(28, 19)});
    SurfaceCurve there(renumbered(capsule, places).graph());
    std::vector<VertexIndex> points;
    for (const VertexIndex p : here.points())
        points.emplace_back(places[p.value]);
    there.setPoints(points);
    std::vector<VertexIndex> expected;
    for (const VertexIndex v : here.vertices())
        expected.emplace_back(places[v.value]);
    EXPECT_EQ(there.vertices(), expected);
}

TEST(SurfaceCurve, ClingsToCreases)
{
    // A ridge around the limb, one ring beside the straight way.
    const Surface ridged = makeTube(24, 41, 0.26F, [](std::uint32_t r) { return r == 21 ? 1.35F : 1.0F; });
    const auto onRidge = [&](double creases) {
        SurfaceCurve curve(ridged.graph(), {.creases = creases});
        curve.setPoints({onTube(21, 0), onTube(21, 9), onTube(21, 17)});
        return std::ranges::count_if(curve.vertices(), [](VertexIndex v) { return v.value / 24 == 21; });
    };
    EXPECT_EQ(onRidge(0.9), 24);
    EXPECT_LT(onRidge(0), 12);
}

TEST(SurfaceGraph, FindsTheNearestCrease)
{
    // A step of 90 degrees at column 6.
    Surface step = makeSheet(12, 8);
    for (Vec3f& p : step.pose)
        p = p.x() <= 6 ? p : Vec3f(6, 6 - p.x(), p.z());
    const auto graph = step.graph();
    EXPECT_EQ(nearestCrease(*graph, VertexIndex(3 * 12 + 4), 2.5), VertexIndex(3 * 12 + 6));
    EXPECT_EQ(nearestCrease(*graph, VertexIndex(3 * 12 + 4), 1.5), std::nullopt);
    EXPECT_EQ(nearestCrease(*graph, VertexIndex(3 * 12 + 6), 0), VertexIndex(3 * 12 + 6));
}

TEST(SurfaceGraph, FindsTheNearestCorner)
{
    const auto graph = makeSheet(3, 3).graph();
    // Triangle 0: vertices 0, 1 and 3.
    EXPECT_EQ(nearestVertex(*graph, TriangleIndex(0), {0.2F, 0.7F, 0.1F}), VertexIndex(1));
    EXPECT_EQ(nearestVertex(*graph, TriangleIndex(0), {0.2F, 0.1F, 0.7F}), VertexIndex(3));
}

/// Whatever is clicked on whatever mesh: what comes out is a simple loop through the points beside obstacles,
/// or an error that leaves everything as it was.
TEST(SurfaceCurve, KeepsItsPromisesUnderRandomEdits)
{
    std::mt19937 engine(17);
    const std::vector<Surface> surfaces{
        jittered(makeCapsule(9, 20), 0.1F, 1), jittered(makeTube(5, 30, 0.8F, 1), 0.15F, 2),
        jittered(makeTorus(9, 24, 3, 1), 0.1F, 3), jittered(makeSheet(15, 15), 0.3F, 4),
        together(jittered(makeCapsule(7, 15), 0.1F, 5), makeTube(3, 10, 1, 1))};
    std::size_t closed = 0;
    for (const Surface& surface : surfaces) {
        const auto graph = surface.graph();
        const auto any = [&] { return VertexIndex(engine() % graph->vertexCount()); };
        SurfaceCurve curve(graph);
        for (int edit = 0; edit < 60; ++edit) {
            std::vector<VertexIndex> obstacles;
            for (int i = 0; i < 5; ++i)
                obstacles.push_back(any());
            for (const VertexIndex v : curve.vertices())
                std::erase(obstacles, v);
            for (const VertexIndex v : curve.points())
                std::erase(obstacles, v);
            curve.setObstacles(obstacles);
            const auto points = curve.points();
            const auto before = curve.vertices();
            try {
                const std::size_t which = points.empty() ? 0 : engine() % points.size();
                if (points.size() < 3 || (points.size() < 7 && engine() % 3 == 0))
                    curve.insert(which, any());
                else if (engine() % 3 == 0)
                    curve.remove(which);
                else
                    curve.move(which, any());
            } catch (const Error&) {
                EXPECT_EQ(curve.points(), points);
                EXPECT_EQ(curve.vertices(), before);
                continue;
            }
            if (curve.vertices().empty()) {
                EXPECT_LT(curve.points().size(), 3U);
                continue;
            }
            ++closed;
            ASSERT_TRUE(isSimpleLoop(*graph, curve.vertices()));
            for (std::size_t i = 0; i < curve.points().size(); ++i)
                ASSERT_EQ(curve.vertices()[curve.places()[i]], curve.points()[i]);
            for (const VertexIndex v : obstacles)
                ASSERT_FALSE(setOf(curve.vertices()).contains(v));
        }
    }
    EXPECT_GT(closed, 150U);
}

} // namespace
} // namespace quadrille
