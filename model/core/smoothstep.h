// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// From 0 at 0 to 1 at 1 with no speed and no acceleration at either end. \param t  0 … 1.
constexpr double smoothStep(double t)
{
    return t * t * t * (t * (6 * t - 15) + 10);
}

} // namespace quadrille
