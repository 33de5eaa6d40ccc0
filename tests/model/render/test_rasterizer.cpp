// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/rasterizer.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::uint32_t triangleAt(const RasterBuffers& buffers, int x, int y)
{
    return buffers.triangles[static_cast<std::size_t>(y * buffers.width + x)];
}

float depthAt(const RasterBuffers& buffers, int x, int y)
{
    return buffers.depths[static_cast<std::size_t>(y * buffers.width + x)];
}

RasterBuffers draw(const Mesh& mesh, int size, bool barycentrics = false)
{
    return rasterize(mesh.positions, mesh.triangles, unitCamera(size / 2.0), size, size, barycentrics);
}

std::int64_t coveredCount(const RasterBuffers& buffers)
{
    return std::count_if(buffers.triangles.begin(), buffers.triangles.end(),
                         [](std::uint32_t t) { return t != noTriangle; });
}

/// A random triangle soup around the middle of a picture, some of it behind the eye.
Mesh soup(int count)
{
    std::mt19937 random(7);
    const auto coordinate = [&random](float reach) {
        return (static_cast<float>(random() % 20001U) / 10000.0F - 1) * reach;
    };
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3f middle(coordinate(90), coordinate(90), coordinate(120));
        const auto corner = [&] {
            return Vec3f(middle + Vec3f(coordinate(15), coordinate(15), coordinate(15)));
        };
        const Vec3f a = corner();
        const Vec3f b = corner();
        mesh.add(a, b, corner());
    }
    return mesh;
}

} // namespace

TEST(Rasterizer, CoversExactlyTheSamplesInsideAQuad)
{
    const auto quad = quadPositions(-4, -3, 2, 5);
    const auto topology = quadTopology();
    const auto buffers = rasterize(quad, topology.triangles, unitCamera(8), 16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            const bool inside = x >= 4 && x < 10 && y >= 3 && y < 11;
            EXPECT_EQ(triangleAt(buffers, x, y) != noTriangle, inside) << x << ", " << y;
            if (inside)
                EXPECT_NEAR(depthAt(buffers, x, y), 8, 1e-5); // rounding of float
            else
                EXPECT_TRUE(std::isinf(depthAt(buffers, x, y)));
        }
    }
}

TEST(Rasterizer, GivesSamplesOnEdgesToTopAndLeft)
{
    // Edges run through the middles of samples: those on the top and left edge belong to the quad.
    const auto quad = quadPositions(-3.5F, -2.5F, 1.5F, 2.5F);
    const auto topology = quadTopology();
    const auto buffers = rasterize(quad, topology.triangles, unitCamera(8), 16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(triangleAt(buffers, x, y) != noTriangle, x >= 4 && x < 9 && y >= 5 && y < 10)
                << x << ", " << y;
    }
}

TEST(Rasterizer, LeavesNeitherGapsNorDoublesOnSharedEdges)
{
    // A fan around a point, its rim the picture's border: each sample belongs to exactly one triangle.
    constexpr int size = 96;
    constexpr int parts = 37;
    const auto rim = [](int i) {
        const auto [sine, cosine] = sineCosine(static_cast<double>(i % parts) / parts);
        return Vec3f(Vec3d(100 * cosine, 100 * sine, 0).cast<float>());
    };
    std::vector<int> counts(size * size, 0);
    for (int i = 0; i < parts; ++i) {
        Mesh one;
        const Vec3f middle(3.3F, -5.7F, 0);
        // Alternate windings: both sides are drawn, and the rule must hold between them.
        if (i % 2 == 0)
            one.add(middle, rim(i), rim(i + 1));
        else
            one.add(rim(i + 1), rim(i), middle);
        const auto buffers = draw(one, size);
        for (std::size_t s = 0; s < counts.size(); ++s)
            counts[s] += buffers.triangles[s] != noTriangle;
    }
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), size * size);
}

TEST(Rasterizer, LeavesNeitherGapsNorDoublesWhereTrianglesAreCut)
{
    // A floor that runs under the eye, cut at the near distance, as strips that share edges.
    constexpr int size = 64;
    const Camera camera = unitCamera(32);
    const auto strip = [](float from, float to) {
        Mesh mesh;
        mesh.add({from, -3, -400}, {to, -3, -400}, {to * 0.7F + 1, -3, 200});
        mesh.add({from, -3, -400}, {to * 0.7F + 1, -3, 200}, {from * 0.7F + 1, -3, 200});
        return mesh;
    };
    std::vector<int> counts(size * size, 0);
    Mesh all;
    for (float x = -2000; x < 2000; x += 80) {
        const Mesh part = strip(x, x + 80);
        for (std::size_t t = 0; t < 2; ++t) {
            const std::vector<Triangle> one = {part.triangles[t]};
            const auto buffers = rasterize(part.positions, one, camera, size, size);
            for (std::size_t s = 0; s < counts.size(); ++s)
                counts[s] += buffers.triangles[s] != noTriangle;
        }
    }
    // The floor fills everything from a little below the horizon (row 32) to the bottom.
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int count = counts[static_cast<std::size_t>(y * size + x)];
            EXPECT_EQ(count, y >= 33 ? 1 : count > 0 ? 1 : 0) << x << ", " << y;
        }
    }
}

TEST(Rasterizer, ShowsTheNearestTriangleWhateverTheOrder)
{
    Mesh mesh;
    mesh.add({-20, -20, 0}, {20, -20, 0}, {0, 20, 0});
    mesh.add({-20, -20, 2}, {20, -20, 2}, {0, 20, 2});
    mesh.add({-20, -20, 1}, {20, -20, 1}, {0, 20, 1});
    const auto buffers = draw(mesh, 16);
    EXPECT_EQ(triangleAt(buffers, 8, 8), 1U);
    EXPECT_NEAR(depthAt(buffers, 8, 8), 6, 1e-5);
}

TEST(Rasterizer, ShowsTheFirstOfTrianglesAtTheSameDepth)
{
    Mesh mesh;
    for (int i = 0; i < 3; ++i)
        mesh.add({-20, -20, 0}, {20, -20, 0}, {0, 20, 0});
    EXPECT_EQ(triangleAt(draw(mesh, 16), 8, 8), 0U);
}

TEST(Rasterizer, IntersectsPlanesWhereTheyMeet)
{
    // Two planes through the y axis, tilted against each other: left of it one is in front, right the other.
    Mesh mesh;
    mesh.add({-6, -30, -3}, {6, -30, 3}, {0, 30, 0});
    mesh.add({-6, -30, 3}, {6, -30, -3}, {0, 30, 0});
    const auto buffers = draw(mesh, 16);
    EXPECT_EQ(triangleAt(buffers, 6, 8), 1U);
    EXPECT_EQ(triangleAt(buffers, 9, 8), 0U);
}

TEST(Rasterizer, InterpolatesOnTheSurfaceNotInThePicture)
{
    // The floor point in the middle of sample (8, 12) of the unit picture: ray (½, −4½, −8), floor at −3.
    Mesh mesh;
    mesh.add({-10, -3, 6}, {10, -3, 6}, {0, -3, -100});
    const auto buffers = draw(mesh, 16, true);
    ASSERT_EQ(triangleAt(buffers, 8, 12), 0U);
    const double depth = 8 * 3 / 4.5;
    EXPECT_NEAR(depthAt(buffers, 8, 12), depth, 0.01); // the grid of 1/256 sample moves the corners
    const Vec2f weights = buffers.barycentrics[12 * 16 + 8];
    const Vec3f point = mesh.positions[0] * (1 - weights.sum()) + mesh.positions[1] * weights.x() +
                        mesh.positions[2] * weights.y();
    EXPECT_NEAR(point.x(), 0.5 * depth / 8, 0.02);
    EXPECT_NEAR(point.z(), 8 - depth, 0.02);
}

TEST(Rasterizer, CutsAtTheNearDistanceAndKeepsWeights)
{
    // A floor from behind the eye to far ahead: the cut part must not be mirrored, and weights must still
    // give the point that the ray meets.
    Mesh mesh;
    mesh.add({-500, -3, 100}, {500, -3, 100}, {0, -3, -300});
    const auto buffers = draw(mesh, 16, true);
    EXPECT_EQ(triangleAt(buffers, 8, 4), noTriangle);
    ASSERT_EQ(triangleAt(buffers, 8, 15), 0U);
    const Vec2f weights = buffers.barycentrics[15 * 16 + 8];
    const Vec3f point = mesh.positions[0] * (1 - weights.sum()) + mesh.positions[1] * weights.x() +
                        mesh.positions[2] * weights.y();
    const double depth = 8 * 3 / 7.5;
    EXPECT_NEAR(depthAt(buffers, 8, 15), depth, 0.02);
    EXPECT_NEAR(point.y(), -3, 1e-3);
    EXPECT_NEAR(point.z(), 8 - depth, 0.05);
}

TEST(Rasterizer, LeavesOutWhatIsTooNearOrTooFar)
{
    Camera camera = unitCamera(8);
    camera.farDistance = 10;
    Mesh mesh;
    mesh.add({-20, -20, 7.8F}, {20, -20, 7.8F}, {0, 20, 7.8F});
    mesh.add({-90, -90, -3}, {90, -90, -3}, {0, 90, -3});
    EXPECT_EQ(coveredCount(rasterize(mesh.positions, mesh.triangles, camera, 16, 16)), 0);
    camera.farDistance = 12;
    EXPECT_EQ(coveredCount(rasterize(mesh.positions, mesh.triangles, camera, 16, 16)), 256);
}

TEST(Rasterizer, DrawsNothingForTrianglesWithoutArea)
{
    Mesh mesh;
    mesh.add({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    mesh.add({-5, -5, 0}, {0, 0, 0}, {5, 5, 0});
    mesh.add({0, 0, 8}, {0, 0, 8}, {1, 0, 8}); // through the eye
    const auto buffers = draw(mesh, 16, true);
    EXPECT_EQ(coveredCount(buffers), 0);
    EXPECT_EQ(coveredCount(draw({}, 16)), 0);
}

TEST(Rasterizer, SurvivesEnormousCoordinates)
{
    Mesh mesh;
    mesh.add({-1e9F, -1e9F, 0}, {1e9F, -1e9F, 0}, {0, 1e9F, 0});
    mesh.add({-1e30F, -1e30F, -1}, {1e30F, -1e30F, -1}, {0, 1e30F, -1});
    const auto buffers = draw(mesh, 16, true);
    EXPECT_EQ(coveredCount(buffers), 256);
    for (const Vec2f& weights : buffers.barycentrics)
        EXPECT_TRUE(weights.allFinite());
}

TEST(Rasterizer, GivesTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = soup(8000);
    const auto drawWith = [&mesh](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return draw(mesh, 200, true);
    };
    const auto one = drawWith(1);
    const auto four = drawWith(4);
    EXPECT_GT(coveredCount(one), 20000);
    EXPECT_EQ(one.triangles, four.triangles);
    EXPECT_EQ(one.depths, four.depths);
    EXPECT_EQ(one.barycentrics, four.barycentrics);
}
