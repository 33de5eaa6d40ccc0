// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/scene/polygongeometry.h"

#include <string_view>

namespace quadrille {

/// Reads what a COLLADA file says of its meshes, and refuses files on which Assimp 5.2 hangs or crashes:
/// text where numbers belong, counts that are not those of the lists, indices that are out of range,
/// references that lead nowhere or in a circle.
/// \return one geometry per mesh, in file order; those with strips or fans are left out.
/// \throws Error FileSyntax, FileEncoding, CountTooLarge, IndexOutOfRange, NonFiniteCoordinate; with the
/// line. Source: Khronos Group, "COLLADA – Digital Asset Schema Release 1.4.1", 2008.
std::vector<PolygonGeometry> readColladaGeometries(std::string_view text, const std::filesystem::path& file);

} // namespace quadrille
