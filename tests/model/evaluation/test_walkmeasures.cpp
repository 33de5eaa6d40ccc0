// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/walkmeasures.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace quadrille;

namespace {

double lengthOf(std::string_view path)
{
    const std::vector<Vec2d> points = standardPath(path);
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = (points[i] - points[i - 1]).norm();
        EXPECT_GT(step, 0) << path;
        EXPECT_LT(step, 0.1) << path;
        length += step;
    }
    return length;
}

} // namespace

TEST(WalkMeasures, StandardPathsAreAsLongAsTheyShould)
{
    constexpr double pi = std::numbers::pi;
    EXPECT_NEAR(lengthOf("straight"), 8, 1e-9);
    EXPECT_NEAR(lengthOf("right-angle"), 8, 1e-9);
    EXPECT_NEAR(lengthOf("circle"), 6 * pi, 1e-2);
    EXPECT_NEAR(lengthOf("figure-of-eight"), 8 * pi, 1e-2);
    EXPECT_GT(lengthOf("s"), 8.5);
    for (const std::string_view path : standardPaths)
        EXPECT_LT(standardPath(path).front().norm(), 1e-12) << path;
}

TEST(WalkMeasures, CountFramesOfAPlanByHand)
{
    ClipPlan plan{.up = UpAxis::Y, .frames = std::vector<PlannedFrame>(10)};
    for (std::size_t f = 4; f < 7; ++f)
        plan.frames[f].origin = {.source = 1, .destination = 9, .lambda = 0.5};
    const Walk walk{{{0, 3}, {12, 14}}};
    const WalkCalmness calm = calmnessOf(plan, walk, {}, 5);
    EXPECT_DOUBLE_EQ(calm.seconds, 2);
    EXPECT_EQ(calm.transitions, 1);
    EXPECT_DOUBLE_EQ(calm.transitionsPerSecond(), 0.5);
    EXPECT_EQ(calm.shortestRun, 3);
    EXPECT_DOUBLE_EQ(calm.blendedShare, 0.3);
    EXPECT_EQ(calm.strayShare, 0);
    // All show frame 0, and three of them frames 1 and 9 by halves.
    std::vector<bool> locomotion(15, true);
    locomotion[9] = false;
    EXPECT_DOUBLE_EQ(calmnessOf(plan, walk, locomotion, 5).strayShare, 0.15);
    locomotion[0] = false;
    EXPECT_DOUBLE_EQ(calmnessOf(plan, walk, locomotion, 5).strayShare, 0.85);
}

TEST(WalkMeasures, FeelAFootThatSlidesAndASpeedThatChanges)
{
    // A foot of four vertices on the ground, y up, that slides 2 cm in each of 25 frames a second, for half
    // of the clip.
    Clip clip{.topology = nullptr, .fps = 25, .positions = {}, .origins = {}};
    TopologyData four;
    four.vertexCount = 4;
    four.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}};
    clip.topology = std::make_shared<const Topology>(std::move(four));
    for (int f = 0; f < 20; ++f) {
        const float x = 0.02F * static_cast<float>(std::min(f, 10));
        for (const float z : {0.0F, 0.1F, 0.2F, 0.3F})
            clip.positions.emplace_back(x, 0.0F, z);
        clip.origins.push_back({});
    }
    const Stances stances{.feet = {{"left", {0, 1, 2, 3}}}, .height = 1.8, .standing = {1}};
    const MotionMeasures measures = measureMotion(clip, stances, UpAxis::Y, {0});
    EXPECT_NEAR(measures.slide95, 0.5, 1e-5);
    // 5 of 14 pairs of frames a fifth of a second apart differ by 0.5 m/s.
    EXPECT_NEAR(measures.speedChange, 0.5 * std::sqrt(5.0 / 14), 1e-5);
    // High above the ground nothing slides.
    EXPECT_EQ(measureMotion(clip, stances, UpAxis::Y, {-1}).slide95, 0);
}

TEST(WalkMeasures, TakeTheFootThatSlipsLeastForTheOneThatStands)
{
    // The right foot swings past, half a centimetre over the ground at 1 m/s; the left one, which slips at
    // 0.1 m/s, was captured 3 cm higher than it.
    TopologyData six;
    six.vertexCount = 6;
    six.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}};
    Clip clip{.topology = std::make_shared<const Topology>(std::move(six)),
              .fps = 20,
              .positions = {},
              .origins = std::vector<FrameProvenance>(10)};
    for (int f = 0; f < 10; ++f)
        for (const float x : {0.0F, 0.1F, 0.2F}) {
            clip.positions.emplace_back(x + 0.005F * static_cast<float>(f), 0.03F, 0.0F);
            clip.positions.emplace_back(x + 0.05F * static_cast<float>(f), 0.005F, 0.2F);
        }
    const Stances stances{
        .feet = {{"left", {0, 2, 4}}, {"right", {1, 3, 5}}}, .height = 1.8, .standing = {1}};
    EXPECT_NEAR(measureMotion(clip, stances, UpAxis::Y, {0.03, 0}).slide95, 0.1, 1e-4);
    EXPECT_NEAR(measureMotion(clip, stances, UpAxis::Y, {0, 0}).slide95, 1, 1e-4);
}

TEST(WalkMeasures, FindTheLevelOfEachFoot)
{
    // The left foot stands in all three frames, the right one never.
    TopologyData six;
    six.vertexCount = 6;
    six.triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}};
    std::vector<Vec3f> positions;
    for (const float height : {0.01F, 0.04F, 0.03F})
        for (int v = 0; v < 6; ++v)
            positions.emplace_back(0.1F * static_cast<float>(v), height, 0.0F);
    const MeshSequence sequence = makeSequence("take", std::make_shared<const Topology>(std::move(six)),
                                               std::make_shared<MemoryFrames>(std::move(positions), 6), 25);
    const Stances stances{
        .feet = {{"left", {0, 1, 2}}, {"right", {3, 4, 5}}}, .height = 1.8, .standing = {1, 1, 1}};
    const std::vector<double> levels =
        standingLevels(CharacterFrames(std::span(&sequence, 1)), stances, UpAxis::Y);
    ASSERT_EQ(levels.size(), 2U);
    EXPECT_NEAR(levels[0], 0.03, 1e-6);
    EXPECT_EQ(levels[1], -std::numeric_limits<double>::infinity());
}
