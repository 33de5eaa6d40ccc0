// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/buildappearance.h"
#include "model/appearance/modeltextures.h"
#include "model/appearance/texturequality.h"
#include "tests/model/appearance/shiftedtextures.h"
#include "tests/model/core/temporaryfolder.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr std::int64_t shiftedCount = 5;
constexpr double shiftedStep = 0.9; ///< texels
const std::string takeName = "walk";

/// A model of five textures of one pattern that moves.
struct ShiftedModel
{
    ShiftedModel()
    {
        const ChartLookup charts = twoCharts();
        const TextureSource source = shiftedTextures(charts, shiftedCount, shiftedStep);
        BuildAppearanceOptions options;
        options.gutter = 3;
        options.components = 6;
        const BuiltAppearance built =
            buildAppearance(source, Topology(atlasOf({{6, 6, 60, 58}, {66, 6, 90, 58}}, 96, 64)), options);
        std::vector<AppearanceFrame> frames;
        for (FrameIndex frame(0); frame.value < shiftedCount; ++frame.value) {
            frames.push_back({takeName, frame});
            textures.push_back(source.read(frame.value));
        }
        known.model = std::make_shared<const AppearanceModel>(
            quantised(built.used, built.grid, built.textures, built.warps, frames));
        for (std::size_t row = 0; row < frames.size(); ++row)
            known.coefficients[{takeName, frames[row].frame}] = coefficientsOf(*known.model, row);
    }

    FrameAppearances known;
    std::vector<std::shared_ptr<const Image>> textures;
};

const ShiftedModel& shiftedModel()
{
    static const ShiftedModel model;
    return model;
}

CapturedTexture captured(std::int64_t frame)
{
    return {
        takeName, FrameIndex(frame), {.embedded = shiftedModel().textures[static_cast<std::size_t>(frame)]}};
}

ModelTextures texturesOf(FrameAppearances known)
{
    return ModelTextures([known = std::move(known)] { return std::optional(known); });
}

double errorOf(const Image& expected, const Image& found)
{
    return std::sqrt(textureQuality(expected, found, shiftedModel().known.model->texels).meanSquaredError);
}

} // namespace

TEST(ModelTextures, EndAtTheCapturedTexturesByteForByte)
{
    const ModelTextures textures = texturesOf(shiftedModel().known);
    EXPECT_EQ(*textures.between(captured(0), captured(4), 0).load(), *shiftedModel().textures[0]);
    EXPECT_EQ(*textures.between(captured(0), captured(4), 1).load(), *shiftedModel().textures[4]);
    EXPECT_NE(*textures.between(captured(0), captured(4), 0.25).load(), *shiftedModel().textures[0]);
}

TEST(ModelTextures, BecomeTheCapturedTexturesTowardsTheirEnds)
{
    // Whatever they hold where no triangle is.
    const std::vector<std::uint8_t> covered = coveredMask(shiftedModel().known.model->texels);
    const auto withNoise = [&](std::int64_t frame) {
        Image texture = *shiftedModel().textures[static_cast<std::size_t>(frame)];
        for (std::size_t texel = 0; texel < covered.size(); ++texel)
            if (covered[texel] == 0)
                texture.pixels[4 * texel] = static_cast<std::uint8_t>(texel * 37 + texel / 96 * 11);
        return CapturedTexture{
            takeName, FrameIndex(frame), {.embedded = std::make_shared<const Image>(std::move(texture))}};
    };
    const CapturedTexture first = withNoise(0);
    const CapturedTexture second = withNoise(4);
    const ModelTextures textures = texturesOf(shiftedModel().known);
    for (const auto& [weight, end] : {std::pair{1e-4, &first}, {1 - 1e-4, &second}}) {
        const auto near = textures.between(first, second, weight).load();
        const Image& expected = *end->texture.embedded;
        for (std::size_t i = 0; i < expected.pixels.size(); ++i)
            EXPECT_LE(std::abs(near->pixels[i] - expected.pixels[i]), 1) << i << " at " << weight;
    }
}

TEST(ModelTextures, MoveAPatternWhereALinearBlendShowsItTwice)
{
    const ModelTextures textures = texturesOf(shiftedModel().known);
    const UsedTexels& used = shiftedModel().known.model->texels;
    for (const double weight : {0.25, 0.5, 0.75}) {
        // Frames 0 and 4 are 4 steps apart, about frame 2, whose shift is zero.
        const double shift = shiftedStep * (4 * weight - 2);
        const Image expected = shiftedTexture(used, {shift, -0.5 * shift});
        const double error = errorOf(expected, *textures.between(captured(0), captured(4), weight).load());
        const double linear =
            errorOf(expected, mixedTexture(*captured(0).texture.load(), *captured(4).texture.load(), weight));
        EXPECT_LE(error, 0.5 * linear) << weight;
    }
}

TEST(ModelTextures, AreTheSameEachTimeTheyAreMade)
{
    const Texture made = texturesOf(shiftedModel().known).between(captured(1), captured(3), 0.3);
    const std::vector<std::byte> first = encodeImage(*made.load(), ".png");
    EXPECT_EQ(encodeImage(*made.load(), ".png"), first);
    EXPECT_EQ(
        encodeImage(*texturesOf(shiftedModel().known).between(captured(1), captured(3), 0.3).load(), ".png"),
        first);
}

TEST(ModelTextures, GiveNothingForFramesThatTheModelDoesNotKnow)
{
    const ModelTextures textures = texturesOf(shiftedModel().known);
    CapturedTexture other = captured(1);
    other.sequence = "run";
    CapturedTexture late = captured(1);
    late.frame = FrameIndex(shiftedCount);
    EXPECT_TRUE(textures.between(captured(0), other, 0.5).isEmpty());
    EXPECT_TRUE(textures.between(late, captured(0), 0.5).isEmpty());
    EXPECT_TRUE(textures.inPlaceOf(captured(0)).isEmpty());
}

TEST(ModelTextures, FindAModelThatComesLater)
{
    bool isThere = false;
    int asked = 0;
    const ModelTextures textures([&] {
        ++asked;
        return isThere ? std::optional(shiftedModel().known) : std::nullopt;
    });
    EXPECT_TRUE(textures.between(captured(0), captured(1), 0.5).isEmpty());
    isThere = true;
    EXPECT_FALSE(textures.between(captured(0), captured(1), 0.5).isEmpty());
    EXPECT_FALSE(textures.between(captured(0), captured(2), 0.5).isEmpty());
    EXPECT_EQ(asked, 2) << "a model that is there is read once";
}

TEST(ModelTextures, ShowCompletedTexturesInPlaceOfThoseThatWereCaptured)
{
    const TemporaryFolder folder;
    const Image completed = shiftedTexture(shiftedModel().known.model->texels, {1, 1});
    writeImage(completed, folder / "walk_1.png");
    FrameAppearances known = shiftedModel().known;
    known.completed[{takeName, FrameIndex(1)}] = {.file = folder / "walk_1.png"};
    const ModelTextures textures = texturesOf(known);
    EXPECT_EQ(*textures.inPlaceOf(captured(1)).load(), completed);
    EXPECT_TRUE(textures.inPlaceOf(captured(2)).isEmpty());
    EXPECT_EQ(*textures.between(captured(1), captured(2), 0).load(), completed);
    EXPECT_EQ(*textures.between(captured(2), captured(1), 1).load(), completed);
}

TEST(ModelTextures, ShowTheNearerOneWhereAPictureHasAnotherSizeByNow)
{
    const ModelTextures textures = texturesOf(shiftedModel().known);
    CapturedTexture replaced = captured(1);
    replaced.texture = {.embedded = std::make_shared<const Image>(32, 32)};
    EXPECT_EQ(*textures.between(captured(0), replaced, 0.4).load(), *shiftedModel().textures[0]);
    EXPECT_EQ(*textures.between(captured(0), replaced, 0.6).load(), Image(32, 32));
}
