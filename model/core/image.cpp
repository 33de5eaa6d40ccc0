// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/image.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/imagecheck.h"
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

Image readImage(const std::filesystem::path& path)
{
    const FileContent file = readFile(path);
    return decodeImage(file.bytes(), path);
}

Image decodeImage(std::span<const std::byte> encoded, const std::filesystem::path& path)
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
