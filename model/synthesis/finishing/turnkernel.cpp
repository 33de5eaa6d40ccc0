// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/turnkernel.h"

#include "model/core/simd.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace quadrille {

namespace {

QUADRILLE_SIMD_CLONES
void setTurns(const double* angles, std::size_t count, TurnParts* turns)
{
    constexpr double perTurn = 0.5 * std::numbers::inv_pi;
    constexpr double quarter = 0.5 * std::numbers::pi;
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        const double all = angles[i] * perTurn;
        const auto whole = static_cast<std::int32_t>(all + (all < 0 ? -0.5 : 0.5));
        // The series of a quarter of what is left, within [−π/4, π/4], and the angle doubled twice.
        const double x = (all - whole) * quarter;
        const double y = x * x;
        double s = -1.0 / 39916800;
        s = s * y + 1.0 / 362880;
        s = s * y - 1.0 / 5040;
        s = s * y + 1.0 / 120;
        s = s * y - 1.0 / 6;
        s = x + x * y * s;
        double c = 1.0 / 479001600;
        c = c * y - 1.0 / 3628800;
        c = c * y + 1.0 / 40320;
        c = c * y - 1.0 / 720;
        c = c * y + 1.0 / 24;
        c = c * y - 0.5;
        c = 1 + y * c;
        const double sine = 2 * s * c;
        const double cosine = 1 - 2 * s * s;
        turns[i].sine = 2 * sine * cosine;
        turns[i].cosine = 1 - 2 * sine * sine;
    }
}

} // namespace

void turnsOf(std::span<const double> angles, std::span<TurnParts> turns)
{
    assert(angles.size() == turns.size());
    setTurns(angles.data(), angles.size(), turns.data());
}

} // namespace quadrille
