// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/transition/framelayout.h"

#include <span>

namespace quadrille {

/// Metres that tell a direction.
inline constexpr double leastTravel = 0.1;

/// Over the ground from a captured frame to where it leads soon, or from where it came; half a metre where
/// there is as much. \param points  of all captured frames, metres, the ground first.
Vec2d travelAt(std::span<const Vec3d> points, const FrameLayout& layout, NodeIndex node);

/// The direction of that, radians counter-clockwise from the first axis of the ground.
double headingAt(std::span<const Vec3d> points, const FrameLayout& layout, NodeIndex node);

} // namespace quadrille
