// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// A row of numbers for each triangle of a mesh.
using TriangleRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Triangles whose rows lie far from each other: each the farthest from all before it.
/// \param isUsable  of each triangle. \param chosen  those that come first, whatever they are.
/// \param count  how many in the end; fewer where all others equal one that is chosen.
/// Cost: O(count · numbers).
std::vector<TriangleIndex> farthestTriangles(const TriangleRows& rows, const std::vector<bool>& isUsable,
                                             std::vector<TriangleIndex> chosen, std::size_t count);

} // namespace quadrille
