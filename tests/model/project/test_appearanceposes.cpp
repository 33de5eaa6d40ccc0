// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/madeclips.h"
#include "model/project/steps/appearanceposes.h"
#include "tests/model/project/lookproject.h"
#include "tests/model/project/quickvariation.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::Pointwise;

namespace {

const std::string posesName = "appearance/look/poses";

/// Strips whose pattern moves as they bend, and variations of how they do.
class AppearancePoses : public LookProject
{
protected:
    AppearancePoses() { project.variations = {quickVariation("bending", "slow", "quick", 1)}; }
    MeshSequence variation()
    {
        SequenceOpener opener(project, folder.path(), results());
        return opener.openClip(variationClip("bending", 1))->sequence;
    }
    std::string stored() const { return textOf(results() / (posesName + ".h5")); }
};

} // namespace

TEST_F(AppearancePoses, AreLearnedWhereThereAreVariations)
{
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/model", posesName));
    EXPECT_THAT(item(posesName).shape(), ElementsAre(slowFrames + quickFrames, 10, 3));
    EXPECT_EQ(column<std::string>("appearance/look/pose-frames", "sequence").front(), "slow");
    EXPECT_THAT(column<std::string>("appearance/look/pose-scales", "coefficients"),
                ElementsAre("textures", "warps"));
    EXPECT_GT(column<double>("appearance/look/pose-scales", "trust")[1], 10) << "warps follow the pose";
    EXPECT_THAT(computed(run("appearance")), ElementsAre());
    look().varied = VariedTextures::Nearest;
    EXPECT_THAT(computed(run("appearance")), ElementsAre()) << "it is the same model";
    look().varied = VariedTextures::Learned;
    project.variations.clear();
    std::filesystem::remove_all(results());
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/model"));
}

TEST_F(AppearancePoses, AreSomeOfManySpreadOverAllTakes)
{
    std::vector<AppearanceRow> rows;
    for (const auto& [name, count] : {std::pair("slow", 300), std::pair("quick", 200)}) {
        for (int i = 0; i < count; ++i)
            rows.push_back({name, FrameIndex(i % quickFrames), std::ssize(rows)});
    }
    SequenceOpener opener(project, folder.path(), results());
    const KnownPoses known = knownPoses(opener, rows);
    ASSERT_EQ(known.rows.size(), 400U);
    EXPECT_EQ(known.places.count(), 400);
    EXPECT_EQ(known.rows[100].row, 125);
    EXPECT_EQ(known.rows.back().row, 498);
    EXPECT_THAT(known.names, ElementsAre("slow", "quick"));
    ASSERT_EQ(known.takes.size(), 400U);
    EXPECT_EQ(std::ranges::count(known.takes, 0), 240);
    EXPECT_EQ(known.takes[239], 0);
    EXPECT_EQ(known.takes[240], 1);
}

TEST_F(AppearancePoses, HaveScalesOfTheirOwnForTexturesAndWarps)
{
    for (int frame = 0; frame < slowFrames; ++frame) { // the light changes whatever the pose
        Image texture = slowPattern(frame);
        for (std::uint8_t& value : texture.pixels)
            value = static_cast<std::uint8_t>(value * (5 + frame * 7 % 5) / 10);
        writeImage(texture, textureFile("slow", frame));
    }
    run("appearance");
    SequenceOpener opener(project, folder.path(), results());
    const auto appearances = readAppearances(results(), folder.path(), look());
    ASSERT_TRUE(appearances && appearances->poses);
    const AppearanceModel& model = *appearances->model;
    std::vector<AppearanceRow> rows;
    std::vector<std::int64_t> numbers;
    for (const AppearanceFrame& frame : model.frames) {
        numbers.push_back(std::ssize(rows));
        rows.push_back({frame.sequence, frame.frame, numbers.back()});
    }
    const KnownPoses known = knownPoses(opener, rows);
    const Eigen::MatrixXd distances = squaredDistances(known.places);
    const Eigen::MatrixXd textures = coefficientRows(model.textures, numbers);
    const Eigen::MatrixXd warps = coefficientRows(model.warps, numbers);
    const PoseScales scales{.textures = foundScale(distances, textures, known.takes),
                            .warps = foundScale(distances, warps, known.takes)};
    EXPECT_NE(scales.textures, scales.warps);
    EXPECT_THAT(column<double>("appearance/look/pose-scales", "trust"),
                ElementsAre(scales.textures.trust, scales.warps.trust));
    EXPECT_THAT(column<double>("appearance/look/pose-scales", "length"),
                ElementsAre(scales.textures.length, scales.warps.length));
    const Frame pose = opener.open("slow")->sequence.frame(FrameIndex(3));
    const auto expected = PoseAppearance(known.places, textures, warps, scales).at(pose.positions());
    const auto found = appearances->poses->at(pose.positions());
    // Known coefficients are of single precision there.
    EXPECT_THAT(found.textures, Pointwise(FloatNear(0.01F), expected.textures));
    EXPECT_THAT(found.warps, Pointwise(FloatNear(0.001F), expected.warps));
}

TEST_F(AppearancePoses, MakeTheTexturesOfVariations)
{
    run("appearance");
    run("variations");
    const MeshSequence learned = variation();
    ASSERT_EQ(learned.textures.kind(), TextureSet::Kind::PerFrame);
    for (FrameIndex frame(0); frame.value < learned.frameCount(); ++frame.value)
        EXPECT_TRUE(learned.textures.textures()[static_cast<std::size_t>(frame.value)].made) << frame.value;
    const auto appearances = readAppearances(results(), folder.path(), look());
    ASSERT_TRUE(appearances && appearances->poses);
    const AppearanceDecoder decoder(appearances->model);
    EXPECT_EQ(*learned.texture(FrameIndex(4)),
              decoder.decode(appearances->poses->at(learned.frame(FrameIndex(4)).positions())));
    look().varied = VariedTextures::Nearest;
    const MeshSequence nearest = variation();
    EXPECT_NE(*nearest.texture(FrameIndex(4)), *learned.texture(FrameIndex(4)));
    EXPECT_FALSE(readAppearances(results(), folder.path(), look())->poses);
}

TEST_F(AppearancePoses, OfFramesThatTheModelHasNotAreLeftAlone)
{
    run("appearance");
    const std::string before = stored();
    project.sequences[1].range = FrameRange{FrameIndex(0), FrameIndex(4)};
    run("appearance/look/model");
    EXPECT_EQ(stored(), before);
    EXPECT_FALSE(readAppearances(results(), folder.path(), look())->poses);
    run("appearance");
    EXPECT_TRUE(readAppearances(results(), folder.path(), look())->poses);
}

TEST_F(AppearancePoses, AreTheSameForAnyNumberOfThreads)
{
    rebuild(project, projectFile(), {.targets = {"appearance"}, .jobs = 1});
    const std::string one = stored();
    std::filesystem::remove_all(results());
    rebuild(project, projectFile(), {.targets = {"appearance"}, .jobs = 2});
    EXPECT_EQ(stored(), one);
}

TEST_F(AppearancePoses, MakeExportsOfVariationsOld)
{
    ExportEntry& entry = project.exports.emplace_back();
    entry.name = "bent";
    entry.what = variationClip("bending", 1);
    entry.path = "out/bent.glb";
    run("exports");
    EXPECT_THAT(computed(run("exports")), ElementsAre());
    const std::string learned = textOf(folder / "out/bent.glb");
    look().varied = VariedTextures::Nearest;
    EXPECT_THAT(computed(run("exports")), Contains("exports/bent"));
    EXPECT_NE(textOf(folder / "out/bent.glb"), learned);
}
