// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/texture.h"

#include <string>
#include <vector>

namespace quadrille {

/// A picture as the bytes of a PNG or JPEG file.
struct EncodedTexture
{
    std::vector<std::byte> bytes;
    std::string extension; ///< ".png" or ".jpg"
    std::string mimeType;  ///< "image/png" or "image/jpeg"
};

/// PNG and JPEG files byte by byte, anything else as PNG; so too what says that it is coded otherwise than as
/// sRGB, which not all readers heed.
/// \pre !texture.isEmpty()
/// \throws Error what reading the file throws.
EncodedTexture encodeTexture(const Texture& texture);

/// A size for people: "12 MB", "3.4 GB".
std::string sizeText(std::uint64_t bytes);

} // namespace quadrille
