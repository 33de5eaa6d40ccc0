// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/triangleframes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>

using namespace quadrille;

namespace {

Triangle triangle(int a, int b, int c)
{
    return {VertexIndex(a), VertexIndex(b), VertexIndex(c)};
}

} // namespace

TEST(TriangleFrames, GiveTheEdgesBack)
{
    std::mt19937 engine(3);
    std::normal_distribution<float> normal;
    std::vector<Vec3f> positions;
    std::vector<Triangle> triangles;
    for (int t = 0; t < 300; ++t) {
        for (int corner = 0; corner < 3; ++corner)
            positions.emplace_back(normal(engine), normal(engine), normal(engine));
        triangles.push_back(triangle(3 * t, 3 * t + 1, 3 * t + 2));
    }
    // Half turns about the axes, where components of the quaternion vanish.
    for (const Vec3f& axis : {Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1)}) {
        const auto first = static_cast<int>(positions.size());
        for (const Vec3f& p : {Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 0)})
            positions.push_back(Eigen::AngleAxisf(static_cast<float>(M_PI), axis) * p);
        triangles.push_back(triangle(first, first + 1, first + 2));
    }
    const std::vector<CornerSlice> corners = cornerSlices(triangles);
    ASSERT_EQ(corners.size(), 3U);
    EXPECT_EQ(corners[2].count, 303U - 256U);
    const auto slice = std::make_unique<TriangleSlice>();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (t % sliceTriangles == 0)
            fillTriangleSlice(positions, corners[t / sliceTriangles], *slice);
        const std::size_t k = t % sliceTriangles;
        const Eigen::Quaternionf q(slice->quaternion[0][k], slice->quaternion[1][k], slice->quaternion[2][k],
                                   slice->quaternion[3][k]);
        EXPECT_NEAR(q.norm(), 1, 2e-7F);
        const Vec3f& origin = positions[triangles[t][2].value];
        const Vec3f a = positions[triangles[t][0].value] - origin;
        const Vec3f b = positions[triangles[t][1].value] - origin;
        EXPECT_LT((q * Vec3f(slice->b11[k], 0, 0) - a).norm(), 2e-6F * a.norm()) << t;
        EXPECT_LT((q * Vec3f(slice->b12[k], slice->b22[k], 0) - b).norm(), 2e-6F * b.norm()) << t;
        EXPECT_GT(slice->b22[k], 0);
        EXPECT_NEAR(slice->logArea[k], std::log(a.cast<double>().cross(b.cast<double>()).norm()), 1e-6) << t;
    }
    for (std::size_t k = corners[2].count; k < sliceTriangles; ++k) {
        EXPECT_EQ(slice->quaternion[0][k], 0);
        EXPECT_EQ(slice->b11[k], 1);
        EXPECT_EQ(slice->b12[k], 0);
        EXPECT_EQ(slice->b22[k], 1);
        EXPECT_EQ(slice->logArea[k], 0);
    }
}

TEST(TriangleFrames, TriangleWithoutAreaIsMarked)
{
    // The squared bounding diagonal is 2, so that areas below 2e-12 do not count.
    const std::vector<Vec3f> positions{{0, 0, 0},    {1, 0, 0},        {0, 1, 0},
                                       {0.5F, 0, 0}, {1, 3.9e-12F, 0}, {1, 4.1e-12F, 0}};
    const std::vector<Triangle> triangles{triangle(0, 1, 2), triangle(0, 1, 3), triangle(0, 1, 4),
                                          triangle(0, 1, 5), triangle(2, 2, 1)};
    std::vector<std::uint8_t> marks{0, 0, 0, 0, 0};
    markDegenerate(positions, triangles, marks);
    EXPECT_EQ(marks, (std::vector<std::uint8_t>{0, 1, 1, 0, 1}));

    // Marks stay from frame to frame; in a pose that is one point no triangle has an area.
    marks = {1, 0, 0, 0, 0};
    markDegenerate(positions, triangles, marks);
    EXPECT_EQ(marks, (std::vector<std::uint8_t>{1, 1, 1, 0, 1}));
    markDegenerate(std::vector<Vec3f>(6, Vec3f(1, 1, 1)), triangles, marks);
    EXPECT_EQ(marks, std::vector<std::uint8_t>(5, 1));
}
