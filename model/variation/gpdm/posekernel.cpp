// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/posekernel.h"

#include "model/core/simd.h"

namespace quadrille {

namespace {

using Eight = float __attribute__((vector_size(32), aligned(4), may_alias));

} // namespace

QUADRILLE_SIMD_CLONES
void combinePanel(const float* panel, const float* coefficients, std::ptrdiff_t rows, float* out)
{
    Eight a0{};
    Eight a1{};
    Eight a2{};
    Eight a3{};
    Eight b0{};
    Eight b1{};
    Eight b2{};
    Eight b3{};
    for (std::ptrdiff_t row = 0; row < rows; ++row, panel += 16, coefficients += 4) {
        const Eight a = *reinterpret_cast<const Eight*>(panel);
        const Eight b = *reinterpret_cast<const Eight*>(panel + 8);
        a0 += a * coefficients[0];
        b0 += b * coefficients[0];
        a1 += a * coefficients[1];
        b1 += b * coefficients[1];
        a2 += a * coefficients[2];
        b2 += b * coefficients[2];
        a3 += a * coefficients[3];
        b3 += b * coefficients[3];
    }
    auto* store = reinterpret_cast<Eight*>(out);
    store[0] = a0;
    store[1] = b0;
    store[2] = a1;
    store[3] = b1;
    store[4] = a2;
    store[5] = b2;
    store[6] = a3;
    store[7] = b3;
}

} // namespace quadrille
