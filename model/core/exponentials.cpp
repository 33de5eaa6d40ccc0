// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"
#include "model/core/simd.h"

#include <bit>
#include <cstdint>

// No sum here may be reordered: it would undo the splitting of ln 2 and the rounding.

namespace quadrille {

QUADRILLE_SIMD_CLONES
void exponentials(std::span<double> values)
{
    double* const x = values.data();
    const std::size_t count = values.size();
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        // std::clamp would hinder the vectoriser; what is undefined stays so.
        const double above = x[i] < -708 ? -708 : x[i];
        const double clamped = above > 709 ? 709 : above;
        // x = k·ln 2 + r with |r| ≤ ½·ln 2; k stands in the low bits of `shifted`.
        constexpr double shift = 0x1.8p52;
        const double shifted = clamped * 0x1.71547652b82fep0 + shift;
        const double k = shifted - shift;
        const double r = (clamped - k * 0x1.62e42fefa38p-1) - k * 0x1.ef35793c7673p-45;
        double p = 1.0 / 479001600;
        p = p * r + 1.0 / 39916800;
        p = p * r + 1.0 / 3628800;
        p = p * r + 1.0 / 362880;
        p = p * r + 1.0 / 40320;
        p = p * r + 1.0 / 5040;
        p = p * r + 1.0 / 720;
        p = p * r + 1.0 / 120;
        p = p * r + 1.0 / 24;
        p = p * r + 1.0 / 6;
        p = p * r + 0.5;
        p = p * r + 1;
        p = p * r + 1;
        const std::uint64_t power = (std::bit_cast<std::uint64_t>(shifted) + 1023) << 52U;
        x[i] = p * std::bit_cast<double>(power);
    }
}

} // namespace quadrille
