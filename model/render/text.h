// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace quadrille {

/// How text is drawn: DejaVu Sans, which is part of the program so that pictures do not depend on the
/// machine's fonts.
struct TextStyle
{
    double size = 12; ///< pixels per em
    bool isBold = false;
    std::uint32_t color = 0x1B1D21; ///< RGB
};

/// Width of one line, pixels.
double textWidth(std::string_view utf8, const TextStyle& style);

/// Draws one line; what lies outside the image is cut off. Characters without a glyph show as a box.
/// \param x, baseline where the text begins, pixels from the upper left corner.
void drawText(Image& image, std::string_view utf8, double x, double baseline, const TextStyle& style);

/// The text if it fits into a width, otherwise as many characters as fit with "…" after them.
std::string elided(std::string_view utf8, double width, const TextStyle& style);

} // namespace quadrille
