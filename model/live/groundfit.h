// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/synthesis/clips/ground.h"

namespace quadrille {

/// The motion over the ground that lays one pose onto another one: it looks where all vertices together fit
/// best (Procrustes in the plane, closed form), and stands where those fit that are within a hand's breadth
/// of the lowest one in both poses: feet that stand go on standing. Where there are none, all count alike.
/// Allocates nothing.
/// \pre Both have as many vertices, at least one. Metres.
GroundMotion fitOverGround(Positions pose, Positions onto, const Ground& ground);

} // namespace quadrille
