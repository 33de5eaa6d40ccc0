// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "sampletest.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

/// 1 for an equilateral triangle, 0 for a degenerate one.
double quality(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
    const double area = 0.5 * static_cast<double>((b - a).cross(c - a).norm());
    const double edges =
        static_cast<double>((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
    return 4 * std::sqrt(3.0) * area / edges;
}

void expectClosedHumanoid(const SampleBody& body, std::uint32_t least, std::uint32_t most)
{
    const TopologyStatistics& s = body.topology->statistics();
    EXPECT_EQ(s.components, 1);
    EXPECT_EQ(s.eulerCharacteristic, 2);
    EXPECT_TRUE(s.isClosed());
    EXPECT_EQ(s.nonManifoldVertices, 0);
    EXPECT_EQ(s.unusedVertices, 0);
    EXPECT_GE(body.topology->vertexCount(), least);
    EXPECT_LE(body.topology->vertexCount(), most);
    EXPECT_GT(signedVolume(*body.topology, body.rest), 0.04); // cubic metres: a grown-up, and not inside out
    EXPECT_LT(signedVolume(*body.topology, body.rest), 0.15);
}

TEST(SampleBody, charactersAreClosedSurfacesOfGenusZero)
{
    expectClosedHumanoid(smallSample().body, 2800, 3400);
    expectClosedHumanoid(smallSample().target, 2500, 5000);
    EXPECT_NE(smallSample().body.topology->vertexCount(), smallSample().target.topology->vertexCount());
}

TEST(SampleBody, trianglesAreWellShapedAtRest)
{
    for (const SampleBody* body : {&smallSample().body, &smallSample().target}) {
        std::vector<double> qualities;
        for (const Triangle& t : body->topology->triangles())
            qualities.push_back(
                quality(body->rest[t[0].value], body->rest[t[1].value], body->rest[t[2].value]));
        std::sort(qualities.begin(), qualities.end());
        EXPECT_GT(qualities.front(), 0.1);
        EXPECT_GT(qualities[qualities.size() / 20], 0.75);
        EXPECT_GT(qualities[qualities.size() / 2], 0.93);
    }
}

TEST(SampleBody, isSymmetric)
{
    const std::vector<Vec3f>& rest = smallSample().body.rest;
    for (std::size_t v = 0; v < rest.size(); v += 7) {
        const Vec3f mirrored(-rest[v].x(), rest[v].y(), rest[v].z());
        EXPECT_TRUE(std::any_of(rest.begin(), rest.end(),
                                [&](const Vec3f& p) {
                                    return (p - mirrored).norm() < 1e-6F; // rounding to float
                                }))
            << "vertex " << v;
    }
}

TEST(SampleBody, standsOnTheGroundFacingForwards)
{
    const std::vector<Vec3f>& rest = smallSample().body.rest;
    float low = 1;
    float high = 0;
    for (const Vec3f& p : rest) {
        low = std::min(low, p.y());
        high = std::max(high, p.y());
    }
    EXPECT_NEAR(low, 0, 0.006); // the rounded edge of the sole
    EXPECT_NEAR(high, 1.75, 0.02);
    const Skeleton& skeleton = smallSample().skeleton;
    EXPECT_GT(skeleton.rest[skeleton.index("leftToes")].z(), skeleton.rest[skeleton.index("leftFoot")].z());
    EXPECT_GT(skeleton.rest[skeleton.index("leftHand")].x(), 0);
}

/// Counts texels whose centre lies in more than one triangle, and those covered at all.
std::pair<int, int> doublyCovered(const Topology& topology, int size)
{
    std::vector<std::uint8_t> covered(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const TopologyData& data = topology.data();
    for (const auto& corners : data.triangleUvs) {
        std::array<Eigen::Vector2d, 3> p;
        for (std::size_t c = 0; c < 3; ++c)
            p[c] = data.uvs[corners[c]].cast<double>() * size;
        const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
            return a.x() * b.y() - a.y() * b.x();
        };
        const int x0 = static_cast<int>(std::min({p[0].x(), p[1].x(), p[2].x()}));
        const int x1 = static_cast<int>(std::max({p[0].x(), p[1].x(), p[2].x()}));
        const int y0 = static_cast<int>(std::min({p[0].y(), p[1].y(), p[2].y()}));
        const int y1 = static_cast<int>(std::max({p[0].y(), p[1].y(), p[2].y()}));
        for (int y = y0; y <= std::min(y1, size - 1); ++y)
            for (int x = x0; x <= std::min(x1, size - 1); ++x) {
                const Eigen::Vector2d q(x + 0.5, y + 0.5);
                // A hair inside, so that an edge shared by two triangles counts for neither.
                bool isInside = true;
                for (std::size_t c = 0; c < 3; ++c)
                    isInside = isInside && cross(p[(c + 1) % 3] - p[c], q - p[c]) > 1e-9;
                if (isInside)
                    ++covered[static_cast<std::size_t>(y * size + x)];
            }
    }
    const auto atLeast = [&](int times) {
        return static_cast<int>(
            std::count_if(covered.begin(), covered.end(), [times](std::uint8_t n) { return n >= times; }));
    };
    return {atLeast(2), atLeast(1)};
}

TEST(SampleBody, chartsLieInTheSquareAndNeverOverlap)
{
    for (const SampleBody* body : {&smallSample().body, &smallSample().target}) {
        const TopologyData& data = body->topology->data();
        for (const Vec2f& uv : data.uvs) {
            EXPECT_GE(uv.minCoeff(), 0.0F);
            EXPECT_LE(uv.maxCoeff(), 1.0F);
        }
        for (const auto& c : data.triangleUvs) {
            const Vec2f a = data.uvs[c[1]] - data.uvs[c[0]];
            const Vec2f b = data.uvs[c[2]] - data.uvs[c[0]];
            EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0.0F);
        }
        const auto [twice, once] = doublyCovered(*body->topology, 1024);
        EXPECT_EQ(twice, 0);
        EXPECT_GT(once, 1024 * 1024 * 4 / 10); // the space is used
    }
}

TEST(SampleBody, everyChartIsADisk)
{
    for (const SampleBody* body : {&smallSample().body, &smallSample().target}) {
        // In the plane of the texture charts are apart, and each is there whole.
        TopologyData flat;
        flat.vertexCount = static_cast<std::uint32_t>(body->topology->data().uvs.size());
        for (const auto& c : body->topology->data().triangleUvs)
            flat.triangles.push_back({VertexIndex(c[0]), VertexIndex(c[1]), VertexIndex(c[2])});
        const Topology charts(flat);
        const std::int64_t count = charts.statistics().components;
        EXPECT_GE(count, 15);
        EXPECT_LE(count, 40);
        EXPECT_EQ(charts.statistics().unusedVertices, 0);
        EXPECT_EQ(charts.statistics().nonManifoldVertices, 0);
        // None has an Euler characteristic above 1, as all have a boundary; one boundary each: no holes.
        EXPECT_EQ(charts.statistics().eulerCharacteristic, count);
        EXPECT_EQ(charts.statistics().boundaryLoops, count);
    }
}

TEST(SampleBody, textureHasDetailAllOver)
{
    // Neighbouring texels inside charts differ: there is something to track everywhere.
    const SampleCharacter large = makeSampleCharacter({.textureSize = 512, .takesPerKind = 1});
    const Image& image = *large.body.texture;
    int same = 0;
    int all = 0;
    for (const auto& corners : large.body.topology->data().triangleUvs) {
        const std::vector<Vec2f>& uvs = large.body.topology->data().uvs;
        const Vec2f uv = (uvs[corners[0]] + uvs[corners[1]] + uvs[corners[2]]) / 3;
        const int x = static_cast<int>(uv.x() * 511);
        const int y = static_cast<int>((1 - uv.y()) * 511);
        int least = 255;
        int most = 0;
        for (int dx = -2; dx <= 2; ++dx) {
            const int value = image.pixel(std::clamp(x + dx, 0, 511), y)[1];
            least = std::min(least, value);
            most = std::max(most, value);
        }
        same += most - least < 2;
        ++all;
    }
    EXPECT_LT(same, all / 20);
}

TEST(SampleBody, refusesOptionsOutOfRange)
{
    EXPECT_THROW(makeSampleCharacter({.textureSize = 3}), Error);
    EXPECT_THROW(makeSampleCharacter({.textureSize = 96}), Error); // does not divide the shipped one
    EXPECT_THROW(makeSampleCharacter({.textureSize = 2048}), Error);
    EXPECT_THROW(makeSampleCharacter({.takesPerKind = 0}), Error);
}

TEST(SampleBody, makingItCanBeCancelled)
{
    CancelToken token;
    const Progress progress(token, [&token](double fraction) {
        if (fraction > 0.05)
            token.cancel();
    });
    try {
        makeSampleCharacter({.textureSize = 128}, progress);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
}

} // namespace
} // namespace quadrille
