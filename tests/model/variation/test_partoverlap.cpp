// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/parts/partoverlap.h"
#include "tests/model/variation/handmadeparts.h"
#include "tests/model/variation/plainstitching.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The overlap of the left part of a bar with its trunk, and the places of its vertices.
struct Band
{
    PartedBar parted;
    PartOverlap overlap;
    std::vector<Vec3f> places;

    explicit Band(int rings = 31, int side = 3, int width = 6)
        : parted(rings, side, 2.0F, 0.3F, true, width)
        , overlap(*parted.bar.topology, parted.parts.parts[1], parted.bar.positions)
    {
        for (const VertexIndex v : parted.parts.parts[1].overlap)
            places.push_back(parted.bar.positions[v.value]);
    }
    double costOf(std::span<const std::uint32_t> seam, std::span<const double> costs) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < seam.size(); ++i) {
            const std::uint32_t a = seam[i];
            const std::uint32_t b = seam[(i + 1) % seam.size()];
            double cost = 1e300;
            for (std::size_t e = 0; e < overlap.edgeCount(); ++e) {
                if (overlap.endsOf(e) == std::array{std::min(a, b), std::max(a, b)})
                    cost = costs[e];
            }
            sum += cost;
        }
        return sum;
    }
    std::set<float> ringsOf(std::span<const std::uint32_t> seam) const
    {
        std::set<float> rings;
        for (const std::uint32_t v : seam)
            rings.insert(places[v].x());
        return rings;
    }
};

} // namespace

TEST(PartOverlap, FindsTheCheapestCurveOfAll)
{
    const Band band;
    std::mt19937 random(1);
    std::vector<double> costs(band.overlap.edgeCount());
    for (int trial = 0; trial < 100; ++trial) {
        // Even costs lead straight around, wild ones to and fro over the cut.
        std::uniform_real_distribution<double> spread(trial % 2 == 0 ? 0.8 : 0.001, 1.0);
        for (double& cost : costs)
            cost = trial % 4 == 3 ? std::pow(spread(random), 6) : spread(random);
        const std::vector<std::uint32_t> seam = band.overlap.cheapestSeam(costs);
        const PlainSeam expected = plainSeam(band.overlap, band.places, costs);
        EXPECT_NEAR(band.costOf(seam, costs), expected.cost, 1e-12) << trial;
        const std::set<std::uint32_t> once(seam.begin(), seam.end());
        EXPECT_EQ(once.size(), seam.size());
    }
}

TEST(PartOverlap, CutsShortAndInTheMiddleWhereBothInstancesAreAlike)
{
    const Band band;
    std::vector<double> costs(band.overlap.edgeCount(), 0.0);
    band.overlap.addCosts(std::vector<Vec3d>(band.overlap.vertexCount(), Vec3d::Zero()), costs);
    const std::vector<std::uint32_t> seam = band.overlap.cheapestSeam(costs);
    EXPECT_EQ(seam.size(), 12U);
    const std::set<float> rings = band.ringsOf(seam);
    ASSERT_EQ(rings.size(), 1U);
    const std::set<float> all = band.ringsOf([&] {
        std::vector<std::uint32_t> vertices(band.overlap.vertexCount());
        std::iota(vertices.begin(), vertices.end(), 0);
        return vertices;
    }());
    EXPECT_EQ(std::distance(all.begin(), all.find(*rings.begin())),
              static_cast<std::ptrdiff_t>(all.size() / 2));
}

TEST(PartOverlap, CutsWhereTheInstancesAgree)
{
    const Band band(31, 3, 8);
    std::vector<float> rings;
    for (const Vec3f& place : band.places)
        rings.push_back(place.x());
    std::ranges::sort(rings);
    const float agreed = rings[rings.size() / 3];
    std::mt19937 random(2);
    std::uniform_real_distribution<double> off(-0.02, 0.02);
    std::vector<Vec3d> differences;
    for (const Vec3f& place : band.places)
        differences.push_back(std::abs(place.x() - agreed) < 0.08F
                                  ? Vec3d(Vec3d::Zero())
                                  : Vec3d(off(random), off(random), off(random)));
    std::vector<double> costs(band.overlap.edgeCount(), 0.0);
    band.overlap.addCosts(differences, costs);
    EXPECT_EQ(band.ringsOf(band.overlap.cheapestSeam(costs)), std::set{agreed});
}

TEST(PartOverlap, GoesOverFromParentToPartThroughTheSeam)
{
    const Band band(61, 3, 8);
    std::vector<double> costs(band.overlap.edgeCount(), 0.0);
    band.overlap.addCosts(std::vector<Vec3d>(band.overlap.vertexCount(), Vec3d::Zero()), costs);
    const std::vector<std::uint32_t> seam = band.overlap.cheapestSeam(costs);
    const float at = band.places[seam.front()].x();
    const std::vector<double> shares = band.overlap.shares(seam);
    std::map<int, double> along;
    for (std::size_t t = 0; t < shares.size(); ++t) {
        float x = 0;
        for (const VertexIndex v : band.overlap.triangles()[t])
            x += band.places[v.value].x() / 3;
        // The part lies at lower x than its parent.
        EXPECT_EQ(shares[t] > 0.5, x < at) << t;
        EXPECT_GT(shares[t], 0);
        EXPECT_LT(shares[t], 1);
        along[static_cast<int>(std::lround(x * 1000))] = shares[t];
    }
    double before = 1;
    for (const auto& [x, share] : along) {
        EXPECT_LE(share, before + 1e-9);
        EXPECT_GT(share, before - 0.15);
        before = share;
    }
}

TEST(PartOverlap, CutsAtItsEndWhereNothingJoinsTheRims)
{
    // The band is torn: its middle triangles are missing.
    Band band(31, 3, 8);
    BodyPart part = band.parted.parts.parts[1];
    float middle = 0;
    for (const Vec3f& place : band.places)
        middle += place.x() / static_cast<float>(band.places.size());
    std::erase_if(part.overlapTriangles, [&](TriangleIndex t) {
        float x = 0;
        for (const VertexIndex v : band.parted.bar.topology->triangles()[t.value])
            x += band.parted.bar.positions[v.value].x() / 3;
        return std::abs(x - middle) < 0.05F;
    });
    const PartOverlap torn(*band.parted.bar.topology, part, band.parted.bar.positions);
    const std::vector<std::uint32_t> seam = torn.cheapestSeam(std::vector<double>(torn.edgeCount(), 1.0));
    std::vector<VertexIndex> vertices;
    for (const std::uint32_t v : seam)
        vertices.push_back(part.overlap[v]);
    EXPECT_EQ(vertices, part.end);
    for (const double share : torn.shares(seam)) {
        EXPECT_GE(share, 0.5);
        EXPECT_LE(share, 1);
    }
}
