// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/random.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace quadrille {

/// A value in [0, 1) that belongs to a cell of an integer lattice. The same for the same cell and seed, on
/// every machine.
inline double latticeValue(int x, int y, int z, std::uint64_t seed)
{
    std::uint64_t key = seed;
    for (const int c : {x, y, z})
        key = key * 0x100000001b3ULL ^ static_cast<std::uint32_t>(c);
    return Random(key).unit();
}

/// Smooth value noise in [−1, 1] with a wavelength of about two units. Values of the cells about a place,
/// blended by 3t² − 2t³ along each axis.
inline double valueNoise(double x, double y, double z, std::uint64_t seed)
{
    const double fx = std::floor(x);
    const double fy = std::floor(y);
    const double fz = std::floor(z);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double tx = ease(x - fx);
    const double ty = ease(y - fy);
    const double tz = ease(z - fz);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1;
        const int j = (corner >> 1) & 1;
        const int k = corner >> 2;
        const double weight = (i ? tx : 1 - tx) * (j ? ty : 1 - ty) * (k ? tz : 1 - tz);
        sum += weight * latticeValue(static_cast<int>(fx) + i, static_cast<int>(fy) + j,
                                     static_cast<int>(fz) + k, seed);
    }
    return 2 * sum - 1;
}

} // namespace quadrille
