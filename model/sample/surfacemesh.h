// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <vector>

namespace quadrille {

/// A triangle mesh in its rest pose.
struct SurfaceMesh
{
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
};

/// Unit normals of the vertices, area-weighted.
std::vector<Vec3d> vertexNormals(const SurfaceMesh& mesh);

} // namespace quadrille
