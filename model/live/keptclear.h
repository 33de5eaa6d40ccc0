// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/synthesis/walks/constraints.h"

#include <span>
#include <vector>

namespace quadrille {

/// An obstacle and how far away from it something stays. Refers to the obstacle.
struct KeptClear
{
    /// \param keep  metres, ≥ 0.
    KeptClear(const Obstacle& obstacle, double keep);

    /// Whether a point is away from it; touching is too close without a distance as well.
    bool isClear(const Vec2d& point) const;
    bool isClear(const Vec2d& a, const Vec2d& b) const; ///< the same of a straight line
    /// Appends points around it: the straight lines from each to the next touch what is kept clear.
    void addCorners(std::vector<Vec2d>& corners) const;

    const Obstacle* obstacle;
    double keep;
    Vec2d centre = Vec2d::Zero();
    double radius = 0; ///< of a disc about the centre that has the obstacle in it
};

} // namespace quadrille
