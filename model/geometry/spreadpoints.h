// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// Some of the points, spread over all as evenly as they are: at even steps along a curve that fills the
/// space (Morton 1966). \param count  at least 1; all where there are no more. \return places, rising. Cost:
/// O(points · log points).
std::vector<std::size_t> spreadPoints(Positions points, std::size_t count);

/// Some of a mesh's triangles, those whose centres are spreadPoints. \param pose  where they lie. \return in
/// the order of the mesh.
std::vector<Triangle> spreadTriangles(std::span<const Triangle> triangles, Positions pose, std::size_t count);

} // namespace quadrille
