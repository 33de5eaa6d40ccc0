// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/blendsteps.h"
#include "model/synthesis/finishing/footpath.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

constexpr std::uint32_t leftFoot = 1;
constexpr std::uint32_t rightFoot = 2;
constexpr std::uint32_t bothFeet = leftFoot | rightFoot;

/// A body 2 m tall (z up) of a vertex above two feet of one each. It shows a frame of a take, blends for some
/// frames and shows a frame of another; its feet lie on the ground and are carried evenly through the blend.
struct Standing
{
    Clip clip;
    Stances stances{.feet = {{"left", {1}}, {"right", {2}}}, .height = 2};

    Standing(int frames, const Vec3f& carriedLeft, const Vec3f& carriedRight)
    {
        clip.topology = std::make_shared<const Topology>(
            TopologyData{.vertexCount = 3, .triangles = {{VertexIndex(0), VertexIndex(1), VertexIndex(2)}}});
        clip.fps = 25;
        clip.origins.push_back({0, 0});
        for (int f = 0; f < frames; ++f)
            clip.origins.push_back({0, 1, f / (frames - 1.0)});
        clip.origins.push_back({1, 1});
        for (const FrameProvenance& origin : clip.origins) {
            const auto along = static_cast<float>(origin.isSingle() ? origin.source : origin.lambda);
            clip.positions.insert(clip.positions.end(), {{0, 0, 2},
                                                         Vec3f(0, 0.1F, 0) + along * carriedLeft,
                                                         Vec3f(0, -0.1F, 0) + along * carriedRight});
        }
        stances.standing = {bothFeet, bothFeet};
    }

    /// For each frame a letter: both, left, right or nothing.
    std::string standing() const
    {
        std::string letters;
        for (const std::uint32_t feet : stancesOf(clip, stances))
            letters += "-LRB"[feet];
        return letters;
    }
};

const Vec3f little{0.15F, 0, 0};
const Vec3f far{0.2F, 0, 0};
const Vec3f farther{0, 0.3F, 0};

TEST(BlendSteps, FeetThatAreCarriedFarTakeOne)
{
    EXPECT_EQ(Standing(10, little, little).standing(), "BBBBBBBBBBBB");
    // The whole blend but a frame at both ends, at most 0.4 seconds, in its middle.
    EXPECT_EQ(Standing(10, far, little).standing(), "BBRRRRRRRRBB");
    EXPECT_EQ(Standing(10, little, far).standing(), "BBLLLLLLLLBB");
    EXPECT_EQ(Standing(16, far, little).standing(), "BBBBRRRRRRRRRRBBBB");
}

TEST(BlendSteps, BothFeetStepOneAfterTheOtherWhereThereIsTime)
{
    EXPECT_EQ(Standing(13, far, farther).standing(), "BBLLLLLBRRRRRBB");
    EXPECT_EQ(Standing(10, far, farther).standing(), "BBLLLLLLLLBB");
    // Shorter than a fifth of a second is no step.
    EXPECT_EQ(Standing(7, far, little).standing(), "BBRRRRRBB");
    EXPECT_EQ(Standing(6, far, little).standing(), "BBBBBBBB");
}

TEST(BlendSteps, NobodyStepsWithTheOnlyFootThatStands)
{
    Standing walker(10, far, far);
    walker.stances.standing = {leftFoot, leftFoot};
    EXPECT_EQ(walker.standing(), "LLLLLLLLLLLL");
    walker.stances.standing = {bothFeet, leftFoot};
    EXPECT_EQ(walker.standing(), "BBBBBBLLLLLL");
}

TEST(BlendSteps, FeetThatLandInABlendOrLeaveTheGroundStepWhileTheyStand)
{
    const Vec3f veryFar(0.5F, 0, 0);
    Standing jumper(16, veryFar, little);
    jumper.stances.standing = {0, bothFeet};
    EXPECT_EQ(jumper.standing(), "---------BRRRRRRBB");
    jumper.stances.standing = {bothFeet, 0};
    EXPECT_EQ(jumper.standing(), "BBRRRRRRB---------");
    // In a shorter blend there is no time left for it.
    Standing shorter(12, veryFar, little);
    shorter.stances.standing = {0, bothFeet};
    EXPECT_EQ(shorter.standing(), "-------BBBBBBB");
}

TEST(BlendSteps, CapturedFramesAndFeetThatNobodyFoundStayAsTheyAre)
{
    Standing captured(10, far, little);
    for (FrameProvenance& origin : captured.clip.origins)
        origin.destination = origin.source;
    EXPECT_EQ(captured.standing(), "BBBBBBBBBBBB");
    const Vec3f veryFar(1, 0, 0); // with it goes the middle of the whole body
    Standing unknown(10, veryFar, veryFar);
    unknown.stances.feet[0].vertices = {0, 1, 2};
    unknown.stances.feet[1].vertices = {};
    EXPECT_EQ(unknown.standing(), "BBBBBBBBBBBB");
}

TEST(BlendSteps, AreLiftedOverTheGround)
{
    const Standing stepping(10, far, little);
    FootContacts foot{.vertices = {1},
                      .spans = {{FrameIndex(0), FrameIndex(1)}, {FrameIndex(10), FrameIndex(11)}}};
    const ContactCorrectionSettings settings;
    const auto shifts = footShifts(stepping.clip, foot, settings, 2, Ground(UpAxis::Z));
    // A step of 20 cm wants 5 cm; a lift is at most 4 cm.
    EXPECT_NEAR(shifts[5].lift + shifts[6].lift, 2 * 0.04, 0.002);
    for (std::size_t f = 0; f < 5; ++f) {
        EXPECT_NEAR(shifts[f].lift, shifts[11 - f].lift, 1e-9);
        EXPECT_LE(shifts[f].lift, shifts[f + 1].lift);
    }
    EXPECT_EQ(shifts[1].lift, 0);
    EXPECT_EQ(shifts[10].lift, 0);
    // A foot that clears the ground by itself is left alone, and so is what was captured.
    Standing high = stepping;
    for (std::size_t f = 2; f < 10; ++f)
        high.clip.positions[3 * f + 1].z() = 0.03F;
    EXPECT_EQ(footShifts(high.clip, foot, settings, 2, Ground(UpAxis::Z))[5].lift, 0);
    Standing captured = stepping;
    captured.clip.origins[5].destination = captured.clip.origins[5].source;
    EXPECT_EQ(footShifts(captured.clip, foot, settings, 2, Ground(UpAxis::Z))[5].lift, 0);
}

} // namespace
} // namespace quadrille
