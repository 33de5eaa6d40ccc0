// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"

#include <optional>

namespace quadrille {

/// Decodes a JPEG file to the pixels that OpenCV gives, in 0.8 of its time (bench_jpeg). As there, the
/// picture is not turned as its metadata ask: texture coordinates mean the pixels as they are stored.
///
/// \return none where OpenCV may know more: printers' colours, unusual sampling, anything wrong or odd.
/// \pre checkEncodedImage accepts it.
std::optional<Image> decodeJpeg(std::span<const std::byte> encoded);

/// The bytes of a JPEG file with half as many colours as pixels along each side, as OpenCV writes it.
/// \param quality  1 … 100.
/// \return none where a side is too long for the format (over 65,500 pixels).
std::optional<std::vector<std::byte>> encodeJpeg(const Image& image, int quality);

} // namespace quadrille
