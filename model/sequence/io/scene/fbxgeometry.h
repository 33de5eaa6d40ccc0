// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/scene/polygongeometry.h"

#include <cstddef>
#include <span>

namespace quadrille {

/// The meshes of a binary FBX file, in file order; what cannot be understood (text FBX, damage) is left out.
/// Layout: Blender Foundation, "FBX binary file format specification", 2013.
std::vector<PolygonGeometry> readFbxGeometries(std::span<const std::byte> file);

} // namespace quadrille
