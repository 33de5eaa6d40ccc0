// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/texturequality.h"
#include "model/core/random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/quality/qualityssim.hpp>

namespace quadrille {

namespace {

/// Waves and noise; the second of two like ones has other noise.
Image wavyPicture(int width, int height, double noise, std::uint64_t seed, bool isGrey = false)
{
    Random random(seed);
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 4; ++c) {
                const double value = 120 + 70 * std::sin(0.3 * x + (isGrey ? 0 : c)) * std::cos(0.11 * y) +
                                     noise * random.normal();
                image.pixel(x, y)[c] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
            }
            if (isGrey)
                std::fill_n(image.pixel(x, y), 3, image.pixel(x, y)[0]);
        }
    }
    return image;
}

double lumaOf(const Image& image, int x, int y)
{
    const std::uint8_t* pixel = image.pixel(x, y);
    return 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
}

/// SSIM about a pixel, as it is written.
double plainSimilarity(const Image& a, const Image& b, const std::vector<std::uint8_t>& mask, int x, int y)
{
    double sum = 0;
    double meanA = 0;
    double meanB = 0;
    double squareA = 0;
    double squareB = 0;
    double product = 0;
    for (int v = std::max(0, y - 5); v <= std::min(a.height - 1, y + 5); ++v) {
        for (int u = std::max(0, x - 5); u <= std::min(a.width - 1, x + 5); ++u) {
            if (mask[static_cast<std::size_t>(v * a.width + u)] == 0)
                continue;
            const double weight = std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * 1.5 * 1.5));
            const double p = lumaOf(a, u, v);
            const double q = lumaOf(b, u, v);
            sum += weight;
            meanA += weight * p;
            meanB += weight * q;
            squareA += weight * p * p;
            squareB += weight * q * q;
            product += weight * p * q;
        }
    }
    meanA /= sum;
    meanB /= sum;
    const double spreads = squareA / sum - meanA * meanA + squareB / sum - meanB * meanB;
    const double covariance = product / sum - meanA * meanB;
    const double c1 = 2.55 * 2.55;
    const double c2 = 7.65 * 7.65;
    return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
           ((meanA * meanA + meanB * meanB + c1) * (spreads + c2));
}

TEST(PictureQuality, IsPerfectForTheSamePicture)
{
    const Image image = wavyPicture(40, 30, 20, 1);
    const PictureQuality quality = pictureQuality(image, image);
    EXPECT_NEAR(quality.similarity, 1, 1e-6);
    EXPECT_EQ(quality.meanSquaredError, 0);
}

TEST(PictureQuality, OfEvenPicturesIsThatOfTheirMeans)
{
    Image black(20, 20);
    Image grey(20, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 20; ++x)
            std::fill_n(grey.pixel(x, y), 3, std::uint8_t{10});
    }
    const PictureQuality quality = pictureQuality(black, grey);
    EXPECT_NEAR(quality.similarity, 6.5025 / (100 + 6.5025), 1e-4); // C1 / (µ² + C1)
    EXPECT_EQ(quality.meanSquaredError, 100);
}

TEST(PictureQuality, CountsTheErrorsOfRedGreenAndBlueOnly)
{
    Image first(2, 1);
    Image second(2, 1);
    second.pixel(0, 0)[0] = 6;
    second.pixel(1, 0)[2] = 3;
    second.pixel(1, 0)[3] = 200;
    EXPECT_DOUBLE_EQ(pictureQuality(first, second).meanSquaredError, 45.0 / 6);
    EXPECT_DOUBLE_EQ(pictureQuality(first, second, std::vector<std::uint8_t>{0, 1}).meanSquaredError, 3);
}

TEST(PictureQuality, IsThatOfOpenCvAwayFromBorders)
{
    Image first = wavyPicture(90, 70, 5, 1, true);
    Image second = wavyPicture(90, 70, 25, 2, true);
    const auto greyOf = [](const Image& image) {
        cv::Mat grey(image.height, image.width, CV_8UC1);
        for (std::size_t i = 0; i < image.pixels.size() / 4; ++i)
            grey.data[i] = image.pixels[4 * i];
        return grey;
    };
    cv::Mat expected;
    cv::quality::QualitySSIM::compute(greyOf(first), greyOf(second), expected);
    ASSERT_EQ(expected.type(), CV_32FC1);
    const std::vector<float> map = similarityMap(first, second);
    double lowest = 1;
    for (int y = 5; y < 65; ++y) {
        for (int x = 5; x < 85; ++x) {
            const float value = map[static_cast<std::size_t>(y * 90 + x)];
            EXPECT_NEAR(value, expected.at<float>(y, x), 2e-4); // both in single precision
            lowest = std::min(lowest, static_cast<double>(value));
        }
    }
    EXPECT_LT(lowest, 0.5);
}

TEST(PictureQuality, IsThatOfPlainLoopsWithAndWithoutMask)
{
    const Image first = wavyPicture(45, 33, 5, 3);
    const Image second = wavyPicture(45, 33, 30, 4);
    Random random(7);
    for (const bool isMasked : {false, true}) {
        std::vector<std::uint8_t> mask(45 * 33, 1);
        for (std::size_t i = 0; isMasked && i < mask.size(); ++i)
            mask[i] = i % 45 > 20 && i / 45 > 7 && i / 45 < 30 && random.unit() < 0.6 ? 255 : 0;
        const std::vector<float> map =
            similarityMap(first, second, isMasked ? mask : std::vector<std::uint8_t>{});
        double sum = 0;
        int count = 0;
        for (int y = 0; y < 33; ++y) {
            for (int x = 0; x < 45; ++x) {
                const auto at = static_cast<std::size_t>(y * 45 + x);
                const double expected = mask[at] == 0 ? 0 : plainSimilarity(first, second, mask, x, y);
                EXPECT_NEAR(map[at], expected, 2e-5); // sums in single precision
                sum += expected;
                count += mask[at] != 0 ? 1 : 0;
            }
        }
        EXPECT_NEAR(pictureQuality(first, second, mask).similarity, sum / count, 1e-5);
    }
}

TEST(PictureQuality, DoesNotDependOnWhatIsOutsideOfTheMask)
{
    const Image first = wavyPicture(30, 30, 5, 3);
    Image second = wavyPicture(30, 30, 30, 4);
    std::vector<std::uint8_t> mask(900, 0);
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = i % 30 < 12 ? 1 : 0;
    const PictureQuality before = pictureQuality(first, second, mask);
    for (int y = 0; y < 30; ++y)
        std::fill_n(second.pixel(12, y), 18 * 4, std::uint8_t{0});
    const PictureQuality after = pictureQuality(first, second, mask);
    EXPECT_EQ(before.similarity, after.similarity);
    EXPECT_EQ(before.meanSquaredError, after.meanSquaredError);
}

TEST(PictureQuality, IsSymmetric)
{
    const Image first = wavyPicture(30, 20, 5, 3);
    const Image second = wavyPicture(30, 20, 30, 4);
    EXPECT_NEAR(pictureQuality(first, second).similarity, pictureQuality(second, first).similarity, 1e-6);
}

TEST(PictureQuality, OfNothingIsPerfect)
{
    const Image image = wavyPicture(8, 8, 20, 1);
    const Image other = wavyPicture(8, 8, 20, 2);
    EXPECT_EQ(pictureQuality(image, other, std::vector<std::uint8_t>(64, 0)).similarity, 1);
    EXPECT_EQ(pictureQuality({}, {}).similarity, 1);
    EXPECT_NEAR(pictureQuality(Image(1, 1), Image(1, 1)).similarity, 1,
                1e-4); // squares of 128 in single precision
}

TEST(PictureQuality, OfTexturesCountsCoveredTexels)
{
    const Image first = wavyPicture(10, 4, 20, 1);
    const Image second = wavyPicture(10, 4, 20, 2);
    const UsedTexels used{.width = 10,
                          .height = 4,
                          .texels = {3, 11, 12, 13, 25},
                          .charts = {0, 0, 0, 0, 0},
                          .covered = {0, 1, 1, 1, 1},
                          .chartCount = 1};
    std::vector<std::uint8_t> mask(40, 0);
    for (const int texel : {11, 12, 13, 25})
        mask[static_cast<std::size_t>(texel)] = 1;
    EXPECT_EQ(coveredMask(used), mask);
    EXPECT_EQ(textureQuality(first, second, used).similarity, pictureQuality(first, second, mask).similarity);
}

} // namespace

} // namespace quadrille
