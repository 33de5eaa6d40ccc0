// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/trajectories.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace quadrille;

namespace {

/// An upright tetrahedron that walks along an arc, facing where it goes; y is up.
MeshSequence walkOnArc(int frames, double turnPerFrame)
{
    TopologyData data;
    data.vertexCount = 4;
    for (const auto& corners : {std::array{0U, 2U, 1U}, {0U, 1U, 3U}, {1U, 2U, 3U}, {0U, 3U, 2U}})
        data.triangles.push_back({VertexIndex(corners[0]), VertexIndex(corners[1]), VertexIndex(corners[2])});
    std::vector<Vec3f> positions;
    Vec3d at = Vec3d::Zero();
    for (int f = 0; f < frames; ++f) {
        const Eigen::AngleAxisd turn(turnPerFrame * f, Vec3d::UnitY());
        for (const Vec3d& corner :
             {Vec3d(-0.2, 0, -0.2), Vec3d(0.2, 0, -0.2), Vec3d(0, 0, 0.4), Vec3d(0, 1, 0)})
            positions.push_back((turn * corner + at).cast<float>());
        at += turn * Vec3d(0, 0, 0.05);
    }
    const auto topology = std::make_shared<const Topology>(data);
    return makeSequence("arc", topology, std::make_shared<MemoryFrames>(std::move(positions), 4), 25);
}

} // namespace

TEST(MeasureCurve, OfACornerAndAReversal)
{
    const std::vector<Vec2d> points{{0, 0}, {1, 0}, {1, 1}, {1, 0.5}};
    const CurveMeasures measures = measureCurve(points);
    EXPECT_DOUBLE_EQ(measures.length, 2.5);
    EXPECT_DOUBLE_EQ(measures.distance, std::hypot(1, 0.5));
    EXPECT_DOUBLE_EQ(measures.greatestTurn, std::numbers::pi);
    EXPECT_EQ(measures.reversals, 1);
}

TEST(MeasureCurve, ShortStepsHaveNoDirection)
{
    const std::vector<Vec2d> points{{0, 0}, {1, 0}, {0.999, 0}, {2, 0}};
    EXPECT_EQ(measureCurve(points).greatestTurn, 0);
    EXPECT_EQ(measureCurve(points).reversals, 0);
    EXPECT_EQ(measureCurve({}).length, 0);
    EXPECT_EQ(measureCurve(std::vector<Vec2d>(4, Vec2d(1, 1))).greatestTurn, 0);
}

TEST(NetTurning, IsPositiveToTheLeft)
{
    const Ground ground(UpAxis::Y);
    EXPECT_NEAR(netTurning(walkOnArc(11, 0.05), ground), 0.5, 1e-5);
    EXPECT_NEAR(netTurning(walkOnArc(11, -0.5), ground), -5, 1e-5); // more than half a turn
}

TEST(LongBlend, TakesTheWindowsThatGoTogetherBest)
{
    // Frame i of the source is like frame i − 3 of the destination.
    const std::array<std::int64_t, 2> counts{10, 8};
    const FrameLayout layout(counts);
    Table<float> distances(18, 18);
    const auto position = [](NodeIndex node) { return node < 10 ? node : node - 10 + 3; };
    for (NodeIndex i = 0; i < 18; ++i) {
        for (NodeIndex j = 0; j < 18; ++j)
            distances(i, j) = static_cast<float>(std::abs(position(i) - position(j)));
    }
    const Transition blend =
        longBlend(distances, layout, {.fps = 25, .shortestWindow = 2, .longestWindow = 5});
    EXPECT_EQ(blend.sourceWindow, 5);
    EXPECT_EQ(blend.destinationWindow, 5);
    EXPECT_EQ(blend.frames, (FramePair{3, 14}));
    EXPECT_EQ(blend.cost, 0);
    EXPECT_EQ(blend.length(), 5);
}

TEST(LongBlend, ShortSequencesBlendAsFarAsTimeMayBend)
{
    const std::array<std::int64_t, 2> counts{20, 4};
    const FrameLayout layout(counts);
    const Table<float> distances = Table<float>::Ones(24, 24);
    const Transition blend =
        longBlend(distances, layout, {.fps = 25, .shortestWindow = 9, .longestWindow = 50, .slope = 2});
    EXPECT_EQ(blend.sourceWindow, 8);
    EXPECT_EQ(blend.destinationWindow, 4);
}

TEST(BlendTrajectories, AlignedAtEveryStepTheBlendOfLeftAndRightGoesStraightOn)
{
    const std::vector<MeshSequence> sequences{walkOnArc(41, 0.06), walkOnArc(41, -0.06)};
    const CharacterFrames character(sequences);
    const RootPoses roots = rootPoses(character, UpAxis::Y);
    Transition blend{.frames = {0, 81}, .sourceWindow = 41, .destinationWindow = 41, .path = {}};
    for (NodeIndex f = 0; f < 41; ++f)
        blend.path.push_back({f, 41 + f});
    const auto all = blendTrajectories(roots, blend, 0.5);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[2].alignment, BlendAlignment::EveryStep);
    ASSERT_EQ(all[2].centres.size(), 41U);
    // Every step is the mean of two of 5 cm that face the same way.
    EXPECT_NEAR(all[2].measures.length, 40 * 0.05, 0.01);
    EXPECT_NEAR(all[2].measures.distance, 40 * 0.05, 0.01);
    EXPECT_LT(all[2].measures.greatestTurn, 0.01);
    // Without, the sideways parts cancel and the way gets shorter, as in the paper.
    EXPECT_LT(all[0].measures.length, 0.8 * all[2].measures.length);
    EXPECT_LT(all[1].measures.length, all[2].measures.length);
    EXPECT_GT(all[0].measures.reversals, 0);
}
