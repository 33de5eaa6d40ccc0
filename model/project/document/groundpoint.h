// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/sequence/axes.h"

namespace quadrille {

/// A point of the ground as the file has it, in the two axes of the project that are not up, in their order.
Vec3d pointOnGround(const Vec2d& point, UpAxis up);
Vec2d pointOfFile(const Vec3d& point, UpAxis up);

/// The greatest coordinate or length of a path, in the project's unit: 10 km, and no more than what the
/// schema, which knows no unit, allows.
double farthestPlace(double metresPerUnit);

} // namespace quadrille
