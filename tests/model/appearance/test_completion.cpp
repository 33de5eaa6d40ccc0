// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "appearancefixture.h"
#include "model/appearance/completion.h"
#include "model/appearance/projection.h"
#include "model/appearance/texturequality.h"
#include "tests/model/codeof.h"

#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {

using namespace test;

namespace {

/// A fifth of the atlas is missing, across the first chart and part of the second.
std::vector<std::uint8_t> knownOutsideOfABand(const UsedTexels& texels)
{
    std::vector<std::uint8_t> known(static_cast<std::size_t>(texels.width * texels.height), 1);
    for (int y = 0; y < texels.height; ++y) {
        for (int x = 0; x < texels.width; ++x) {
            const bool isMissing = (y >= 40 && y < 58 && x < 100) || (x >= 110 && x < 130 && y < 40);
            known[static_cast<std::size_t>(y * texels.width + x)] = isMissing ? 0 : 1;
        }
    }
    return known;
}

std::vector<std::uint8_t> missingOf(const std::vector<std::uint8_t>& known, const UsedTexels& texels)
{
    std::vector<std::uint8_t> missing = coveredMask(texels);
    for (std::size_t i = 0; i < missing.size(); ++i)
        missing[i] = missing[i] != 0 && known[i] == 0 ? 1 : 0;
    return missing;
}

/// As a camera leaves it: nothing where it is not known.
Image withHoles(const Image& texture, const std::vector<std::uint8_t>& known)
{
    Image result = texture;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i] == 0)
            std::fill_n(result.pixels.data() + 4 * i, 3, std::uint8_t{0});
    }
    return result;
}

TEST(CompleteTexture, FillsWhatIsMissing)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    const std::vector<std::uint8_t> known = knownOutsideOfABand(model->texels);
    const std::vector<std::uint8_t> missing = missingOf(known, model->texels);
    const auto count = std::count(missing.begin(), missing.end(), 1);
    EXPECT_GT(count * 5, std::count(model->texels.covered.begin(), model->texels.covered.end(), 1) * 0.9);
    for (const std::size_t frame : {0U, 3U, 6U}) {
        const Image truth = decoder.decode(coefficientsOf(*model, frame));
        const CompletedTexture completed = completeTexture(decoder, withHoles(truth, known), known);
        const PictureQuality quality = pictureQuality(truth, completed.texture, missing);
        EXPECT_GT(quality.similarity, 0.99) << frame;
        EXPECT_LT(quality.meanSquaredError, 2) << frame; // 1.4 grey levels; waves are up to 110 high
        // The mean texture, which would be there without the known texels.
        EXPECT_GT(pictureQuality(truth, decoder.decode({}), missing).meanSquaredError,
                  20 * quality.meanSquaredError);
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (known[i] == 0)
                continue;
            for (std::size_t c = 0; c < 4; ++c)
                ASSERT_EQ(completed.texture.pixels[4 * i + c], truth.pixels[4 * i + c]);
        }
    }
}

TEST(CompleteTexture, FindsTheCoefficientsOfTheWarp)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    const std::vector<std::uint8_t> known = knownOutsideOfABand(model->texels);
    const AppearanceCoefficients truth = coefficientsOf(*model, 3);
    const AppearanceCoefficients found =
        completeTexture(decoder, withHoles(decoder.decode(truth), known), known, {.rounds = 2}).coefficients;
    double size = 0;
    double error = 0;
    for (std::size_t c = 0; c < truth.warps.size(); ++c) {
        size += std::pow(truth.warps[c], 2);
        error += std::pow(truth.warps[c] - found.warps[c], 2);
    }
    EXPECT_LT(std::sqrt(error), 0.01 * std::sqrt(size)); // in two rounds
}

TEST(CompleteTexture, BeginsWithAnEstimatedWarp)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    const std::vector<std::uint8_t> known = knownOutsideOfABand(model->texels);
    const AppearanceCoefficients truth = coefficientsOf(*model, 5);
    const Image texture = withHoles(decoder.decode(truth), known);
    int calls = 0;
    const CompletionOptions options{
        .rounds = 0, .warpNoise = 0.1, .estimate = [&](const Image& fixed, const Image& moving, auto mask) {
            ++calls;
            EXPECT_EQ(fixed, texture);
            EXPECT_EQ(moving, decoder.decodeAligned({}));
            EXPECT_TRUE(std::equal(mask.begin(), mask.end(), known.begin(), known.end()));
            return combined(model->warps, truth.warps);
        }};
    const AppearanceCoefficients found = completeTexture(decoder, texture, known, options).coefficients;
    EXPECT_EQ(calls, 1);
    for (std::size_t c = 0; c < truth.warps.size(); ++c)
        EXPECT_NEAR(found.warps[c], truth.warps[c], 0.02 * std::abs(truth.warps[0]) + 0.1);
}

TEST(CompleteTexture, DoesNotDependOnWhatGuttersHold)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    const std::vector<std::uint8_t> known = knownOutsideOfABand(model->texels);
    Image texture = withHoles(decoder.decode(coefficientsOf(*model, 4)), known);
    const AppearanceCoefficients expected = completeTexture(decoder, texture, known).coefficients;
    for (std::size_t t = 0; t < model->texels.texels.size(); ++t) {
        if (model->texels.covered[t] == 0)
            std::fill_n(texture.pixels.data() + std::size_t{4} * model->texels.texels[t], 3, std::uint8_t{0});
    }
    EXPECT_EQ(completeTexture(decoder, texture, known).coefficients, expected);
}

TEST(CompleteTexture, GivesTheMeanWhereNothingIsKnown)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    const std::vector<std::uint8_t> known(static_cast<std::size_t>(160 * 96), 0);
    const CompletedTexture completed = completeTexture(decoder, Image(160, 96), known);
    EXPECT_EQ(completed.texture, decoder.decode({}));
    for (const float coefficient : completed.coefficients.textures)
        EXPECT_EQ(coefficient, 0);
}

TEST(CompleteTexture, LeavesATextureThatIsWholeAsItIs)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    Image texture = decoder.decode(coefficientsOf(*model, 1));
    texture.pixel(0, 0)[1] = 77; // not used
    texture.pixel(45, 48)[2] ^= 255;
    const std::vector<std::uint8_t> known(static_cast<std::size_t>(160 * 96), 1);
    EXPECT_EQ(completeTexture(decoder, texture, known).texture, texture);
}

TEST(CompleteTexture, ShowsNoSeamWhereATextureIsBrighterThanItsModel)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    std::vector<std::uint8_t> known(static_cast<std::size_t>(160 * 96), 1);
    for (int y = 42; y < 54; ++y)
        std::fill_n(known.begin() + y * 160 + 39, 12, std::uint8_t{0});
    Image texture = decoder.decode({});
    for (int y = 30; y < 66; ++y) {
        for (int x = 27; x < 63; ++x)
            for (int c = 0; c < 3; ++c)
                texture.pixel(x, y)[c] = static_cast<std::uint8_t>(texture.pixel(x, y)[c] + 12);
    }
    const Image completed = completeTexture(decoder, withHoles(texture, known), known, {.rounds = 0}).texture;
    const Image plain =
        completeTexture(decoder, withHoles(texture, known), known, {.rounds = 0, .blend = 2}).texture;
    const auto excess = [&](const Image& image, int x, int y) {
        return int{image.pixel(x, y)[0]} - int{texture.pixel(x, y)[0]};
    };
    EXPECT_NEAR(excess(completed, 39, 48), 0, 2); // next to the border
    EXPECT_LT(excess(completed, 45, 48), -5);     // six texels from it
    EXPECT_LT(excess(plain, 41, 48), -5);         // three
    EXPECT_GT(excess(completed, 41, 48), excess(plain, 41, 48) + 3);
}

TEST(CompleteTexture, SpreadsDifferencesWithinCharts)
{
    // Two charts beside each other; half of the first is missing, and the second is brighter than the model.
    AppearanceSpaces spaces{.texels = {.width = 12, .height = 4, .chartCount = 2}};
    for (std::uint32_t texel = 0; texel < 48; ++texel) {
        spaces.texels.texels.push_back(texel);
        spaces.texels.charts.push_back(texel % 12 < 6 ? 0 : 1);
        spaces.texels.covered.push_back(1);
        spaces.textures.mean.insert(spaces.textures.mean.end(), {100, 100, 100});
    }
    const auto model = std::make_shared<const AppearanceModel>(quantised(spaces));
    const AppearanceDecoder decoder(model);
    Image texture = decoder.decode({});
    std::vector<std::uint8_t> known(48, 1);
    for (int y = 0; y < 4; ++y) {
        for (int x = 3; x < 12; ++x) {
            known[static_cast<std::size_t>(12 * y + x)] = x < 6 ? 0 : 1;
            texture.pixel(x, y)[0] = 150;
        }
    }
    EXPECT_EQ(completeTexture(decoder, texture, known).texture.pixel(5, 2)[0], 100);
    EXPECT_EQ(completeTexture(decoder, texture, known).texture.pixel(6, 2)[0], 150);
}

TEST(CompleteTexture, ReturnsToTheMeanWarpWhereTexelsTellNothing)
{
    AppearanceModel flat = modelOfWaves();
    std::ranges::fill(flat.textures.mean, flat.textures.mean.front());
    std::ranges::fill(flat.textures.scales, 0.0F);
    const auto model = std::make_shared<const AppearanceModel>(flat);
    const AppearanceDecoder decoder(model);
    const std::vector<float> warps = coefficientsOf(*model, 5).warps;
    const CompletionOptions options{.warpNoise = 0.1, .estimate = [&](const Image&, const Image&, auto) {
                                        return combined(model->warps, warps);
                                    }};
    const std::vector<std::uint8_t> known(static_cast<std::size_t>(160 * 96), 1);
    const AppearanceCoefficients found =
        completeTexture(decoder, decoder.decode({}), known, options).coefficients;
    EXPECT_GT(std::abs(warps[0]), 10);
    EXPECT_LT(std::abs(found.warps[0]), 0.01);
}

TEST(CompleteTexture, WorksWithoutWarps)
{
    AppearanceModel model = modelOfWaves();
    model.warps = {};
    model.grid = {};
    const auto still = std::make_shared<const AppearanceModel>(model);
    const AppearanceDecoder decoder(still);
    const std::vector<std::uint8_t> known = knownOutsideOfABand(still->texels);
    AppearanceCoefficients frame = coefficientsOf(modelOfWaves(), 2);
    frame.warps.clear();
    const Image truth = decoder.decode(frame);
    const CompletedTexture completed = completeTexture(decoder, withHoles(truth, known), known);
    EXPECT_LT(pictureQuality(truth, completed.texture, missingOf(known, still->texels)).meanSquaredError, 1);
}

TEST(CompleteTexture, StopsWhenCancelled)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder decoder(model);
    CancelToken token;
    token.cancel();
    const Image texture = decoder.decode(coefficientsOf(*model, 1));
    EXPECT_EQ(codeOf([&] {
                  completeTexture(decoder, texture, knownOutsideOfABand(model->texels), {}, Progress(token));
              }),
              ErrorCode::Cancelled);
}

TEST(LikeliestCoefficients, WeighsKnownValuesAgainstVariances)
{
    // One component of two values (0.6, 0.8) with variance 4; only the second value is known: 2 above the
    // mean.
    const QuantisedSpace space =
        quantised(LinearSpace{.mean = {10, 10}, .components = {0.6F, 0.8F}, .eigenvalues = {4, 0.5}});
    EXPECT_DOUBLE_EQ(unexplainedVariance(space, 0.5), 0.5 * 0.5 + 0.5 / 2);
    const std::vector<float> sample{99, 12};
    const Eigen::VectorXd found = likeliestCoefficients(space, sample, std::vector<std::uint8_t>{0, 1}, 0.5);
    EXPECT_NEAR(found(0), 0.8 * 2 / (0.64 + 0.5 / 4), 1e-3); // the mean has steps of 0.0003
    EXPECT_EQ(likeliestCoefficients(space, sample, std::vector<std::uint8_t>{0, 0}, 0.5)(0), 0);
}

} // namespace

} // namespace quadrille
