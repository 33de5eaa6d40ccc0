// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::test {

/// The largest distance of a vertex between two frames, or frames one after the other; infinite where they
/// are not as many, or one is no number.
inline double largestDistance(Positions a, Positions b)
{
    if (a.size() != b.size())
        return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v) {
        const double distance = static_cast<double>((a[v] - b[v]).norm());
        if (std::isnan(distance))
            return std::numeric_limits<double>::infinity();
        largest = std::max(largest, distance);
    }
    return largest;
}

} // namespace quadrille::test
