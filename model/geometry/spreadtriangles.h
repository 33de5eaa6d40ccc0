// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <span>
#include <vector>

namespace quadrille {

/// Some of a mesh's triangles, spread over all as evenly as they are: at even steps along a curve that fills
/// the space of a pose (Morton 1966), by their centres. \param count  at least 1; all where there are no
/// more. \return in the order of the mesh. Cost: O(triangles · log triangles).
std::vector<Triangle> spreadTriangles(std::span<const Triangle> triangles, Positions pose, std::size_t count);

} // namespace quadrille
