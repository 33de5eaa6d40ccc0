// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <limits>

namespace quadrille {

/// An axis-aligned box; empty until a point was added.
struct Bounds
{
    Vec3d min = Vec3d::Constant(std::numeric_limits<double>::infinity());
    Vec3d max = Vec3d::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vec3d& point);
    void add(const Bounds& other);
    bool isEmpty() const { return !(min.x() <= max.x()); }
    Vec3d center() const { return (min + max) / 2; }
    Vec3d size() const { return max - min; }
};

/// The box around finite positions; exact, at the speed of memory.
Bounds boundsOf(Positions positions);

} // namespace quadrille
