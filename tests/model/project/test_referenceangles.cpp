// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/project/media/referenceangles.h"
#include "tests/model/project/testproject.h"

#include <gmock/gmock.h>
#include <numbers>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;

namespace {

/// A knee that bends by `degrees` from frame to frame.
std::string bendingKnee(int frames, double frameTime, double degrees)
{
    std::string text = "HIERARCHY\nROOT hip\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n"
                       "JOINT knee\n{\nOFFSET 0 1 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n"
                       "End Site\n{\nOFFSET 0 1 0\n}\n}\n}\nMOTION\nFrames: ";
    text += std::to_string(frames) + "\nFrame Time: " + std::to_string(frameTime) + "\n";
    for (int f = 0; f < frames; ++f)
        text += "5 6 7 " + std::to_string(degrees * f) + " 0 0\n";
    return text;
}

class ReferenceAngles : public ::testing::Test
{
protected:
    ReferenceAngles()
    {
        for (int f = 0; f < 9; ++f)
            folder.write("take/f_" + std::to_string(f) + ".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        project.settings.fps = 10;
        project.sequences = {sequenceOf("take", "take")};
        project.sequences[0].jointAngles = "take.bvh";
    }
    /// The knee's angle in each frame of a sequence, degrees.
    std::vector<double> knee(const std::string& name = "take")
    {
        SequenceOpener opener(project, folder.path());
        const JointAngles angles = referenceAngles(opener, *findSequence(project, name));
        EXPECT_EQ(angles.joints, std::vector<std::string>{"knee"});
        std::vector<double> degrees;
        for (std::int64_t f = 0; f < angles.frameCount; ++f)
            degrees.push_back(angles.at(f, 0)[0] * 180 / std::numbers::pi);
        return degrees;
    }
    static auto areNear(std::vector<double> expected)
    {
        // The frame time in the file has six digits.
        return ::testing::Pointwise(::testing::DoubleNear(1e-3), std::move(expected));
    }

    TemporaryFolder folder;
    Project project;
};

} // namespace

TEST_F(ReferenceAngles, OfAsManyFramesBelongToThemWhateverTheRate)
{
    folder.write("take.bvh", bendingKnee(9, 1.0 / 30, 2));
    EXPECT_THAT(knee(), areNear({0, 2, 4, 6, 8, 10, 12, 14, 16}));
}

TEST_F(ReferenceAngles, OfAnotherNumberOfFramesBelongByTime)
{
    folder.write("take.bvh", bendingKnee(34, 1.0 / 40, 2));
    EXPECT_THAT(knee(), areNear({0, 8, 16, 24, 32, 40, 48, 56, 64}));
}

TEST_F(ReferenceAngles, AreCutAndResampledAsTheSourceIs)
{
    folder.write("take.bvh", bendingKnee(9, 1.0 / 30, 2));
    project.sequences[0].range = FrameRange{FrameIndex(3), FrameIndex(7)};
    EXPECT_THAT(knee(), areNear({6, 8, 10, 12, 14}));
    project.sequences[0].sourceFps = 20; // every second frame
    EXPECT_THAT(knee(), areNear({6, 10, 14}));
    project.sequences[0].sourceFps = 4;
    EXPECT_THAT(knee(), areNear({6, 6.8, 7.6, 8.4, 9.2, 10, 10.8, 11.6, 12.4, 13.2, 14}));
    folder.write("take.bvh", bendingKnee(26, 1.0 / 12, 2)); // three for each of the source
    EXPECT_THAT(knee(), areNear({18, 20.4, 22.8, 25.2, 27.6, 30, 32.4, 34.8, 37.2, 39.6, 42}));
}

TEST_F(ReferenceAngles, ClipsHaveThoseOfTheirSource)
{
    folder.write("take.bvh", bendingKnee(9, 1.0 / 30, 2));
    project.sequences[0].range = FrameRange{FrameIndex(2), FrameIndex(8)};
    project.sequences.push_back(sequenceOf("clip", "clip:sequences/take"));
    project.sequences[1].range = FrameRange{FrameIndex(1), FrameIndex(3)};
    EXPECT_THAT(knee("clip"), areNear({6, 8, 10}));
    EXPECT_EQ(referenceAnglesFile(project, folder.path(), project.sequences[1]), folder / "take.bvh");
    project.sequences[1].jointAngles = "clip.bvh"; // of the seven frames of the take
    folder.write("clip.bvh", bendingKnee(7, 1.0 / 30, 1));
    EXPECT_THAT(knee("clip"), areNear({1, 2, 3}));
    project.sequences.push_back(sequenceOf("file", "take"));
    EXPECT_TRUE(referenceAnglesFile(project, folder.path(), project.sequences[2]).empty());
}

TEST_F(ReferenceAngles, ThatEndTooEarlyAreRefusedWithTheirFile)
{
    folder.write("take.bvh", bendingKnee(7, 1.0 / 10, 2));
    try {
        knee();
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::RangeOutside);
        EXPECT_THAT(error.what(), HasSubstr("take.bvh"));
        EXPECT_THAT(error.what(), HasSubstr("Frames 0 to 8 were asked for, but there are only 7"));
    }
}
