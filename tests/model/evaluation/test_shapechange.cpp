// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/shapechange.h"
#include "tests/model/transition/bars.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

using namespace quadrille;

namespace {

MeshSequence sequenceOf(const Bar& bar, const std::vector<std::vector<Vec3f>>& poses)
{
    std::vector<Vec3f> all;
    for (const auto& pose : poses)
        all.insert(all.end(), pose.begin(), pose.end());
    return makeSequence("bar", bar.topology,
                        std::make_shared<MemoryFrames>(std::move(all), bar.topology->vertexCount()), 25);
}

} // namespace

TEST(ShapeChange, EdgesAreThoseOfTheTriangles)
{
    const Bar bar = makeBar(3, 1, 2, 1);
    const auto edges = edgesOf(*bar.topology);
    EXPECT_EQ(std::ssize(edges), bar.topology->statistics().edges);
    EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
}

TEST(ShapeChange, OfAScaledPoseIsKnown)
{
    const Bar bar = makeBar(3, 1, 2, 1);
    const auto half = moved(bar.positions, [](const Vec3d& p) -> Vec3d { return 0.5 * p; });
    const auto edges = edgesOf(*bar.topology);
    // Between a pose and itself, half the size: edges 0.5, volume 0.125.
    ShapeChange change = shapeChange(*bar.topology, edges, bar.positions, bar.positions, 0.3, half);
    EXPECT_NEAR(change.meanEdge, -0.5, 1e-6);
    EXPECT_NEAR(change.edgeDeviation, 0.5, 1e-6);
    EXPECT_NEAR(change.greatestEdge, 0.5, 1e-6);
    EXPECT_NEAR(change.volume, -0.875, 1e-6);
    // A quarter of the way from full to half size, edges should have 0.875.
    change = shapeChange(*bar.topology, edges, bar.positions, half, 0.25, half);
    EXPECT_NEAR(change.meanEdge, 0.5 / 0.875 - 1, 1e-6);
    EXPECT_NEAR(change.volume, 0.125 / (0.75 + 0.25 * 0.125) - 1, 1e-6);
}

TEST(ShapeChange, OfAnOpenMeshHasNoVolume)
{
    const Bar bar = makeBar(3, 1, 2, 1, false);
    const auto change =
        shapeChange(*bar.topology, edgesOf(*bar.topology), bar.positions, bar.positions, 0.5, bar.positions);
    EXPECT_EQ(change.meanEdge, 0);
    EXPECT_TRUE(std::isinf(change.volume));
}

TEST(InterpolatePairs, LinearInterpolationShrinksABentBarAndPoissonDoesNot)
{
    // The paper's Fig. 4: bent by a right angle one way and the other.
    const Bar bar = makeBar(21, 2, 2, 0.2F);
    const MeshSequence sequence = sequenceOf(
        bar, {bent(bar.positions, 2, std::numbers::pi / 2), bent(bar.positions, 2, -std::numbers::pi / 2)});
    const CharacterFrames character({&sequence, 1});
    const std::vector<FramePair> pairs{{0, 1}};
    const std::vector<double> lambdas{0.5};
    const auto all = interpolatePairs(character, bar.topology, pairs, lambdas);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].method, InterpolationMethod::Linear);
    EXPECT_LT(all[0].change.meanEdge, -0.03);
    EXPECT_LT(all[0].change.volume, -0.05);
    EXPECT_EQ(all[2].method, InterpolationMethod::Poisson);
    EXPECT_LT(std::abs(all[2].change.meanEdge), 0.01);
    EXPECT_LT(std::abs(all[2].change.volume), 0.02); // the inside of the bend has no triangles to keep it
}

TEST(InterpolatePairs, RigidMotionBetweenThePosesChangesNothing)
{
    const Bar bar = makeBar(9, 1, 2, 0.4F);
    const Eigen::AngleAxisd turn(2.5, Vec3d(1, 2, 3).normalized());
    const auto turned =
        moved(bar.positions, [&](const Vec3d& p) -> Vec3d { return turn * p + Vec3d(5, 0, -3); });
    const MeshSequence sequence = sequenceOf(bar, {bar.positions, turned});
    const std::vector<FramePair> pairs{{0, 1}};
    const std::vector<double> lambdas{0.25, 0.5};
    for (const auto& pair : interpolatePairs(CharacterFrames({&sequence, 1}), bar.topology, pairs, lambdas)) {
        // Single precision of positions some metres away.
        EXPECT_LT(pair.change.greatestEdge, 1e-4);
        EXPECT_LT(std::abs(pair.change.volume), 1e-4);
    }
}

TEST(DrawPairs, AreTheSameForASeedAndOfDifferentFrames)
{
    const auto pairs = drawPairs(7, 500, 3);
    EXPECT_EQ(pairs, drawPairs(7, 500, 3));
    EXPECT_NE(pairs, drawPairs(7, 500, 4));
    std::vector<int> seen(49);
    for (const FramePair& pair : pairs) {
        ASSERT_NE(pair.source, pair.destination);
        ASSERT_LT(std::max(pair.source, pair.destination), 7);
        ++seen[static_cast<std::size_t>(pair.source * 7 + pair.destination)];
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 7); // every pair occurs
    EXPECT_TRUE(drawPairs(1, 5, 1).empty());
}
