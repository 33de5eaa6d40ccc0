// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sample/body.h"
#include "model/sequence/topology.h"

#include <functional>
#include <vector>

namespace quadrille {

/// A triangle mesh in its rest pose.
struct SurfaceMesh
{
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
};

/// Wished edge length at a place, metres.
using EdgeLength = std::function<double(const Vec3d&)>;

/// The left half (x ≥ 0) of a body's surface on a fine grid; its boundary lies in x = 0.
/// \throws Error Cancelled.
SurfaceMesh extractHalfSurface(const Body& body, double spacing, const Progress& progress = {});

/// Isotropic remeshing on the body's surface: edges split, collapsed and flipped, vertices relaxed and
/// projected; the boundary stays in x = 0. Source: Botsch and Kobbelt, A Remeshing Approach to
/// Multiresolution Modeling, 2004. \throws Error Cancelled.
SurfaceMesh remeshHalf(const SurfaceMesh& half, const Body& body, const EdgeLength& length,
                       const Progress& progress = {});

/// Both halves, joined at x = 0.
SurfaceMesh mirrorHalf(const SurfaceMesh& half);

/// Unit normals of the vertices, area-weighted.
std::vector<Vec3d> vertexNormals(const SurfaceMesh& mesh);

} // namespace quadrille
