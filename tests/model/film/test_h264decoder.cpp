// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/h264decoder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// A soft pattern that moves to the right.
Image wave(int frame)
{
    Image picture(64, 48);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double grey = 128 + 60 * std::sin(0.2 * (x - frame)) + 40 * std::sin(0.35 * y);
            std::fill_n(picture.pixel(x, y), 3, static_cast<std::uint8_t>(grey));
            picture.pixel(x, y)[3] = 255;
        }
    }
    return picture;
}

struct Coded
{
    std::size_t bytes = 0;
    double error = 0; ///< mean square
};

Coded coded(int quantizer)
{
    H264Encoder encoder({64, 48, 25, 6}, {}, quantizer);
    H264Decoder decoder(encoder);
    Coded all;
    for (int frame = 0; frame < 6; ++frame) {
        const Image picture = wave(frame);
        const CompressedPicture compressed = encoder.encode(picture);
        const Image back = decoder.decode(compressed);
        EXPECT_EQ(back.pixels.size(), picture.pixels.size());
        all.bytes += compressed.bytes.size();
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            all.error += std::pow(back.pixels[i] - picture.pixels[i], 2) / (64.0 * 48 * 4 * 6);
    }
    return all;
}

} // namespace

TEST(H264Decoder, GivesBackWhatWasWritten)
{
    const Coded fine = coded(16);
    const Coded coarse = coded(40);
    EXPECT_LT(fine.error, 4);
    EXPECT_GT(coarse.error, 2 * fine.error);
    EXPECT_LT(coarse.bytes, fine.bytes / 3);
}
