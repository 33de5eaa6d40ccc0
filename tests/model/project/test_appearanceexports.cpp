// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/exports/exportentry.h"
#include "model/sequence/io/registry.h"
#include "tests/model/project/lookproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

/// A walk from the slow sequence to the quick one, and exports of its clip.
class AppearanceExports : public LookProject
{
protected:
    AppearanceExports()
    {
        project.graphs.resize(1);
        AnimationEntry animation;
        animation.name = "dance";
        const auto spanOf = [](const char* sequence, int first, int last) {
            return WalkSpanEntry{sequence, {FrameIndex(first), FrameIndex(last)}};
        };
        animation.walk = WalkEntry{.spans = {spanOf("slow", 0, 5), spanOf("quick", 4, 8)}};
        project.animations = {animation};
    }
    void addExport(const std::string& path)
    {
        ExportEntry entry;
        entry.name = path;
        entry.what = "animations/dance";
        entry.path = "out/" + path;
        project.exports.push_back(entry);
    }
    fs::path picture(std::size_t frame) const
    {
        std::array<char, 16> name{};
        std::snprintf(name.data(), name.size(), "%04zu.png", frame);
        return folder / (std::string("out/textures/dance/") + name.data());
    }
    std::string problem()
    {
        const std::optional<Error> error = failure("exports");
        return error ? error->what() : "none";
    }
};

} // namespace

TEST_F(AppearanceExports, WaitForTheModelOfAppearance)
{
    addExport("dance.obj");
    EXPECT_THAT(stepsOf(project, project.exports[0]), Contains("appearance/look/model"));
    EXPECT_THAT(stepsOf(project, project.exports[0]), Not(Contains("appearance/look/completions")));
    look().completions = {{.frame = {"slow", FrameIndex(3)}}};
    EXPECT_THAT(stepsOf(project, project.exports[0]), Contains("appearance/look/completions"));
    project.exports[0].textures = false;
    EXPECT_THAT(stepsOf(project, project.exports[0]), Not(Contains(HasSubstr("appearance"))));
    project.exports[0].textures = true;
    project.exports[0].what = "sequences/slow";
    EXPECT_THAT(stepsOf(project, project.exports[0]), Not(Contains(HasSubstr("appearance"))));
}

TEST_F(AppearanceExports, HaveMadeTexturesBetweenCapturedOnes)
{
    // One set of pictures for all: each export must write the same bytes.
    for (const char* path : {"dance.obj", "dance.ply", "dance.usda", "dance.glb"})
        addExport(path);
    ASSERT_EQ(problem(), "none");
    const auto sequence = column<std::string>("animations/dance/frames", "sequence");
    const auto source = column<std::int64_t>("animations/dance/frames", "source-frame");
    const auto lambda = column<double>("animations/dance/frames", "lambda");
    int made = 0;
    for (std::size_t f = 0; f < lambda.size(); ++f) {
        const auto frame = static_cast<int>(source[f]);
        const bool isCaptured = lambda[f] == 0;
        if (isCaptured) {
            EXPECT_EQ(textOf(picture(f)), textOf(textureFile(sequence[f], frame))) << f;
            continue;
        }
        ++made;
        const Image written = readImage(picture(f));
        for (int other = 0; other < slowFrames; ++other)
            EXPECT_NE(written, slowPattern(other)) << f;
        for (int other = 0; other < quickFrames; ++other)
            EXPECT_NE(written, quickPattern(other)) << f;
    }
    EXPECT_GT(made, 1);
    EXPECT_FALSE(fs::exists(picture(lambda.size())));
    SequenceOpener opener(project, folder.path(), results());
    const auto opened = opener.openClip("animations/dance");
    for (FrameIndex f(0); f.value < opened->sequence.frameCount(); ++f.value)
        EXPECT_EQ(readImage(picture(static_cast<std::size_t>(f.value))), *opened->sequence.texture(f));
    const ImportResult back = openSequences(folder / "out/dance_####.obj", {}, {});
    ASSERT_EQ(back.sequences[0].textures.kind(), TextureSet::Kind::PerFrame);
    EXPECT_EQ(*back.sequences[0].texture(FrameIndex(7)), readImage(picture(7)));
}

TEST_F(AppearanceExports, AreComputedAgainWithTheModel)
{
    addExport("dance.glb");
    ASSERT_EQ(problem(), "none");
    EXPECT_TRUE(computed(run("exports")).empty());
    const std::string before = textOf(picture(7));
    look().components = 2;
    EXPECT_THAT(computed(run("exports")), Contains("exports/dance.glb"));
    EXPECT_NE(textOf(picture(7)), before) << "pictures of its own are replaced";
}

TEST_F(AppearanceExports, ReplaceNoPicturesOfOthers)
{
    addExport("dance.glb");
    folder.write("out/textures/dance/0003.png", "somebody's");
    EXPECT_THAT(problem(), HasSubstr("0003.png"));
    EXPECT_EQ(textOf(picture(3)), "somebody's");
    EXPECT_FALSE(fs::exists(folder / "out/dance.glb"));
    EXPECT_FALSE(fs::exists(picture(0)));
    fs::remove(picture(3));
    addExport("sub/../dance.glb"); // of another name, but the same file
    project.exports[1].range = FrameRange{FrameIndex(1), FrameIndex(2)};
    EXPECT_THAT(problem(), HasSubstr("dance.glb"));
    project.exports.pop_back();
    // Pictures that are inputs stay, whoever asks.
    fs::create_directories(folder / "out/textures");
    fs::rename(folder / "looks/slow", folder / "out/textures/dance");
    project.sequences[0].texture = textureOf(TextureReference::Kind::PerFrame, {"out/textures/dance"});
    EXPECT_THAT(problem(), HasSubstr("sequences/slow"));
}
