// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/files/exporttexture.h"

#include "model/core/file.h"
#include "model/core/imagecoding.h"

#include <array>
#include <cstdio>

namespace quadrille {

EncodedTexture encodeTexture(const Texture& texture)
{
    if (texture.embedded || texture.made)
        return {encodeImage(*texture.load(), ".png"), ".png", "image/png"};
    const FileContent file = readFile(texture.file);
    const std::string_view text = file.text();
    const std::vector<std::byte> bytes(file.bytes().begin(), file.bytes().end());
    if (text.starts_with("\x89PNG") && !codingExponent(bytes))
        return {bytes, ".png", "image/png"};
    if (text.starts_with("\xff\xd8\xff"))
        return {bytes, ".jpg", "image/jpeg"};
    return {encodeImage(decodeImage(bytes, texture.file, texture.marks), ".png"), ".png", "image/png"};
}

std::string sizeText(std::uint64_t bytes)
{
    const double megabytes = static_cast<double>(bytes) / 1e6;
    std::array<char, 32> text{};
    if (megabytes < 1000)
        std::snprintf(text.data(), text.size(), "%.0f MB", megabytes);
    else
        std::snprintf(text.data(), text.size(), "%.1f GB", megabytes / 1000);
    return text.data();
}

} // namespace quadrille
