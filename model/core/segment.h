// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <algorithm>

namespace quadrille {

/// How far a point is from the line between two others, which may be the same.
inline double distanceFromSegment(const Vec2d& a, const Vec2d& b, const Vec2d& point)
{
    const Vec2d side = b - a;
    const double square = side.squaredNorm();
    const double t = square > 0 ? std::clamp((point - a).dot(side) / square, 0.0, 1.0) : 0;
    return (a + t * side - point).norm();
}

} // namespace quadrille
