// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace quadrille {

/// Tables between sRGB values (IEC 61966-2-1) and linear light, computed with +, −, × and / alone so that
/// they are the same on every machine. Linear light is 0 … 1.
class SrgbTables
{
public:
    static const SrgbTables& instance();

    /// \param value sRGB 0 … 255, rounded to a quarter.
    float toLinear(float value) const { return m_linear[static_cast<std::size_t>(std::lrint(value * 4))]; }
    Vec3f toLinear(const Vec3f& value) const
    {
        return {toLinear(value.x()), toLinear(value.y()), toLinear(value.z())};
    }
    /// The nearest sRGB value; `toSrgb(toLinear(v)) == v` for all integers.
    std::uint8_t toSrgb(float linear) const
    {
        return m_srgb[static_cast<std::size_t>(std::lrint(std::clamp(linear, 0.0F, 1.0F) * encodeSteps))];
    }
    /// As `toSrgb`, with fractions; for dithering.
    float toSrgbFine(float linear) const
    {
        const float scaled = std::clamp(linear, 0.0F, 1.0F) * encodeSteps;
        const auto low = std::min(static_cast<std::size_t>(static_cast<int>(scaled)),
                                  static_cast<std::size_t>(encodeSteps - 1));
        return m_srgbFine[low] + (m_srgbFine[low + 1] - m_srgbFine[low]) * (scaled - static_cast<float>(low));
    }

private:
    static constexpr int encodeSteps = 8191;
    SrgbTables();

    std::array<float, 255 * 4 + 1> m_linear;
    std::array<std::uint8_t, encodeSteps + 1> m_srgb;
    std::array<float, encodeSteps + 1> m_srgbFine;
};

/// "#RRGGBB" as linear light.
Vec3f linearColor(std::uint32_t rgb);

} // namespace quadrille
