// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace quadrille {

/// Looks at an encoded picture before a decoder does: decoders trust the size in the header, and libjpeg
/// paints what is missing at the end grey.
/// \param file  names the source in errors.
/// \throws Error ImageUnreadable when it is no PNG, JPEG or TIFF; FileTruncated; CountTooLarge when it is too
/// short for its size in pixels; FormatRefused when it is larger than any use of it here.
void checkEncodedImage(std::span<const std::byte> encoded, const std::filesystem::path& file);

} // namespace quadrille
