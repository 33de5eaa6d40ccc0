// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace quadrille;
using ::testing::HasSubstr;

namespace {

/// A picture with enough detail to be some kilobytes in every format.
Image detailed()
{
    Image image(64, 48);
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        state = state * 1664525U + 1013904223U;
        image.pixels[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(state >> 24U);
    }
    return image;
}

std::span<const std::byte> bytesOf(std::string_view text)
{
    return std::as_bytes(std::span(text));
}

/// The error of decoding; null where it succeeds.
std::unique_ptr<Error> errorOf(std::span<const std::byte> encoded)
{
    try {
        decodeImage(encoded, "picture.png");
    } catch (const Error& error) {
        EXPECT_EQ(error.context().file, "picture.png");
        EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("{")));
        return std::make_unique<Error>(error);
    }
    return nullptr;
}

void put(std::vector<std::byte>& bytes, std::size_t at, std::initializer_list<unsigned> values)
{
    for (const unsigned value : values)
        bytes.at(at++) = static_cast<std::byte>(value);
}

class EncodedImage : public ::testing::TestWithParam<const char*>
{
protected:
    std::vector<std::byte> encoded() const { return encodeImage(detailed(), GetParam()); }
};

} // namespace

TEST_P(EncodedImage, ComesBack)
{
    const Image image = decodeImage(encoded());
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 48);
    const bool isExact = std::string_view(GetParam()) != ".jpg";
    EXPECT_TRUE(!isExact || image == detailed());
}

TEST_P(EncodedImage, IsRefusedWhereItIsCut)
{
    const auto whole = encoded();
    for (std::size_t length = 0; length < whole.size(); length += whole.size() / 150 + 1)
        EXPECT_TRUE(errorOf(std::span(whole).first(length))) << length << " of " << whole.size();
    EXPECT_TRUE(errorOf(std::span(whole).first(whole.size() - 1)));
}

TEST_P(EncodedImage, NeverFailsOtherwiseWhereAByteIsWrong)
{
    const auto whole = encoded();
    for (std::size_t at = 0; at < whole.size(); at += at < 200 ? 1 : whole.size() / 150 + 1) {
        auto wrong = whole;
        wrong[at] ^= std::byte{0xFF};
        EXPECT_NO_THROW(errorOf(wrong)) << at;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, EncodedImage, ::testing::Values(".png", ".jpg", ".tif"),
                         [](const auto& format) { return std::string(format.param + 1); });

TEST(Image, AnAbsurdSizeIsNotBelieved)
{
    auto png = encodeImage(detailed(), ".png");
    put(png, 16, {0x7F, 0xFF, 0xFF, 0xFF});
    const auto wide = errorOf(png);
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->code(), ErrorCode::CountTooLarge);
    EXPECT_THAT(wide->what(), HasSubstr("2147483647 × 48"));
    put(png, 16, {0, 0, 0x60, 0, 0, 0, 0x60, 0});
    ASSERT_TRUE(errorOf(png));
    EXPECT_EQ(errorOf(png)->code(), ErrorCode::CountTooLarge);

    auto jpeg = encodeImage(detailed(), ".jpg");
    for (std::size_t at = 2; at + 9 < jpeg.size(); ++at) {
        if (jpeg[at] == std::byte{0xFF} && jpeg[at + 1] == std::byte{0xC0}) {
            put(jpeg, at + 5, {0xFF, 0xFF, 0xFF, 0xFF});
            break;
        }
    }
    ASSERT_TRUE(errorOf(jpeg));
    EXPECT_EQ(errorOf(jpeg)->code(), ErrorCode::CountTooLarge);
}

TEST(Image, OtherContentIsRefused)
{
    for (const std::string_view content :
         {"", "x", "hello, I am text", "BM\x46\0\0\0\0\0", "GIF89a\1\0\1\0", "RIFF\x24\0\0\0WEBPVP8 "}) {
        const auto error = errorOf(bytesOf(content));
        ASSERT_TRUE(error) << content;
        EXPECT_EQ(error->code(), ErrorCode::ImageUnreadable) << content;
    }
}

TEST(Image, ATiffDirectoryThatIsNotThereIsAnEarlyEnd)
{
    const auto error = errorOf(bytesOf(std::string_view("II*\0\xFF\xFF\xFF\xFF", 8)));
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), ErrorCode::FileTruncated);
}
