// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/largeblocks.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// 8-bit RGBA picture, rows from top to bottom.
struct Image
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t, LargeBlocks<std::uint8_t>> pixels; ///< height × width × 4, R G B A

    Image() = default;
    Image(int w, int h);
    bool isEmpty() const { return pixels.empty(); }
    std::uint8_t* pixel(int x, int y);
    const std::uint8_t* pixel(int x, int y) const;
    bool operator==(const Image&) const = default;
};

/// "1280 × 720".
std::string sizeText(int width, int height);

/// What a picture says about how its samples are coded; see codingExponent.
enum class ColourMarks
{
    Followed, ///< what is coded otherwise is brought to sRGB, from the full depth of its samples
    Ignored,  ///< samples are sRGB whatever it says
};

/// Reads PNG, JPEG or TIFF. Colours are sRGB.
/// \throws Error FileNotFound, PermissionDenied, FileEmpty, and those of decodeImage.
Image readImage(const std::filesystem::path& path, ColourMarks marks = ColourMarks::Followed);

/// Decodes the bytes of a PNG, JPEG or TIFF file. Colours are sRGB.
/// \param file  names the source in errors.
/// \throws Error ImageUnreadable, FileTruncated, CountTooLarge, FormatRefused: see checkEncodedImage.
Image decodeImage(std::span<const std::byte> encoded, const std::filesystem::path& file = {},
                  ColourMarks marks = ColourMarks::Followed);

/// The bytes of a PNG, JPEG or TIFF file.
/// \param extension  ".png", ".jpg", …
/// \param jpegQuality  1 … 100, for JPEG only.
/// \throws Error FormatUnknown.
std::vector<std::byte> encodeImage(const Image& image, const std::string& extension, int jpegQuality = 95);

/// Writes PNG, JPEG or TIFF by the path's ending, atomically. PNG bytes depend on the pixels alone.
/// \param jpegQuality  1 … 100, for JPEG only.
/// \throws Error WriteFailed, PermissionDenied, FormatUnknown.
void writeImage(const Image& image, const std::filesystem::path& path, int jpegQuality = 95);

} // namespace quadrille
