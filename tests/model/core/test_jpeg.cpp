// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// JPEG files, as OpenCV reads and writes them.
#include "model/core/error.h"
#include "model/core/jpeg.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <turbojpeg.h>

using namespace quadrille;

namespace {

using Encoded = std::vector<std::byte>;

Image colourful(int width, int height)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            std::uint8_t* const pixel = image.pixel(x, y);
            pixel[0] = static_cast<std::uint8_t>(127 + 120 * std::sin(0.3 * x + 0.1 * y));
            pixel[1] = static_cast<std::uint8_t>(127 + 120 * std::cos(0.2 * x - 0.4 * y));
            pixel[2] = static_cast<std::uint8_t>(x * 7 + y * 13);
            pixel[3] = 255;
        }
    }
    return image;
}

/// \param format, sampling, flags  of TurboJPEG.
Encoded encodedAs(const Image& image, int format, int sampling, int flags = 0)
{
    const std::unique_ptr<void, int (*)(tjhandle)> turbo(tjInitCompress(), tjDestroy);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(turbo.get(), image.pixels.data(), image.width, 0, image.height, format, &buffer,
                          &size, sampling, 90, flags),
              0);
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(buffer, tjFree);
    const auto* const bytes = reinterpret_cast<const std::byte*>(buffer);
    return {bytes, bytes + size};
}

Image byOpenCv(Encoded encoded)
{
    const cv::Mat bytes(1, static_cast<int>(encoded.size()), CV_8U, encoded.data());
    const cv::Mat decoded = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
    Image image(decoded.cols, decoded.rows);
    const cv::Mat target(decoded.rows, decoded.cols, CV_8UC4, image.pixels.data());
    cv::cvtColor(decoded, target, decoded.channels() == 1 ? cv::COLOR_GRAY2RGBA : cv::COLOR_BGR2RGBA);
    return image;
}

} // namespace

TEST(Jpeg, HasThePixelsThatOpenCvReads)
{
    // Sizes within and across blocks.
    for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {16, 24}, {37, 51}, {203, 16}}) {
        const Image image = colourful(width, height);
        for (const int sampling : {TJSAMP_444, TJSAMP_422, TJSAMP_420, TJSAMP_440, TJSAMP_411, TJSAMP_GRAY}) {
            for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
                const Encoded encoded = encodedAs(image, TJPF_RGBX, sampling, flags);
                const auto decoded = decodeJpeg(encoded);
                ASSERT_TRUE(decoded);
                EXPECT_EQ(*decoded, byOpenCv(encoded)) << width << " × " << height << ", " << sampling;
            }
        }
    }
}

TEST(Jpeg, HasTheBytesThatOpenCvWrites)
{
    for (const int quality : {1, 50, 86, 95, 100}) {
        Image image = colourful(37, 51);
        const auto encoded = encodeJpeg(image, quality);
        ASSERT_TRUE(encoded);
        const cv::Mat source(image.height, image.width, CV_8UC4, image.pixels.data());
        cv::Mat ordered;
        cv::cvtColor(source, ordered, cv::COLOR_RGBA2BGRA);
        std::vector<unsigned char> expected;
        cv::imencode(".jpg", ordered, expected, {cv::IMWRITE_JPEG_QUALITY, quality});
        const auto expectedBytes = std::as_bytes(std::span(expected));
        EXPECT_TRUE(std::equal(encoded->begin(), encoded->end(), expectedBytes.begin(), expectedBytes.end()))
            << quality << ": " << encoded->size() << " and " << expected.size();
    }
}

TEST(Jpeg, InPrintersColoursIsLeftToOpenCv)
{
    const Encoded encoded = encodedAs(colourful(37, 51), TJPF_CMYK, TJSAMP_444);
    EXPECT_FALSE(decodeJpeg(encoded));
    EXPECT_EQ(decodeImage(encoded), byOpenCv(encoded));
}

TEST(Jpeg, IsNotTurnedByItsMetadata)
{
    // An APP1 segment whose only entry, 0x0112, asks for a quarter turn (6).
    static constexpr unsigned char exif[] = {0xFF, 0xE1, 0, 34, 'E', 'x', 'i', 'f', 0, 0,    'M', 'M',
                                             0,    42,   0, 0,  0,   8,   0,   1,   1, 0x12, 0,   3,
                                             0,    0,    0, 1,  0,   6,   0,   0,   0, 0,    0,   0};
    const Image image = colourful(40, 24);
    Encoded encoded = encodedAs(image, TJPF_RGBX, TJSAMP_420);
    const Image straight = decodeImage(encoded);
    const auto segment = std::as_bytes(std::span(exif));
    encoded.insert(encoded.begin() + 2, segment.begin(), segment.end());
    EXPECT_EQ(decodeImage(encoded), straight);
    // OpenCV would turn it if it were asked to.
    const cv::Mat bytes(1, static_cast<int>(encoded.size()), CV_8U, encoded.data());
    EXPECT_EQ(cv::imdecode(bytes, cv::IMREAD_COLOR).cols, 24);
}

TEST(Jpeg, WithWarningsIsRead)
{
    // A byte between the segments that belongs to none of them.
    Encoded encoded = encodedAs(colourful(40, 24), TJPF_RGBX, TJSAMP_420);
    const Image image = decodeImage(encoded);
    encoded.insert(encoded.begin() + 20, std::byte{7});
    EXPECT_EQ(decodeImage(encoded), image);
}

TEST(Jpeg, OfScansWithoutAnEndIsRefused)
{
    // The last scan of a progressive picture, again and again.
    Encoded encoded = encodedAs(colourful(40, 24), TJPF_RGBX, TJSAMP_420, TJFLAG_PROGRESSIVE);
    std::size_t last = 0;
    for (std::size_t at = 0; at + 1 < encoded.size(); ++at)
        if (encoded[at] == std::byte{0xFF} && encoded[at + 1] == std::byte{0xDA})
            last = at;
    const Encoded scan(encoded.begin() + static_cast<std::ptrdiff_t>(last), encoded.end() - 2);
    for (int i = 0; i < 600; ++i)
        encoded.insert(encoded.end() - 2, scan.begin(), scan.end());
    try {
        decodeImage(encoded, "scans.jpg");
        ADD_FAILURE() << "it is read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::ImageUnreadable);
        EXPECT_EQ(error.context().file, "scans.jpg");
    }
}

TEST(Jpeg, WiderThanTheFormatAllowsIsNotWritten)
{
    EXPECT_FALSE(encodeJpeg(Image(70'000, 1), 95));
    EXPECT_THROW(encodeImage(Image(70'000, 1), ".jpg"), Error);
}

TEST(Jpeg, IsWrittenWhateverTheEndingLooksLike)
{
    const Image image = colourful(16, 16);
    for (const char* const ending : {".JPG", ".jpeg", ".jpe"})
        EXPECT_EQ(encodeImage(image, ending), encodeImage(image, ".jpg")) << ending;
}
