// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/constraints.h"

#include <span>
#include <vector>

namespace quadrille {

/// A path that keeps away from obstacles: stretches that come nearer to one than its clearance and a margin
/// go around it, the shortest way past all of them (a visibility graph of points about the obstacles).
/// \param path  points close together, at least one, metres over the ground. \param margin  metres.
/// \return points of the path, and corners of ways around. \throws Error BadArgument, with the name of an
/// obstacle: it stands at the start or the end, or there is no way past it.
std::vector<Vec2d> routeAround(std::span<const Vec2d> path, std::span<const Obstacle> obstacles,
                               double margin);

} // namespace quadrille
