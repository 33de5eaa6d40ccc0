// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/constraints.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

double greatestStep(const std::vector<Vec3d>& points)
{
    double greatest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        greatest = std::max(greatest, (points[i] - points[i - 1]).norm());
    return greatest;
}

bool passes(const std::vector<Vec3d>& points, const Vec3d& point)
{
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3d& p) { return (p - point).norm() < 1e-9; });
}

TEST(SampleCurve, PassesThroughAllPointsInSmallSteps)
{
    const std::vector<Vec3d> through{{0, 0, 0}, {1, 0, 0}, {1.1, 0.1, 0}, {3, 4, 1}, {0, 5, 0}};
    const std::vector<Vec3d> points = sampleCurve(through, 0.05);
    EXPECT_LE(greatestStep(points), 0.05);
    for (const Vec3d& point : through)
        EXPECT_TRUE(passes(points, point)) << point.transpose();
    EXPECT_EQ(points.front(), through.front());
    EXPECT_NEAR((points.back() - through.back()).norm(), 0, 1e-12);
    // No kink: neighbouring steps of a fine sampling point the same way.
    const std::vector<Vec3d> fine = sampleCurve(through, 0.001);
    for (std::size_t i = 2; i < fine.size(); ++i)
        EXPECT_GT((fine[i] - fine[i - 1]).normalized().dot((fine[i - 1] - fine[i - 2]).normalized()), 0.99);
}

TEST(SampleCurve, IsStraightBetweenPointsOnALine)
{
    const std::vector<Vec3d> points = sampleCurve({{0, 0, 1}, {1, 0, 1}, {1, 0, 1}, {4, 0, 1}}, 0.1);
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_NEAR(points[i].y(), 0, 1e-12);
        EXPECT_NEAR(points[i].z(), 1, 1e-12);
        EXPECT_GT(points[i].x(), points[i - 1].x());
    }
}

TEST(SampleCurve, ClosesWithoutAKink)
{
    const std::vector<Vec3d> corners{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const std::vector<Vec3d> points = sampleCurve(corners, 0.001, true);
    EXPECT_NEAR((points.back() - points.front()).norm(), 0, 1e-12);
    const Vec3d first = (points[1] - points[0]).normalized();
    const Vec3d last = (points.back() - points[points.size() - 2]).normalized();
    EXPECT_GT(first.dot(last), 0.999);
}

TEST(SampleCurve, KeepsWhatIsNoCurve)
{
    EXPECT_TRUE(sampleCurve({}, 0.1).empty());
    EXPECT_EQ(sampleCurve({{1, 2, 3}, {1, 2, 3}}, 0.1).size(), 1U);
}

TEST(SampleBezier, FollowsItsHandles)
{
    const std::vector<Vec3d> points = sampleBezier({0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, 0.01);
    EXPECT_LE(greatestStep(points), 0.01);
    EXPECT_TRUE(passes(points, {0, 0, 0}));
    EXPECT_TRUE(passes(points, {1, 0, 0}));
    double highest = 0;
    for (const Vec3d& point : points)
        highest = std::max(highest, point.y());
    EXPECT_NEAR(highest, 0.75, 1e-4); // t = ½: (0 + 3 + 3 + 0) / 8
}

} // namespace
} // namespace quadrille
