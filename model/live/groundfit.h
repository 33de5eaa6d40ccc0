// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/synthesis/clips/ground.h"

namespace quadrille {

/// The motion over the ground that takes one pose as near as it goes to another one (Procrustes in the plane,
/// closed form). Vertices within a hand's breadth of the lowest one, in both poses, count most: feet that
/// stand go on standing. Where there are none, all count alike. Allocates nothing.
/// \pre Both have as many vertices, at least one. Metres.
GroundMotion fitOverGround(Positions pose, Positions onto, const Ground& ground);

} // namespace quadrille
