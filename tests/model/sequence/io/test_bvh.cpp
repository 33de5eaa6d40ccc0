// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/bvh.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <numbers>

using namespace quadrille;

namespace {

constexpr double degrees = std::numbers::pi / 180;

const std::string arm = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Upper Arm
  {
    OFFSET 1 0 0
    CHANNELS 3 Zrotation Yrotation Xrotation
    JOINT Hand
    {
      OFFSET 0 2 0
      CHANNELS 1 xrotation
      End Site
      {
        OFFSET 0 0 1
      }
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.033333
0 1 2 90 0 0  10 20 30  0
0 1 2 90 0 0  10 20 30  45
0 1 2 90 0 0  10 20 30  +9.0e1
)";

Bvh parse(const std::string& text)
{
    return parseBvh(text, "arm.bvh");
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST(Bvh, HierarchyAndMotionAreRead)
{
    const Bvh bvh = parse(arm);
    ASSERT_EQ(bvh.joints.size(), 3U);
    EXPECT_EQ(bvh.joints[1].name, "Upper Arm");
    EXPECT_EQ(bvh.joints[1].parent, 0);
    EXPECT_EQ(bvh.joints[2].parent, 1);
    EXPECT_EQ(bvh.joints[2].offset, Vec3d(0, 2, 0));
    EXPECT_EQ(bvh.joints[2].firstChannel, 9U);
    EXPECT_EQ(bvh.channelCount, 10U);
    EXPECT_EQ(bvh.frameCount, 3);
    EXPECT_EQ(bvh.fps, 30.0); // six decimals of 1/30
}

TEST(Bvh, JointAnglesAreTheRotationsWithoutTheRoot)
{
    const JointAngles angles = jointAngles(parse(arm));
    EXPECT_THAT(angles.joints, ::testing::ElementsAre("Upper Arm", "Hand"));
    EXPECT_EQ(jointAngles(parse(arm), false).joints.size(), 3U);
    ASSERT_EQ(angles.frameCount, 3);
    const auto hand = angles.at(1, 1);
    EXPECT_NEAR(hand[0], 45 * degrees, 1e-12);
    EXPECT_NEAR(hand[1], 0, 1e-12);
    // Rz(10)·Ry(20)·Rx(30) as the file orders it equals Rx·Ry·Rz of our angles.
    const auto upper = angles.at(0, 0);
    const auto about = [](double angle, const Vec3d& axis) {
        return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    };
    const Eigen::Matrix3d expected = about(10 * degrees, Vec3d::UnitZ()) *
                                     about(20 * degrees, Vec3d::UnitY()) *
                                     about(30 * degrees, Vec3d::UnitX());
    const Eigen::Matrix3d found =
        about(upper[0], Vec3d::UnitX()) * about(upper[1], Vec3d::UnitY()) * about(upper[2], Vec3d::UnitZ());
    EXPECT_LT((expected - found).norm(), 1e-12);
}

TEST(Bvh, AnglesAreResampledToASequence)
{
    const JointAngles angles = jointAngles(parse(arm));
    const JointAngles dense = resampled(angles, 60, 0, 5);
    ASSERT_EQ(dense.frameCount, 5);
    EXPECT_NEAR(dense.at(1, 1)[0], 22.5 * degrees, 1e-9);
    EXPECT_NEAR(dense.at(4, 1)[0], 90 * degrees, 1e-9);
    const JointAngles cut = resampled(angles, 30, 1, 2);
    EXPECT_NEAR(cut.at(0, 1)[0], 45 * degrees, 1e-9);
    EXPECT_EQ(codeOf([&] { resampled(angles, 30, 1, 3); }), ErrorCode::RangeOutside);
    EXPECT_EQ(codeOf([&] { resampled(angles, 30, -1, 1); }), ErrorCode::RangeOutside);
    EXPECT_EQ(codeOf([&] { resampled(angles, 0, 0, 1); }), ErrorCode::BadArgument);
}

TEST(Bvh, BadFilesNameTheLine)
{
    EXPECT_EQ(codeOf([] { readBvh("/no/such/file.bvh"); }), ErrorCode::FileNotFound);
    const TemporaryFolder folder;
    EXPECT_EQ(codeOf([&] { readBvh(folder.write("empty.bvh", "")); }), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOf([&] { readBvh(folder / ""); }), ErrorCode::BadArgument); // the folder itself
    EXPECT_EQ(codeOf([] { parse("just text"); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([] { parse(std::string("HIER\0ARCHY", 10)); }), ErrorCode::FileEncoding);
    EXPECT_EQ(codeOf([] { parse(arm.substr(0, 200)); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([] { parse(arm.substr(0, arm.size() - 12)); }), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf([] { parse(replaced(arm, "Frames: 3", "Frames: 900000000")); }),
              ErrorCode::CountTooLarge);
    EXPECT_EQ(codeOf([] { parse(replaced(arm, "Frames: 3", "Frames: -3")); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([] { parse(replaced(arm, "CHANNELS 3", "CHANNELS 900")); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([] { parse(replaced(arm, "xrotation", "wrotation")); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([] { parse(replaced(arm, "0.033333", "0")); }), ErrorCode::FileSyntax);
    try {
        parse(replaced(arm, "10 20 30  45", "10 nan 30  45"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::FileSyntax);
        EXPECT_EQ(error.context().place.line, 25);
    }
}

TEST(Bvh, IsRefusedWhereItIsCutOrWrong)
{
    for (std::size_t length = 0; length + 8 < arm.size(); length += 3)
        codeOf([&] { parse(arm.substr(0, length)); });
    for (std::size_t at = 0; at < arm.size(); ++at) {
        std::string wrong = arm;
        wrong[at] = static_cast<char>(static_cast<unsigned char>(wrong[at]) ^ 0xFFU);
        try {
            parse(wrong);
        } catch (const Error& error) {
            EXPECT_EQ(error.context().file, "arm.bvh");
        }
    }
}

TEST(Bvh, CapturedMotionOpens)
{
    if (!std::filesystem::exists(dataDirectory() / "raw/cmu_02_01.bvh"))
        GTEST_SKIP() << "no data";
    const Bvh walk = readBvh(dataDirectory() / "raw/cmu_02_01.bvh");
    EXPECT_EQ(walk.frameCount, 343);
    EXPECT_EQ(walk.fps, 120.0);
    const Bvh dance = readBvh(dataDirectory() / "raw/cmu_131_01.bvh");
    EXPECT_EQ(dance.frameCount, 994);
    EXPECT_EQ(dance.fps, 120.0);
    // The retargeted skeleton lies frame by frame beside its take.
    const Bvh jog = readBvh(dataDirectory() / "characters/rb_m04/jog_1.bvh");
    EXPECT_EQ(resampled(jointAngles(jog), 30, 0, 42).frameCount, 42);
}
