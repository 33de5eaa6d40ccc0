// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/synthesis/quality/framemeasures.h"
#include "tests/model/synthesis/cliptest.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A straight tube of 1.8 m, whose rings have 4 vertices each, z up: it stands for five frames, then goes on
/// by 0.1 m a frame. Contacts are said to last from frame 2 to 6.
MeshSequence standing()
{
    const auto topology = tubeTopology(4, 10);
    std::vector<Vec3f> positions;
    for (int f = 0; f < 9; ++f) {
        const float x = 0.1F * static_cast<float>(std::max(f - 4, 0));
        for (int ring = 0; ring < 10; ++ring) {
            for (const Vec3f& corner : {Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(-1, 0, 0), Vec3f(0, -1, 0)})
                positions.push_back(0.1F * corner + Vec3f(x, 0, 0.2F * static_cast<float>(ring)));
        }
    }
    MeshSequence sequence =
        makeSequence("standing", topology, std::make_shared<MemoryFrames>(positions, 40), 25);
    sequence.contacts = {{"left", {FrameIndex(2), FrameIndex(6)}}};
    return sequence;
}

CharacterFrames standingCharacter()
{
    const MeshSequence sequence = standing();
    return CharacterFrames(std::span(&sequence, 1));
}

} // namespace

TEST(Supports, AreLowAndSlowWhileAFootStands)
{
    const std::vector<Support> supports = findSupports(standingCharacter(), UpAxis::Z);
    ASSERT_EQ(supports.size(), 9U);
    for (std::size_t f = 0; f < 9; ++f) {
        // Frame 4 is the last that is slow on one side.
        const bool stands = f >= 2 && f <= 4;
        EXPECT_EQ(supports[f].vertices,
                  stands ? std::vector<std::uint32_t>({0, 1, 2, 3}) : std::vector<std::uint32_t>())
            << f;
    }
    EXPECT_TRUE(supports[3].meanOf(supports[3].vertices).isZero(1e-7));
    EXPECT_TRUE(supports[3].meanOf(std::vector<std::uint32_t>{0, 1}).isApprox(Vec2d(0.05, 0.05), 1e-6));
    EXPECT_TRUE(supports[3].meanOf(std::vector<std::uint32_t>{2}).isApprox(Vec2d(-0.1, 0), 1e-6));
}

TEST(Supports, AreFoundWhereNoContactsAreGiven)
{
    // A tube has no feet.
    MeshSequence sequence = standing();
    sequence.contacts.clear();
    for (const Support& support : findSupports(CharacterFrames(std::span(&sequence, 1)), UpAxis::Z))
        EXPECT_TRUE(support.vertices.empty());
}

TEST(FrameMeasures, AreThoseOfAHandSolvedMotion)
{
    const CharacterFrames character = standingCharacter();
    const std::vector<Support> supports = findSupports(character, UpAxis::Z);
    const std::vector<FrameMeasure> measures = frameMeasures(character, supports, UpAxis::Z);
    EXPECT_FALSE(measures.front().acceleration);
    EXPECT_FALSE(measures.back().acceleration);
    for (std::size_t f = 1; f < 8; ++f)
        EXPECT_NEAR(*measures[f].acceleration, f == 4 ? 0.1 * 25 * 25 : 0, 2e-4) << f;
    EXPECT_NEAR(*measures[2].slip, 0, 1e-6);
    EXPECT_FALSE(measures[1].slip);
    EXPECT_FALSE(measures[4].slip);
    const Ground ground(UpAxis::Z);
    const Frame now = character.frame(5);
    const Frame next = character.frame(6);
    EXPECT_NEAR(meanStep(now.positions(), next.positions()), 0.1, 1e-6);
    EXPECT_NEAR(meanSlip(now.positions(), next.positions(), std::vector<std::uint32_t>{7, 9}, ground), 0.1,
                1e-6);
}

TEST(FrameMeasures, VolumeIsThatOfTheClosedSurface)
{
    const std::vector<Vec3f> corners{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}};
    const auto triangle = [](int a, int b, int c) {
        return Triangle{VertexIndex(a), VertexIndex(b), VertexIndex(c)};
    };
    const std::vector<Triangle> triangles{triangle(0, 2, 1), triangle(0, 1, 3), triangle(1, 2, 3),
                                          triangle(2, 0, 3)};
    EXPECT_NEAR(enclosedVolume(corners, triangles), 1 / 6.0, 1e-7);
}

TEST(BlendEasing, SetsInAndEndsGently)
{
    const TubeTakes takes(threeTakes());
    const TransitionMotion motion =
        transitionMotion(takes.roots, advancingTogether(3, 30, 9), {.easing = BlendEasing::Smooth});
    EXPECT_EQ(motion.steps.front().lambda, 0);
    EXPECT_EQ(motion.steps.back().lambda, 1);
    EXPECT_DOUBLE_EQ(motion.steps[4].lambda, 0.5);
    EXPECT_DOUBLE_EQ(motion.steps[2].lambda, 0.15625); // 3/16 − 2/64
    EXPECT_DOUBLE_EQ(motion.steps[6].lambda, 1 - 0.15625);
}
