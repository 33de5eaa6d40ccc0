// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace quadrille {

/// A mesh as an FBX or COLLADA file holds it, before importers split its control points at every corner.
struct PolygonGeometry
{
    std::vector<double> controlPoints; ///< points × 3
    /// Per corner a control point; the last of a polygon as −1 − index.
    std::vector<std::int32_t> polygonVertices;
    std::vector<std::int32_t> polygonMaterials; ///< one per polygon, or fewer: the first for all
};

/// Refuses corners that name no point, before an importer has to cope with them.
/// \throws Error IndexOutOfRange.
void checkCorners(const PolygonGeometry& geometry, const std::filesystem::path& file);

} // namespace quadrille
