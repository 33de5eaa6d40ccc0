// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/random.h"

#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

/// Natural logarithm of a positive number, to 1e-15: other than the library's, the same everywhere.
double portableLog(double x)
{
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < std::numbers::sqrt2 / 2) {
        m *= 2;
        --exponent;
    }
    const double s = (m - 1) / (m + 1); // at most 0.172, so that s²³ is below the precision
    const double square = s * s;
    double sum = 0;
    for (int power = 21; power >= 1; power -= 2)
        sum = sum * square + 1.0 / power;
    return 2 * s * sum + exponent * std::numbers::ln2;
}

} // namespace

// The polar method (Marsaglia & Bray 1964).
double Random::normal()
{
    if (m_hasSpare) {
        m_hasSpare = false;
        return m_spare;
    }
    double x = 0;
    double y = 0;
    double square = 0;
    do {
        x = between(-1, 1);
        y = between(-1, 1);
        square = x * x + y * y;
    } while (square >= 1 || square == 0);
    const double scale = std::sqrt(-2 * portableLog(square) / square);
    m_spare = y * scale;
    m_hasSpare = true;
    return x * scale;
}

} // namespace quadrille
