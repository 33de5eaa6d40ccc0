// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "atlas.h"
#include "model/appearance/alignment.h"
#include "model/core/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille::test {

/// A pattern without symmetry of waves 6 … 36 texels long, which can be sampled between texels: grey levels
/// around 120.
inline double patternAt(double x, double y)
{
    Random random(5);
    double sum = 120;
    for (int wave = 0; wave < 24; ++wave) {
        const double angle = random.between(0, 2 * std::numbers::pi);
        const double frequency = 2 * std::numbers::pi / (6 * std::pow(6, random.unit()));
        sum += 12 * std::sin(frequency * (std::cos(angle) * x + std::sin(angle) * y) + random.between(0, 6));
    }
    return sum;
}

/// The pattern moved: texture(x) = pattern(x + shift), in a light that falls off along x.
/// \param outside  grey level of texels that are not covered.
inline Image shiftedTexture(const UsedTexels& used, const Vec2d& shift, double light = 0,
                            std::uint8_t outside = 0)
{
    Image image(used.width, used.height);
    std::fill(image.pixels.begin(), image.pixels.end(), outside);
    for (std::size_t k = 0; k < used.texels.size(); ++k) {
        const double x = used.texels[k] % static_cast<std::uint32_t>(used.width);
        const double y = used.texels[k] / static_cast<std::uint32_t>(used.width);
        const double grey = (1 + light * (x / used.width - 0.5)) * patternAt(x + shift.x(), y + shift.y());
        std::uint8_t* pixel = image.pixels.data() + std::size_t{4} * used.texels[k];
        if (used.covered[k] != 0)
            std::fill_n(pixel, 3, static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 255.0))));
        pixel[3] = 255;
    }
    return image;
}

/// Two charts beside each other in an atlas of 96 × 64 texels.
inline ChartLookup twoCharts()
{
    return ChartLookup(usedTexels(Topology(atlasOf({{6, 6, 60, 58}, {66, 6, 90, 58}}, 96, 64)), 96, 64, 3));
}

/// Textures of twoCharts, shifted more and more: the middle one is their medoid.
/// \param step  from one to the next, texels.
inline TextureSource shiftedTextures(const ChartLookup& charts, std::int64_t count, double step = 0.6)
{
    return {count, [&charts, count, step](std::int64_t index) {
                const double shift = step * static_cast<double>(index - count / 2);
                return std::make_shared<const Image>(shiftedTexture(charts.used(), {shift, -0.5 * shift}));
            }};
}

} // namespace quadrille::test
