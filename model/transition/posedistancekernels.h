// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/triangleframes.h"

#include <array>
#include <cstddef>

namespace quadrille {

/// A unit quaternion w, x, y, z for kernels.
using RotationF = std::array<float, 4>;

/// How many vertices a slice holds.
inline constexpr std::size_t sliceVertices = 128;

/// Centred coordinates of some vertices of one pose, in rows that kernels stream; zeros where there is no
/// vertex.
struct alignas(64) VertexSlice
{
    std::array<std::array<float, sliceVertices>, 3> coordinates;
};

/// Adds to each sum Σ θ + w/√2·‖log S‖ over the triangles of a slice, from the target to one source.
/// \param sources, rotations, sums  `count` of them; a rotation turns its source onto the target.
/// Source: SMCAS eq. 2 in the closed form of section 1 of the specification.
void addSurfaceDistances(const TriangleSlice& target, const TriangleSlice* sources,
                         const RotationF* rotations, std::size_t count, float stretchWeight, double* sums);

/// Adds to each sum Σ ‖x − R·y‖ over the vertices of a slice, metres.
void addEuclideanDistances(const VertexSlice& target, const VertexSlice* sources, const RotationF* rotations,
                           std::size_t count, double* sums);

} // namespace quadrille
