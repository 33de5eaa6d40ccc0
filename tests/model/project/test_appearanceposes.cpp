// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/madeclips.h"
#include "tests/model/project/lookproject.h"
#include "tests/model/project/quickvariation.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

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
