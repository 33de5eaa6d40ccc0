// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/surfacevolume.h"
#include "tests/model/transition/bars.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace quadrille;

namespace {

const std::vector<Vec3f> cubeCorners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

std::vector<Triangle> cubeTriangles()
{
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c, d] :
         {std::array{0, 3, 2, 1}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4}, std::array{2, 3, 7, 6},
          std::array{1, 2, 6, 5}, std::array{0, 4, 7, 3}}) {
        triangles.push_back({VertexIndex(a), VertexIndex(b), VertexIndex(c)});
        triangles.push_back({VertexIndex(a), VertexIndex(c), VertexIndex(d)});
    }
    return triangles;
}

std::optional<double> volumeOf(std::vector<Triangle> triangles, const std::vector<Vec3f>& pose)
{
    const Topology topology(
        {.vertexCount = static_cast<std::uint32_t>(pose.size()), .triangles = std::move(triangles)});
    return SurfaceVolume(topology).of(pose);
}

} // namespace

TEST(SurfaceVolume, OfACubeIsItsOwnWhereverItIs)
{
    for (const Vec3f& shift : {Vec3f(0, 0, 0), Vec3f(-30, 2, 8)}) {
        std::vector<Vec3f> pose = cubeCorners;
        for (Vec3f& corner : pose)
            corner = 2 * corner + shift;
        EXPECT_NEAR(volumeOf(cubeTriangles(), pose).value(), 8, 1e-5);
    }
}

TEST(SurfaceVolume, IsNegativeInsideOut)
{
    std::vector<Triangle> triangles = cubeTriangles();
    for (Triangle& triangle : triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(volumeOf(triangles, cubeCorners).value(), -1, 1e-12);
}

TEST(SurfaceVolume, OfAScaledBodyGrowsByTheThirdPower)
{
    const Bar bar = makeBar(11, 2, 1.0F, 0.2F);
    const double before = SurfaceVolume(*bar.topology).of(bar.positions).value();
    EXPECT_NEAR(before, 0.04, 1e-7);
    const std::vector<Vec3f> larger = moved(bar.positions, [](const Vec3d& p) -> Vec3d { return 1.5 * p; });
    EXPECT_NEAR(SurfaceVolume(*bar.topology).of(larger).value(), 1.5 * 1.5 * 1.5 * before, 1e-7);
}

// Lids are flat, so that the fans close them as they were.
TEST(SurfaceVolume, ClosesOpenings)
{
    std::vector<Triangle> box = cubeTriangles();
    box.erase(box.begin() + 2, box.begin() + 4);
    EXPECT_NEAR(volumeOf(box, cubeCorners).value(), 1, 1e-12);
    // The opposite side opened too, then all but two sides that have no rim in common.
    box.erase(box.begin(), box.begin() + 2);
    EXPECT_NEAR(volumeOf(box, cubeCorners).value(), 1, 1e-12);
    const Bar tube = makeBar(11, 2, 1.0F, 0.2F, false, 2);
    EXPECT_NEAR(SurfaceVolume(*tube.topology).of(tube.positions).value(), 0.08, 1e-7);
}

TEST(SurfaceVolume, IsNotAvailableWhereThereIsNoInside)
{
    std::vector<Triangle> fin = cubeTriangles();
    fin.push_back({VertexIndex(0U), VertexIndex(1U), VertexIndex(6U)});
    EXPECT_FALSE(volumeOf(fin, cubeCorners).has_value());
    std::vector<Triangle> turned = cubeTriangles();
    std::swap(turned[0][0], turned[0][1]);
    EXPECT_FALSE(volumeOf(turned, cubeCorners).has_value());
}
