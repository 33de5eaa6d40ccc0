// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// A mesh as a binary FBX file holds it, before importers split its control points at every corner.
struct FbxGeometry
{
    std::vector<double> controlPoints; ///< points × 3
    std::vector<std::int32_t>
        polygonVertices; ///< per corner a control point; the last of a polygon as −1 − index
    std::vector<std::int32_t> polygonMaterials; ///< one per polygon, or fewer: the first for all
};

/// The meshes of a binary FBX file, in file order; what cannot be understood (text FBX, damage) is left out.
/// Layout: Blender Foundation, "FBX binary file format specification", 2013.
std::vector<FbxGeometry> readFbxGeometries(std::span<const std::byte> file);

} // namespace quadrille
