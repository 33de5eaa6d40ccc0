// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/image.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/imagecheck.h"
#include "model/core/imagecoding.h"
#include "model/core/jpeg.h"
#include "model/core/message.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace quadrille {

namespace {

bool namesJpeg(std::string extension)
{
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".jpg" || extension == ".jpeg" || extension == ".jpe";
}

/// Samples of 8 or 16 bits as sRGB of 8. \param samples  the fourth channel is opacity, which no curve codes.
template <typename Sample>
cv::Mat inSrgb(const cv::Mat& samples, double exponent)
{
    constexpr int levels = std::numeric_limits<Sample>::max() + 1;
    const std::vector<std::uint8_t> srgb = srgbOfSamples(exponent, levels);
    cv::Mat coded;
    samples.convertTo(coded, CV_8U, 255.0 / (levels - 1));
    const int channels = samples.channels();
    for (int row = 0; row < samples.rows; ++row) {
        const auto* from = samples.ptr<Sample>(row);
        auto* to = coded.ptr<std::uint8_t>(row);
        for (int i = 0; i < samples.cols * channels; ++i)
            if (i % channels != 3)
                to[i] = srgb[from[i]];
    }
    return coded;
}

} // namespace

Image::Image(int w, int h)
    : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4)
{
}

std::uint8_t* Image::pixel(int x, int y)
{
    return pixels.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
}

const std::uint8_t* Image::pixel(int x, int y) const
{
    return const_cast<Image*>(this)->pixel(x, y);
}

std::string sizeText(int width, int height)
{
    return std::to_string(width) + " × " + std::to_string(height);
}

Image readImage(const std::filesystem::path& path, ColourMarks marks)
{
    const FileContent file = readFile(path);
    return decodeImage(file.bytes(), path, marks);
}

Image decodeImage(std::span<const std::byte> encoded, const std::filesystem::path& path, ColourMarks marks)
{
    if (encoded.size() > std::numeric_limits<int>::max())
        throw Error(ErrorCode::ImageUnreadable, {path, {}, {}});
    checkEncodedImage(encoded, path);
    if (encoded.front() == std::byte{0xFF}) // no other format starts so
        if (std::optional<Image> image = decodeJpeg(encoded))
            return *std::move(image);
    const cv::Mat bytes(1, static_cast<int>(encoded.size()), CV_8U, const_cast<std::byte*>(encoded.data()));
    cv::Mat decoded;
    try {
        decoded = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
        decoded.release();
    }
    if (decoded.empty())
        throw Error(ErrorCode::ImageUnreadable, {path, {}, {}});
    const auto exponent = marks == ColourMarks::Followed ? codingExponent(encoded) : std::nullopt;
    if (exponent && decoded.depth() == CV_8U)
        decoded = inSrgb<std::uint8_t>(decoded, *exponent);
    else if (exponent && decoded.depth() == CV_16U)
        decoded = inSrgb<std::uint16_t>(decoded, *exponent);
    if (decoded.depth() == CV_16U)
        decoded.convertTo(decoded, CV_8U, 1.0 / 257.0);
    if (decoded.depth() != CV_8U) {
        throw Error(ErrorCode::FormatRefused,
                    {path,
                     {},
                     {{"format", QUADRILLE_MESSAGE("A picture of floating-point numbers")},
                      {"remedy", QUADRILLE_MESSAGE("Save it with 8 or 16 bits a channel.")}}});
    }
    Image image(decoded.cols, decoded.rows);
    cv::Mat target(decoded.rows, decoded.cols, CV_8UC4, image.pixels.data());
    switch (decoded.channels()) {
    case 1:
        cv::cvtColor(decoded, target, cv::COLOR_GRAY2RGBA);
        break;
    case 3:
        cv::cvtColor(decoded, target, cv::COLOR_BGR2RGBA);
        break;
    case 4:
        cv::cvtColor(decoded, target, cv::COLOR_BGRA2RGBA);
        break;
    default:
        throw Error(ErrorCode::ImageUnreadable, {path, {}, {}});
    }
    return image;
}

std::vector<std::byte> encodeImage(const Image& image, const std::string& extension, int jpegQuality)
{
    if (namesJpeg(extension))
        if (auto encoded = encodeJpeg(image, jpegQuality))
            return *std::move(encoded);
    const cv::Mat source(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
    cv::Mat encodable;
    cv::cvtColor(source, encodable, cv::COLOR_RGBA2BGRA);
    std::vector<unsigned char> encoded;
    bool known = false;
    try {
        known = cv::imencode(extension, encodable, encoded, {cv::IMWRITE_JPEG_QUALITY, jpegQuality});
    } catch (const cv::Exception&) {
        known = false;
    }
    if (!known)
        throw Error(ErrorCode::FormatUnknown, {std::filesystem::path(extension), {}, {}});
    const auto bytes = std::as_bytes(std::span(encoded));
    return {bytes.begin(), bytes.end()};
}

void writeImage(const Image& image, const std::filesystem::path& path, int jpegQuality)
{
    std::vector<std::byte> encoded;
    try {
        encoded = encodeImage(image, path.extension().string(), jpegQuality);
    } catch (const Error& error) {
        throw Error(error.code(), {path, {}, {}});
    }
    writeAtomically(path, std::string_view(reinterpret_cast<const char*>(encoded.data()), encoded.size()));
}

} // namespace quadrille
