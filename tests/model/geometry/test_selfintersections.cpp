// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/selfintersections.h"
#include "tests/model/transition/bars.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace quadrille;

namespace {

using Vec3i = Eigen::Vector3i;
using Corners = std::array<Vec3f, 3>;

/// Where a triangle meets another one's plane, along their common line: from, to; the triangle's corners have
/// these distances from the plane. Small integers: doubles tell all cases apart.
std::array<double, 2> stretchOf(const Corners& corners, const std::array<double, 3>& distances,
                                const Vec3d& line)
{
    std::array<double, 2> stretch{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
    const auto include = [&](const Vec3d& point) {
        stretch[0] = std::min(stretch[0], line.dot(point));
        stretch[1] = std::max(stretch[1], line.dot(point));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Vec3d a = corners[i].cast<double>();
        const Vec3d b = corners[j].cast<double>();
        if (distances[i] == 0)
            include(a);
        if (distances[i] * distances[j] < 0)
            include(a + (b - a) * distances[i] / (distances[i] - distances[j]));
    }
    return stretch;
}

bool crossPlainly(const Corners& a, const Corners& b)
{
    const auto normalOf = [](const Corners& t) -> Vec3d {
        return (t[1] - t[0]).cast<double>().cross((t[2] - t[0]).cast<double>());
    };
    const auto distancesFrom = [&](const Corners& plane, const Corners& of) {
        std::array<double, 3> distances{};
        for (std::size_t i = 0; i < 3; ++i)
            distances[i] = normalOf(plane).dot((of[i] - plane[0]).cast<double>());
        return distances;
    };
    const std::array<double, 3> ofA = distancesFrom(b, a);
    const std::array<double, 3> ofB = distancesFrom(a, b);
    for (const auto& distances : {ofA, ofB}) {
        if (*std::ranges::min_element(distances) >= 0 || *std::ranges::max_element(distances) <= 0)
            return false;
    }
    const Vec3d line = normalOf(a).cross(normalOf(b));
    const auto [fromA, toA] = stretchOf(a, ofA, line);
    const auto [fromB, toB] = stretchOf(b, ofB, line);
    return std::min(toA, toB) - std::max(fromA, fromB) > 1e-6;
}

std::vector<SelfIntersections::Pair> findPlainly(const Topology& topology, Positions pose)
{
    std::vector<SelfIntersections::Pair> pairs;
    const std::vector<Triangle>& triangles = topology.triangles();
    const auto cornersOf = [&](const Triangle& t) {
        return Corners{pose[t[0].value], pose[t[1].value], pose[t[2].value]};
    };
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = i + 1; j < triangles.size(); ++j) {
            if (std::ranges::find_first_of(triangles[i], triangles[j]) == triangles[i].end() &&
                trianglesCross(cornersOf(triangles[i]), cornersOf(triangles[j])))
                pairs.push_back({TriangleIndex(i), TriangleIndex(j)});
        }
    }
    return pairs;
}

} // namespace

TEST(TrianglesCross, OnlyWhereTheyGoThroughEachOther)
{
    const Corners flat{Vec3f(0, 0, 0), Vec3f(4, 0, 0), Vec3f(0, 4, 0)};
    const std::vector<std::pair<Corners, bool>> cases{
        {{Vec3f(1, 1, -1), Vec3f(1, 1, 1), Vec3f(1, 2, 1)}, true},    // pierced
        {{Vec3f(1, 1, -1), Vec3f(1, 1, 1), Vec3f(9, 9, 1)}, true},    // pierced by an edge
        {{Vec3f(-1, 1, -1), Vec3f(-1, 1, 1), Vec3f(5, 1, 0)}, true},  // cut across, a corner in the plane
        {{Vec3f(1, 1, 0), Vec3f(1, 1, 1), Vec3f(1, 2, 1)}, false},    // touched by a corner
        {{Vec3f(1, 1, 0), Vec3f(2, 1, 0), Vec3f(1, 2, 1)}, false},    // touched by an edge
        {{Vec3f(1, 1, 0), Vec3f(2, 1, 0), Vec3f(1, 2, 0)}, false},    // in one plane
        {{Vec3f(4, 0, -1), Vec3f(4, 0, 1), Vec3f(6, 0, 0)}, false},   // at a corner only
        {{Vec3f(2, 2, -1), Vec3f(2, 2, 1), Vec3f(5, 5, 0)}, false},   // at a point of an edge only
        {{Vec3f(3, 3, -1), Vec3f(3, 3, 1), Vec3f(5, 3, 0)}, false},   // beside
        {{Vec3f(1, 1, -1), Vec3f(1, 1, 1), Vec3f(1, 1, 0)}, false},   // without area
        {{Vec3f(-1, 0, -1), Vec3f(-1, 0, 1), Vec3f(5, 0, 1)}, false}, // along an edge
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& [other, expected] = cases[i];
        EXPECT_EQ(trianglesCross(flat, other), expected) << i;
        EXPECT_EQ(trianglesCross(other, flat), expected) << i;
    }
}

// On a coarse lattice most pairs touch in some way.
TEST(TrianglesCross, AsTheReferenceSaysOnALattice)
{
    std::mt19937 random(3);
    int crossing = 0;
    for (const int extent : {1, 2, 4}) {
        std::uniform_int_distribution<int> place(-extent, extent);
        for (int trial = 0; trial < 60000; ++trial) {
            std::array<Corners, 2> triangles;
            for (Corners& corners : triangles) {
                for (Vec3f& corner : corners)
                    corner = Vec3i(place(random), place(random), place(random)).cast<float>();
            }
            const bool expected = crossPlainly(triangles[0], triangles[1]);
            crossing += expected ? 1 : 0;
            ASSERT_EQ(trianglesCross(triangles[0], triangles[1]), expected) << extent << " " << trial;
            std::rotate(triangles[0].begin(), triangles[0].begin() + 1, triangles[0].end());
            std::swap(triangles[1][0], triangles[1][1]);
            ASSERT_EQ(trianglesCross(triangles[1], triangles[0]), expected) << extent << " " << trial;
        }
    }
    EXPECT_GT(crossing, 5000);
}

// Corners in the plane but for single steps of single precision, where doubles alone would guess.
TEST(TrianglesCross, IsExactWhereRoundingWouldDecide)
{
    const Corners plane{Vec3f(0.1F, 0.7F, 0.3F), Vec3f(1.3F, 0.9F, 1.1F), Vec3f(0.5F, 1.9F, 1.7F)};
    const Vec3d u = (plane[1] - plane[0]).cast<double>();
    const Vec3d v = (plane[2] - plane[0]).cast<double>();
    std::mt19937 random(4);
    std::uniform_real_distribution<double> part(0.1, 0.4);
    int differing = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const auto near = [&] {
            return Vec3f((plane[0].cast<double>() + part(random) * u + part(random) * v).cast<float>());
        };
        const Corners other{near(), near(), near()};
        const auto sideOf = [&](const Vec3f& p) {
            using Exact = Eigen::Matrix<long double, 3, 1>;
            const auto at = [&](const Vec3f& x) -> Exact {
                return (x.cast<long double>() - p.cast<long double>());
            };
            const long double d = at(plane[0]).dot(at(plane[1]).cross(at(plane[2])));
            return d > 0 ? 1 : d < 0 ? -1 : 0;
        };
        const std::array sides{sideOf(other[0]), sideOf(other[1]), sideOf(other[2])};
        const bool crossesPlane = std::ranges::min(sides) < 0 && std::ranges::max(sides) > 0;
        differing += crossesPlane ? 1 : 0;
        // All three lie over the middle of the other one: they cross exactly when they cross its plane.
        EXPECT_EQ(trianglesCross(plane, other), crossesPlane) << trial;
    }
    EXPECT_GT(differing, 1000);
}

TEST(SelfIntersections, AreNoneOnAPlainTube)
{
    const Bar bar = makeBar(31, 3, 2.0F, 0.3F);
    const SelfIntersections search(bar.topology, bar.positions);
    EXPECT_TRUE(search.find(bar.positions).empty());
    EXPECT_TRUE(search.find(bent(bar.positions, 2.0, 2.0)).empty());
}

TEST(SelfIntersections, AreFoundWhereATubeWasPushedIntoItself)
{
    const Bar bar = makeBar(31, 3, 2.0F, 0.3F);
    // One vertex through the opposite side, which is 0.3 m away.
    std::vector<Vec3f> pose = bar.positions;
    const std::size_t vertex = 15 * 12 + 1;
    pose[vertex] -= 1.5F * Vec3f(0, pose[vertex].y(), pose[vertex].z());
    pose[vertex] *= 1.0F;
    pose[vertex].y() *= 1.2F;
    pose[vertex].z() *= 2.5F;
    const SelfIntersections search(bar.topology, bar.positions);
    const std::vector<SelfIntersections::Pair> pairs = search.find(pose);
    EXPECT_FALSE(pairs.empty());
    EXPECT_EQ(pairs, findPlainly(*bar.topology, pose));
    for (const auto& [a, b] : pairs) {
        const auto has = [&](TriangleIndex t) {
            return std::ranges::find(bar.topology->triangles()[t.value], VertexIndex(vertex)) !=
                   bar.topology->triangles()[t.value].end();
        };
        EXPECT_TRUE(has(a) || has(b));
    }
}

TEST(SelfIntersections, AreThoseOfAllPairs)
{
    const Bar bars = makeBar(15, 2, 1.0F, 0.3F, true, 2);
    const SelfIntersections search(bars.topology, bars.positions);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const std::vector<Vec3f> pose = shaken(bent(bars.positions, 1.0, 5.5), 0.04 * seed, seed);
        const std::vector<SelfIntersections::Pair> expected = findPlainly(*bars.topology, pose);
        EXPECT_FALSE(expected.empty());
        EXPECT_EQ(search.find(pose), expected) << seed;
    }
}

TEST(SelfIntersections, DoNotDependOnThePoseThatTheTreeWasBuiltIn)
{
    const Bar bar = makeBar(15, 2, 1.0F, 0.3F);
    const std::vector<Vec3f> pose = shaken(bar.positions, 0.1, 1);
    EXPECT_EQ(SelfIntersections(bar.topology, bar.positions).find(pose),
              SelfIntersections(bar.topology, shaken(bar.positions, 1.0, 2)).find(pose));
}

TEST(SelfIntersections, BearTrianglesWithoutArea)
{
    const Bar bar = makeBar(15, 2, 1.0F, 0.3F);
    const std::vector<Vec3f> point(bar.positions.size(), Vec3f(1, 2, 3));
    EXPECT_TRUE(SelfIntersections(bar.topology, point).find(point).empty());
}
