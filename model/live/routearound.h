// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/synthesis/walks/constraints.h"

#include <span>
#include <vector>

namespace quadrille {

struct RouteSettings
{
    double spacing = 0.05; ///< greatest distance of the points that come out, metres, > 0
    double lead = 1.2;     ///< metres of the path before and behind an obstacle that may be left
    double margin = 0.15;  ///< kept beyond clearances where there is room for it, metres, ≥ 0

    bool operator==(const RouteSettings&) const = default;
};

/// A path that keeps clear of all obstacles: where it comes too close to some it is bent around them, the
/// shorter way (A* over what corners and discs let see of each other), and the bends are rounded off.
/// \param path  points over the ground, metres; at least one. It is kept where it is clear.
/// \return from the first to the last of them, close together; one point where all are the same.
/// \throws Error BadArgument (no point, an obstacle that is neither disc nor polygon, on the start or on the
/// end, or that cannot be passed), with the name of the obstacle.
/// Cost: (corners + discs)² · obstacles at worst, for each stretch that is bent.
std::vector<Vec2d> routeAround(std::span<const Vec2d> path, std::span<const Obstacle> obstacles,
                               const RouteSettings& settings = {});

} // namespace quadrille
