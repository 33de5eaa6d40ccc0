// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "appearancefixture.h"
#include "model/appearance/decode.h"
#include "model/appearance/spreadtexels.h"

#include <cmath>
#include <gtest/gtest.h>
#include <thread>

namespace quadrille {

using namespace test;

namespace {

std::shared_ptr<const AppearanceModel> sharedModel(const AppearanceSpaces& spaces)
{
    return std::make_shared<const AppearanceModel>(quantised(spaces));
}

/// Two charts beside each other, one of them 3 texels wide, in an atlas of 8 × 4. Each texel's red is 10 · x
/// + y, its green 200 in the second chart; there are no components.
AppearanceSpaces twoCharts(Vec2f warp)
{
    AppearanceSpaces spaces{.grid = WarpGrid::over(8, 4)};
    spaces.texels = {.width = 8, .height = 4, .chartCount = 2};
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 7; ++x) {
            spaces.texels.texels.push_back(static_cast<std::uint32_t>(8 * y + x));
            spaces.texels.charts.push_back(x < 4 ? 0 : 1);
            spaces.texels.covered.push_back(1);
            spaces.textures.mean.insert(spaces.textures.mean.end(),
                                        {static_cast<float>(10 * x + y), x < 4 ? 0.0F : 200.0F, 0});
        }
    }
    for (std::int64_t n = 0; n < spaces.grid.nodes(); ++n)
        spaces.warps.mean.insert(spaces.warps.mean.end(), {warp.x(), warp.y()});
    return spaces;
}

int redAt(const Image& texture, int x, int y)
{
    return texture.pixel(x, y)[0];
}

TEST(AppearanceDecoder, LooksTexelsUpWhereTheWarpPoints)
{
    const Image texture = AppearanceDecoder(sharedModel(twoCharts({1, 0.5F}))).decode({});
    EXPECT_EQ(redAt(texture, 0, 0), 11); // 10 + 0.5, rounded away from zero
    EXPECT_EQ(redAt(texture, 2, 1), 32);
    EXPECT_EQ(redAt(texture, 4, 2), 53);
    EXPECT_EQ(texture.pixel(2, 1)[3], 255);
}

TEST(AppearanceDecoder, NeverMixesCharts)
{
    const Image texture = AppearanceDecoder(sharedModel(twoCharts({0.75F, 0}))).decode({});
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 7; ++x)
            EXPECT_EQ(texture.pixel(x, y)[1], x < 4 ? 0 : 200) << x << " " << y;
    }
    EXPECT_EQ(redAt(texture, 3, 0), 30); // what is right of it belongs to the other chart
    EXPECT_EQ(redAt(texture, 6, 0), 60);
    const Image far = AppearanceDecoder(sharedModel(twoCharts({-3, 0}))).decode({});
    EXPECT_EQ(redAt(far, 4, 0), 40); // back to −0.75, of which a quarter is its own
    EXPECT_EQ(redAt(far, 6, 0), 45); // −1.5
    EXPECT_EQ(redAt(far, 3, 0), 0);
    const Image farther = AppearanceDecoder(sharedModel(twoCharts({1e30F, 1e30F}))).decode({});
    EXPECT_EQ(farther.pixel(3, 3)[1], 0);
}

TEST(AppearanceDecoder, DiffersByAGreyLevelAtMostFromPlainSums)
{
    for (const int seed : {1, 2, 3}) {
        const UsedTexels texels =
            texelsOfDiscs(131, 77, {{30, 30, 25.5}, {80, 31, 24}, {119, 60, 11}, {66, 70, 13}});
        const AppearanceSpaces spaces =
            randomSpaces(texels, {.contrast = 12}, static_cast<std::uint64_t>(seed));
        const auto model = sharedModel(spaces);
        const AppearanceDecoder decoder(model);
        const AppearanceCoefficients coefficients = coefficientsOf(*model, static_cast<std::size_t>(seed));
        const Image texture = decoder.decode(coefficients);
        const Image expected = plainDecode(*model, coefficients);
        double sum = 0;
        int largest = 0;
        for (const std::uint32_t texel : texels.texels) {
            for (std::size_t c = 0; c < 4; ++c) {
                const int difference = std::abs(int{texture.pixels[4 * std::size_t{texel} + c]} -
                                                int{expected.pixels[4 * std::size_t{texel} + c]});
                largest = std::max(largest, difference);
                sum += c < 3 ? difference : 0;
            }
        }
        EXPECT_LE(largest, 1);
        EXPECT_LT(sum / static_cast<double>(3 * texels.texels.size()),
                  0.3); // aligned texels are rounded as well
        EXPECT_GT(sum, 0);
    }
}

TEST(AppearanceDecoder, TakesFewerCoefficientsThanThereAreComponents)
{
    const auto model = sharedModel(randomSpaces(texelsOfDiscs(40, 40, {{20, 20, 17}}), {}, 7));
    const AppearanceDecoder decoder(model);
    AppearanceCoefficients some = coefficientsOf(*model, 1);
    some.textures.resize(3);
    some.warps.resize(1);
    AppearanceCoefficients all = some;
    all.textures.resize(6);
    all.warps.resize(3);
    EXPECT_EQ(decoder.decode(some), decoder.decode(all));
    EXPECT_NE(decoder.decode(some), decoder.decode({}));
}

TEST(AppearanceDecoder, GivesTheSameTextureInUsedMemoryAndOnAllThreads)
{
    const auto model = sharedModel(randomSpaces(texelsOfDiscs(60, 60, {{30, 30, 25}}), {}, 8));
    const AppearanceDecoder decoder(model);
    const Image expected = decoder.decode(coefficientsOf(*model, 0));
    DecodeScratch scratch;
    Image texture(3, 5);
    decoder.decode(coefficientsOf(*model, 1), scratch, texture);
    decoder.decode(coefficientsOf(*model, 0), scratch, texture);
    EXPECT_EQ(texture, expected);
    std::vector<Image> textures(4);
    std::vector<std::thread> threads;
    for (std::size_t f = 0; f < textures.size(); ++f)
        threads.emplace_back([&, f] { textures[f] = decoder.decode(coefficientsOf(*model, f)); });
    for (std::thread& thread : threads)
        thread.join();
    for (std::size_t f = 0; f < textures.size(); ++f)
        EXPECT_EQ(textures[f], decoder.decode(coefficientsOf(*model, f)));
}

TEST(AppearanceDecoder, ShowsAlignedTexelsWithoutAWarp)
{
    const auto model = sharedModel(twoCharts({1, 1}));
    const AppearanceDecoder decoder(model);
    EXPECT_EQ(redAt(decoder.decodeAligned({}), 2, 1), 21);
    AppearanceModel still = *model;
    still.warps = {};
    still.grid = {};
    EXPECT_EQ(AppearanceDecoder(std::make_shared<const AppearanceModel>(still)).decode({}),
              decoder.decodeAligned({}));
}

TEST(AppearanceDecoder, DealignsAGivenTexture)
{
    const auto model = sharedModel(randomSpaces(texelsOfDiscs(50, 50, {{25, 25, 20}}), {}, 3));
    const AppearanceDecoder decoder(model);
    const AppearanceCoefficients frame = coefficientsOf(*model, 2);
    const Image texture = decoder.decodeAligned(frame.textures);
    std::vector<std::uint8_t> aligned;
    for (const std::uint32_t texel : model->texels.texels)
        aligned.insert(aligned.end(), &texture.pixels[4 * texel], &texture.pixels[4 * texel] + 3);
    EXPECT_EQ(decoder.dealigned(aligned, combined(model->warps, frame.warps)), decoder.decode(frame));
}

TEST(AppearanceDecoder, MixesMovedTextures)
{
    const auto model = sharedModel(randomSpaces(texelsOfDiscs(50, 50, {{25, 25, 20}}), {}, 3));
    const AppearanceDecoder decoder(model);
    const AppearanceCoefficients frame = coefficientsOf(*model, 2);
    // Gutters are never taken from a texture: it has to have the colours there that it would get.
    Image texture = decoder.decodeAligned(frame.textures);
    const std::vector<std::uint8_t> colours = ChartLookup(model->texels).colours(texture);
    for (std::size_t i = 0; i < model->texels.texels.size(); ++i)
        std::copy_n(&colours[3 * i], 3, &texture.pixels[4 * model->texels.texels[i]]);
    const Image black(50, 50);
    DecodeScratch scratch;
    const std::vector<float> warp = combined(model->warps, frame.warps);
    const std::vector<float> other = combined(model->warps, {});
    Image moved = black;
    decoder.mix({texture, warp}, {black, other}, 0, scratch, moved);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < model->texels.texels.size(); ++i) {
        const std::size_t texel = model->texels.texels[i];
        changed += moved.pixels[4 * texel] != texture.pixels[4 * texel] ? 1 : 0;
    }
    EXPECT_GT(changed, model->texels.texels.size() / 2);
    Image mixed = black;
    decoder.mix({black, other}, {texture, warp}, 0.5F, scratch, mixed);
    for (const std::uint32_t texel : model->texels.texels)
        EXPECT_EQ(mixed.pixels[4 * texel], (moved.pixels[4 * texel] + 1) / 2);
    const std::vector<float> still(warp.size(), 0.0F);
    decoder.mix({texture, still}, {black, other}, 0, scratch, moved);
    for (std::size_t i = 0; i < model->texels.texels.size(); ++i) {
        const std::size_t texel = model->texels.texels[i];
        EXPECT_EQ(moved.pixels[4 * texel], model->texels.covered[i] != 0 ? texture.pixels[4 * texel] : 0);
    }
}

TEST(AppearanceDecoder, DependsOnWarpsAtItsNodesAlone)
{
    const auto model = sharedModel(randomSpaces(texelsOfDiscs(50, 50, {{14, 30, 9}, {40, 12, 6}}), {}, 3));
    const AppearanceDecoder decoder(model);
    const int width = model->grid.width;
    std::vector<bool> isNeeded(static_cast<std::size_t>(model->grid.nodes()));
    for (const NodeRun& run : decoder.nodes())
        for (int k = 0; k < run.count; ++k)
            isNeeded[static_cast<std::size_t>(run.row * width + run.column + k)] = true;
    const std::vector<std::uint8_t> colours = ChartLookup(model->texels).colours(decoder.decodeAligned({}));
    const std::vector<float> warp = combined(model->warps, {});
    const Image texture = decoder.dealigned(colours, warp);
    for (std::size_t node = 0; node < isNeeded.size(); ++node) {
        std::vector<float> other = warp;
        other[2 * node] += 40;
        EXPECT_EQ(decoder.dealigned(colours, other) != texture, isNeeded[node]) << node;
    }
}

TEST(AppearanceDecoder, FillsTexelsThatAreNotUsed)
{
    const auto model = sharedModel(twoCharts({0, 0}));
    const Image spread = AppearanceDecoder(model).decode({});
    EXPECT_EQ(redAt(spread, 7, 2), 62); // the colour of the texel to its left
    EXPECT_EQ(spread.pixel(7, 2)[3], 255);
    Image background(8, 4);
    background.pixel(7, 2)[2] = 99;
    EXPECT_EQ(AppearanceDecoder(model, background).decode({}).pixel(7, 2)[2], 99);
}

TEST(AppearanceDecoder, TakesAnAtlasOfOneTexel)
{
    AppearanceSpaces spaces{.texels = {.width = 1, .height = 1, .texels = {0}, .charts = {0}, .covered = {1}},
                            .grid = WarpGrid::over(1, 1)};
    spaces.textures.mean = {10, 20, 300};
    spaces.warps.mean = {5, -5};
    const Image texture = AppearanceDecoder(sharedModel(spaces)).decode({});
    EXPECT_EQ(texture.pixels, (decltype(Image::pixels){10, 20, 255, 255}));
}

TEST(SpreadTexels, GiveTheColourOfTheNearestUsedTexel)
{
    UsedTexels used{.width = 9, .height = 1, .texels = {1, 6}, .charts = {0, 0}, .covered = {1, 1}};
    Image texture(9, 1);
    texture.pixel(1, 0)[1] = 50;
    texture.pixel(6, 0)[1] = 90;
    spreadTexels(used, texture);
    for (int x = 0; x < 9; ++x) {
        EXPECT_EQ(texture.pixel(x, 0)[1], x < 4 ? 50 : 90) << x;
        EXPECT_EQ(texture.pixel(x, 0)[3], 255);
    }
    Image blank(9, 1);
    spreadTexels({.width = 9, .height = 1}, blank);
    EXPECT_EQ(blank.pixel(4, 0)[3], 255);
}

} // namespace

} // namespace quadrille
