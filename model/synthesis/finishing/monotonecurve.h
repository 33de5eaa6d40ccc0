// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <vector>

namespace quadrille {

/// A smooth curve through points that rises nowhere above and falls nowhere below its neighbouring points:
/// piecewise cubic Hermite interpolation (PCHIP). Source: Fritsch and Butland 1984, with the one-sided,
/// limited slopes at the ends of Moler 2004.
class MonotoneCurve
{
public:
    /// \param points  two or more, (x, y), x rising. \pre They are finite.
    explicit MonotoneCurve(std::vector<Vec2d> points);

    /// Beyond the ends the value of the nearest end. At a point's x exactly its y.
    double operator()(double x) const;

private:
    std::vector<Vec2d> m_points;
    std::vector<double> m_slopes; ///< at the points
};

} // namespace quadrille
