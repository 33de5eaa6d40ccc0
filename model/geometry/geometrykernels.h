// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/triangleframes.h"

#include <cstddef>

namespace quadrille {

/// Frames and edges of all places of a slice.
/// \param positions  x, y, z of every vertex of the pose, metres.
void fillTriangleFrames(const float* positions, const CornerSlice& corners, TriangleSlice& out);

// A matrix product whose inner tile of sums stays in the registers of AVX2 and AVX-512.
inline constexpr std::size_t productRows = 6;
inline constexpr std::size_t productColumns = 16;
inline constexpr std::size_t productDepth = 128; ///< of a panel
inline constexpr std::size_t singleDepth =
    32; ///< what is summed in single precision before it is added in double

/// Adds left · rightᵀ to sums. A panel holds productDepth times the productRows (productColumns) values of a
/// tile.
/// \param left  rowTiles panels. \param right  columnTiles panels.
/// \param sums  row-major, columnTiles · productColumns wide.
void addProducts(const float* left, const float* right, std::size_t rowTiles, std::size_t columnTiles,
                 double* sums);

} // namespace quadrille
