// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/image.h"
#include "model/core/imagecoding.h"
#include "tests/model/markedpng.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

using namespace quadrille;
using ::testing::ElementsAre;

namespace {

constexpr std::uint32_t linear = 100'000;

/// All values of 8 bits in red, others in green and blue, opacity as in red.
Image ramp()
{
    Image image(256, 1);
    for (int x = 0; x < 256; ++x) {
        image.pixel(x, 0)[0] = static_cast<std::uint8_t>(x);
        image.pixel(x, 0)[1] = static_cast<std::uint8_t>(255 - x);
        image.pixel(x, 0)[2] = static_cast<std::uint8_t>(x / 2);
        image.pixel(x, 0)[3] = static_cast<std::uint8_t>(x);
    }
    return image;
}

std::vector<std::byte> pngOf(const cv::Mat& picture)
{
    std::vector<unsigned char> encoded;
    cv::imencode(".png", picture, encoded);
    const auto bytes = std::as_bytes(std::span(encoded));
    return {bytes.begin(), bytes.end()};
}

/// The curve as the standard has it.
double srgbOf(double light)
{
    return light <= 0.0031308 ? 255 * 12.92 * light : 255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

} // namespace

TEST(ImageCoding, LinearSamplesBecomeSrgb)
{
    const Image stored = ramp();
    const Image image = decodeImage(test::withPngGamma(encodeImage(stored, ".png"), linear));
    ASSERT_EQ(image.width, 256);
    for (int x = 0; x < 256; ++x) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.pixel(x, 0)[c], srgbOf(stored.pixel(x, 0)[c] / 255.0), 0.501) << x;
        EXPECT_EQ(image.pixel(x, 0)[3], x);
    }
    EXPECT_EQ(image.pixel(55, 0)[0], 128); // a fifth of the light
    EXPECT_EQ(image.pixel(128, 0)[0], 188);
}

TEST(ImageCoding, SamplesOf16BitsKeepTheirDepthUntilTheyAreCoded)
{
    // In 8 bits the first three would all be 0.
    const std::vector<std::uint16_t> values{30, 60, 120, 257, 13107, 65535};
    cv::Mat grey(1, static_cast<int>(values.size()), CV_16UC1);
    std::ranges::copy(values, grey.ptr<std::uint16_t>());
    const Image image = decodeImage(test::withPngGamma(pngOf(grey), linear));
    std::vector<int> found;
    for (int x = 0; x < image.width; ++x) {
        found.push_back(image.pixel(x, 0)[0]);
        EXPECT_EQ(image.pixel(x, 0)[2], image.pixel(x, 0)[0]);
        EXPECT_EQ(image.pixel(x, 0)[3], 255);
        EXPECT_NEAR(found.back(), srgbOf(values[static_cast<std::size_t>(x)] / 65535.0), 0.501);
    }
    EXPECT_THAT(found, ElementsAre(2, 3, 6, 13, 124, 255));
}

TEST(ImageCoding, OpacityOf16BitsIsNoLight)
{
    cv::Mat colour(1, 2, CV_16UC4, cv::Scalar(0, 13107, 65535, 32896)); // blue, green, red, opacity
    const Image image = decodeImage(test::withPngGamma(pngOf(colour), linear));
    EXPECT_THAT(std::vector<int>(image.pixel(1, 0), image.pixel(1, 0) + 4), ElementsAre(255, 124, 0, 128));
}

TEST(ImageCoding, WhatIsSrgbOrSaysNothingStaysAsItIs)
{
    const Image stored = ramp();
    const auto png = encodeImage(stored, ".png");
    EXPECT_EQ(decodeImage(png), stored);
    for (const std::uint32_t exponent : {45'455U, 45'000U, 46'000U, 0U, 1U, 4'000'000'000U})
        EXPECT_EQ(decodeImage(test::withPngGamma(png, exponent)), stored) << exponent;
    const auto marked = test::withPngGamma(png, linear);
    EXPECT_EQ(decodeImage(test::withPngChunk(marked, "sRGB", std::string_view("\0", 1))), stored);
    EXPECT_EQ(decodeImage(test::withPngChunk(marked, "cICP", std::string_view("\1\15\0\1", 4))), stored);
    EXPECT_EQ(decodeImage(marked, {}, ColourMarks::Ignored), stored);
    EXPECT_NE(decodeImage(marked), stored);
}

TEST(ImageCoding, OtherExponentsAreFollowed)
{
    const Image image = decodeImage(test::withPngGamma(encodeImage(ramp(), ".png"), 55'556)); // 1 / 1.8
    for (int x = 0; x < 256; ++x)
        EXPECT_NEAR(image.pixel(x, 0)[0], srgbOf(std::pow(x / 255.0, 1.8)), 0.501) << x;
}

TEST(ImageCoding, OnlyWholeChunksBeforeThePixelsCount)
{
    const auto png = encodeImage(ramp(), ".png");
    EXPECT_EQ(codingExponent(test::withPngGamma(png, linear)), 1);
    EXPECT_EQ(codingExponent(png), std::nullopt);
    EXPECT_EQ(codingExponent(test::withPngChunk(png, "gAMA", "abc")), std::nullopt);
    EXPECT_EQ(codingExponent(encodeImage(ramp(), ".jpg")), std::nullopt);
    const auto marked = test::withPngGamma(png, linear);
    EXPECT_EQ(codingExponent(test::withPngChunk(marked, "iCCP", "abc")), std::nullopt);
    EXPECT_EQ(codingExponent(std::span(marked).first(33 + 15)), std::nullopt) << "without its checksum";
    EXPECT_EQ(codingExponent(std::span(marked).first(33 + 16)), 1);
    for (std::size_t length = 0; length < marked.size(); ++length)
        codingExponent(std::span(marked).first(length)); // reads nothing behind the end
    auto behind = png;
    const auto chunk = test::withPngGamma(png, linear);
    behind.insert(behind.end() - 12, chunk.begin() + 33, chunk.begin() + 33 + 16); // before IEND
    EXPECT_EQ(codingExponent(behind), std::nullopt);
}
