// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/sequence/axes.h"

namespace quadrille {

/// A point of the ground as the file has it, in the two axes of the project that are not up, in their order.
Vec3d pointOnGround(const Vec2d& point, UpAxis up);
Vec2d pointOfFile(const Vec3d& point, UpAxis up);

} // namespace quadrille
