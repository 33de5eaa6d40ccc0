// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <array>

namespace quadrille {

/// The point of a triangle nearest to another one, as weights of the corners, which sum to 1. Source:
/// Ericson, Real-Time Collision Detection, 5.1.5. \pre The triangle has an area.
Vec3d nearestWeights(const std::array<Vec3d, 3>& corners, const Vec3d& p);

} // namespace quadrille
