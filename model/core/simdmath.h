// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace quadrille {

/// Natural logarithm of a positive normal number for loops that are vectorised, 1e-7 of the larger of 1 and
/// the result; log(1) = 0 exactly.
[[gnu::always_inline]] inline float logarithm(float x)
{
    // x = m · 2^e with m in [√½, √2)
    constexpr std::int32_t rootOfHalf = 0x3F35'04F3;
    const auto bits = std::bit_cast<std::int32_t>(x);
    const std::int32_t exponent = (bits - rootOfHalf) >> 23;
    const float f = std::bit_cast<float>(bits - exponent * (1 << 23)) - 1;
    float p = 0.087872654911F;
    p = p * f - 0.1415964701F;
    p = p * f + 0.14834786839F;
    p = p * f - 0.16588488532F;
    p = p * f + 0.1997204971F;
    p = p * f - 0.25001147678F;
    p = p * f + 0.3333367061F;
    p = p * f - 0.49999997133F;
    return f + f * f * p + static_cast<float>(exponent) * 0.69314718056F;
}

} // namespace quadrille
