// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/surfacemesh.h"
#include "resources/sample/maker/body.h"

#include <functional>
#include <vector>

namespace quadrille {

/// Wished edge length at a place, metres.
using EdgeLength = std::function<double(const Vec3d&)>;

/// The left half (x ≥ 0) of a body's surface on a fine grid; its boundary lies in x = 0.
SurfaceMesh extractHalfSurface(const Body& body, double spacing);

/// Isotropic remeshing on the body's surface: edges split, collapsed and flipped, vertices relaxed and
/// projected; the boundary stays in x = 0. Source: Botsch and Kobbelt, A Remeshing Approach to
/// Multiresolution Modeling, 2004.
SurfaceMesh remeshHalf(const SurfaceMesh& half, const Body& body, const EdgeLength& length);

/// Both halves, joined at x = 0.
SurfaceMesh mirrorHalf(const SurfaceMesh& half);

} // namespace quadrille
