// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/completionmask.h"
#include "tests/model/project/lookproject.h"

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

namespace {

Image blackTexture()
{
    Image image(64, 64);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        image.pixels[i] = 255;
    return image;
}

/// What is wrong with textures that a model of appearance is made of, or completes.
class AppearanceInput : public LookProject
{
protected:
    /// \param file  that is named; may be empty. \param part  of the sentence.
    void expectFailure(ErrorCode code, const fs::path& file, const std::string& part)
    {
        const std::optional<Error> error = failure();
        ASSERT_TRUE(error);
        EXPECT_EQ(error->code(), code) << error->what();
        EXPECT_EQ(error->context().file, file) << error->what();
        EXPECT_THAT(std::string(error->what()), HasSubstr(part));
        EXPECT_THAT(std::string(error->what()), HasSubstr(". "));
        EXPECT_FALSE(fillMessage(errorMessage(code).remedy, error->context()).empty());
    }
    void complete(const std::string& sequence, int frame)
    {
        MaskStrokeEntry stroke;
        stroke.points = {0.5, 0.5};
        look().completions = {{.frame = {sequence, FrameIndex(frame)}, .strokes = {stroke}}};
    }
    Image shown(const std::string& sequence, int frame)
    {
        return *SequenceOpener(project, folder.path(), results())
                    .open(sequence)
                    ->sequence.texture(FrameIndex(frame));
    }
};

} // namespace

TEST_F(AppearanceInput, NeedsATexturePerFrame)
{
    for (SequenceEntry& sequence : project.sequences)
        sequence.texture = textureOf(TextureReference::Kind::Single, {"looks/slow/0000.png"});
    expectFailure(ErrorCode::ProjectInvalid, {}, "has a texture for each frame");
    look().sequences = {"slow"};
    expectFailure(ErrorCode::ProjectInvalid, {}, "“slow” has no texture for each frame");
}

TEST_F(AppearanceInput, LeavesOutSequencesWithOneTexture)
{
    project.sequences[0].texture = textureOf(TextureReference::Kind::Single, {"looks/slow/0000.png"});
    ASSERT_FALSE(failure());
    EXPECT_EQ(column<std::int64_t>("appearance/look/frames", "row").size(), std::size_t{quickFrames});
}

TEST_F(AppearanceInput, NeedsTexturesOfOneSize)
{
    writeImage(Image(48, 64), textureFile("quick", 3));
    expectFailure(ErrorCode::ProjectInvalid, textureFile("quick", 3),
                  "48 × 64 texels, the first one 64 × 64. Give all textures of the character one size.");
}

TEST_F(AppearanceInput, NeedsEveryTexture)
{
    fs::remove(textureFile("slow", 5));
    expectFailure(ErrorCode::ImageCountMismatch, folder / "looks/slow", "13 textures for 14 frames");
}

TEST_F(AppearanceInput, NeedsTexturesThatCanBeRead)
{
    folder.write("looks/slow/0005.png", "no picture at all");
    expectFailure(ErrorCode::ImageUnreadable, textureFile("slow", 5), "cannot be read");
}

TEST_F(AppearanceInput, NeedsUvs)
{
    for (int f = 0; f < slowFrames; ++f)
        folder.write("slow/f_" + std::to_string(f) + ".obj", bentStrip(0.01 * f));
    look().sequences = {"slow"};
    expectFailure(ErrorCode::NoUvs, folder / "slow/f_0.obj", "no texture coordinates");
}

TEST_F(AppearanceInput, NeedsAReferenceThatIsLearned)
{
    look().reference = NamedFrame{"slow", FrameIndex(slowFrames)};
    expectFailure(ErrorCode::ProjectInvalid, {}, "The reference of “look” is none of the frames");
}

TEST_F(AppearanceInput, MayBeBlack)
{
    for (int f = 0; f < slowFrames; ++f)
        writeImage(blackTexture(), textureFile("slow", f));
    look().sequences = {"slow"};
    complete("slow", 3);
    const std::optional<Error> error = failure();
    ASSERT_FALSE(error) << error->what();
    EXPECT_EQ(readImage(filesOfLook() / "slow_3.png"), blackTexture());
}

TEST_F(AppearanceInput, MayHaveSixteenBitsAndAlpha)
{
    cv::Mat deep(64, 64, CV_16UC4);
    const Image& pattern = slowPattern(5);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto grey = static_cast<std::uint16_t>(257 * pattern.pixel(x, y)[0]);
            deep.at<cv::Vec4w>(y, x) = {grey, grey, grey, static_cast<std::uint16_t>(257 * 200)};
        }
    }
    cv::imwrite(textureFile("slow", 5).string(), deep);
    ASSERT_FALSE(failure());
    const auto similarity = column<double>("appearance/look/metrics", "similarity");
    EXPECT_GT(similarity[5], 0.95);
    const Image texture = shown("slow", 5);
    EXPECT_EQ(texture.pixel(9, 9)[0], pattern.pixel(9, 9)[0]);
    EXPECT_EQ(texture.pixel(9, 9)[3], 200);
}

TEST_F(AppearanceInput, CompletesFramesThatThereAre)
{
    complete("slow", slowFrames);
    expectFailure(ErrorCode::ProjectInvalid, {}, "“slow” has no frame 14. Its frames are 0 to 13.");
}

TEST_F(AppearanceInput, CompletesTexturesOfTheModelsSize)
{
    look().sequences = {"quick"};
    complete("slow", 3);
    writeImage(Image(32, 64), textureFile("slow", 3));
    expectFailure(ErrorCode::ProjectInvalid, textureFile("slow", 3),
                  "The texture of “slow”, frame 3, has 32 × 64 texels, those that were learned 64 × 64");
    project.sequences[0].texture = {};
    expectFailure(ErrorCode::ProjectInvalid, {}, "“slow” has no texture in frame 3");
}

TEST_F(AppearanceInput, NeedsMasksOfTheTexturesSize)
{
    complete("slow", 3);
    look().completions[0].mask = "mask.png";
    writeImage(Image(32, 32), folder / "mask.png");
    expectFailure(
        ErrorCode::ProjectInvalid, folder / "mask.png",
        "The mask has 32 × 32 pixels, the textures 64 × 64 texels. Give it the size of the textures.");
    fs::remove(folder / "mask.png");
    expectFailure(ErrorCode::FileNotFound, folder / "mask.png", "mask.png");
}

TEST(MaskStrokes, CoverADiscAroundEachPointAndWhatLiesBetween)
{
    std::vector<std::uint8_t> mask(16 * 8);
    const auto rows = [&] {
        std::vector<std::string> lines;
        for (std::size_t y = 0; y < 8; ++y) {
            lines.emplace_back();
            for (std::size_t x = 0; x < 16; ++x)
                lines.back() += mask[16 * y + x] != 0 ? 'x' : '.';
        }
        return lines;
    };
    // From the centre of texel (2, 1), counted from the top, to that of (9, 1): 1.1 texels to both sides.
    MaskStrokeEntry stroke;
    stroke.points = {2.5 / 16, 1 - 1.5 / 8, 9.5 / 16, 1 - 1.5 / 8};
    stroke.radius = 1.1 / 16;
    MaskStrokeEntry dot;
    dot.points = {5.5 / 16, 1 - 1.5 / 8};
    dot.radius = 0.5 / 16;
    dot.erases = true;
    paintStrokes(std::vector{stroke, dot}, 16, 8, mask);
    EXPECT_EQ(rows(), (std::vector<std::string>{"..xxxxxxxx......", ".xxxx.xxxxx.....", "..xxxxxxxx......",
                                                "................", "................", "................",
                                                "................", "................"}));
    stroke.points = {1.2, -0.3}; // all outside
    EXPECT_NO_THROW(paintStrokes(std::vector{stroke}, 16, 8, mask));
}
