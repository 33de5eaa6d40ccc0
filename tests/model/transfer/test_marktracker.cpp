// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/transfer/transferfixture.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A bar whose far end is twisted about x by an angle, as a screw.
std::vector<Vec3f> twisted(const Bar& bar, double angle)
{
    return moved(bar.positions, [angle](const Vec3d& p) -> Vec3d {
        return Eigen::AngleAxisd(angle * p.x(), Vec3d::UnitX()) * p;
    });
}

std::vector<Vec3f> turnedBar(const Bar& bar, double angle)
{
    return moved(bar.positions, [angle](const Vec3d& p) -> Vec3d {
        return Eigen::AngleAxisd(angle, Vec3d(1, 2, 3).normalized()) * p;
    });
}

} // namespace

TEST(MarkTracker, TellsRotationsSinceTheReference)
{
    const Bar bar = makeBar(5, 2, 1.0F, 0.3F);
    const std::vector<TriangleIndex> marks = everyTriangle(*bar.topology, 5);
    MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
    const Eigen::Quaterniond expected(Eigen::AngleAxisd(0.7, Vec3d(1, 2, 3).normalized()));
    const MarkDeformations now = tracker.next(turnedBar(bar, 0.7));
    for (const Eigen::Quaterniond& q : now.rotations)
        EXPECT_LT(q.angularDistance(expected), 1e-6);
    EXPECT_LT(now.root.angularDistance(expected), 1e-6);
}

TEST(MarkTracker, KeepsSignsThroughFullTurnsOfTheBody)
{
    const Bar bar = makeBar(5, 2, 1.0F, 0.3F);
    const std::vector<TriangleIndex> marks = everyTriangle(*bar.topology, 5);
    MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
    MarkDeformations before = tracker.next(bar.positions);
    for (int step = 1; step <= 80; ++step) {
        const MarkDeformations now = tracker.next(turnedBar(bar, step * 10 * degree));
        for (std::size_t m = 0; m < marks.size(); ++m) {
            EXPECT_GT(now.rotations[m].dot(before.rotations[m]), 0.99) << step;
            EXPECT_GT(now.rotations[m].dot(now.root), 0.99) << step;
        }
        before = now;
    }
}

TEST(MarkTracker, FirstSignsGoTogetherWhereNeighboursTurnAlike)
{
    // The far end is turned by 280 degrees already: no mark is opposite to the next one along the bar.
    const Bar bar = makeBar(29, 2, 1.0F, 0.3F);
    std::vector<TriangleIndex> marks;
    for (std::size_t ring = 0; ring < 28; ++ring)
        marks.emplace_back(16 * ring);
    MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
    const MarkDeformations now = tracker.next(twisted(bar, 280 * degree));
    for (std::size_t m = 1; m < marks.size(); ++m)
        EXPECT_GT(now.rotations[m].dot(now.rotations[m - 1]), 0.9) << m;
}

TEST(MarkTracker, TrianglesWithoutAnAreaTurnWithTheBody)
{
    Bar bar = makeBar(5, 2, 1.0F, 0.3F);
    const Triangle flat = bar.topology->triangles()[10];
    bar.positions[flat[0].value] = bar.positions[flat[1].value];
    const std::vector<TriangleIndex> marks{TriangleIndex(3), TriangleIndex(10), TriangleIndex(50)};
    MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
    const MarkDeformations now = tracker.next(turnedBar(bar, 0.7));
    EXPECT_LT(now.rotations[1].angularDistance(now.rotations[0]), 1e-5);
    EXPECT_GT(now.rotations[1].dot(now.rotations[2]), 0);
}
