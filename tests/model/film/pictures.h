// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"

#include <array>

namespace quadrille::test {

using Color = std::array<std::uint8_t, 3>;

/// Colours that a wrong matrix or range changes by more than ten levels.
constexpr std::array<Color, 4> quarterColors{Color{224, 32, 32}, Color{32, 192, 64}, Color{48, 64, 208},
                                             Color{240, 240, 240}};

/// Four quarters, each of one colour: top left, top right, bottom left, bottom right.
inline Image quarters(int width, int height, const std::array<Color, 4>& colors = quarterColors)
{
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Color& color = colors.at((2 * y >= height ? 2U : 0U) + (2 * x >= width ? 1U : 0U));
            std::uint8_t* pixel = image.pixel(x, y);
            for (std::size_t c = 0; c < 3; ++c)
                pixel[c] = color.at(c);
            pixel[3] = 255;
        }
    }
    return image;
}

inline Image plain(int width, int height, const Color& color)
{
    return quarters(width, height, {color, color, color, color});
}

} // namespace quadrille::test
