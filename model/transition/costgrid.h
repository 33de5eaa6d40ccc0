// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/transitionsettings.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace quadrille {

/// Pose distances as whole numbers in doubles, so that sums along warp paths are exact and the length of a
/// path rides along in the low bits: the *key* of a cell is distance · 2^lengthBits + 1, and the sum of the
/// keys of a path orders paths by cost, then by length.
struct CostGrid
{
    /// Above the sum of any path.
    static constexpr double outOfReach = 0x1p60;
    /// Between the sum of any path and outOfReach.
    static constexpr double unknown = 0x1p58;

    double unit = 1;      ///< distance of one step of the grid, a power of two
    double lengthOne = 2; ///< 2^lengthBits

    CostGrid(float largestDistance, const TransitionSettings& settings)
    {
        const int lengthBits = std::bit_width(2U * static_cast<unsigned>(settings.longest()) - 1U);
        // A path has fewer than 2^lengthBits cells; means multiply by the length of another path once more.
        const int used = (settings.cost == TransitionCost::Sum ? 2 : 3) * lengthBits;
        lengthOne = std::ldexp(1.0, lengthBits);
        if (largestDistance > 0)
            unit = std::ldexp(1.0, std::ilogb(largestDistance) + 1 - (53 - used));
    }

    double stepsOf(float distance) const { return std::rint(static_cast<double>(distance) / unit); }
    double keyOf(float distance) const { return stepsOf(distance) * lengthOne + 1; }
    double stepsOfKey(double key) const { return std::floor(key / lengthOne); }
    int lengthOfKey(double key) const { return static_cast<int>(key - stepsOfKey(key) * lengthOne); }
    /// Cost of a path from the sum of its keys.
    float costOf(double steps, int length, TransitionCost cost) const
    {
        const double sum = steps * unit;
        return static_cast<float>(cost == TransitionCost::Sum ? sum : sum / length);
    }
};

} // namespace quadrille
