// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/sequence/topology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// How many triangles a slice holds: a slice of each of some hundred poses stays in a core's own cache.
inline constexpr std::size_t sliceTriangles = 128;

/// The corners of some triangles, in rows. Places beyond `count` hold vertex 0.
struct CornerSlice
{
    std::array<std::array<std::uint32_t, sliceTriangles>, 3> vertices{};
    std::size_t count = 0;
};

/// Where some triangles of one pose lie and what shape they have, in rows that kernels stream. With corners
/// v1, v2, v3 a triangle has an orthonormal frame F (x along v1−v3, z the normal) as a unit quaternion, and a
/// 2 × 2 upper triangular matrix B with [v1−v3, v2−v3] = F·B, metres. Places without a triangle hold a
/// quaternion of zeros and B = 1, which is at no distance from any other pose.
struct alignas(64) TriangleSlice
{
    using Row = std::array<float, sliceTriangles>;
    std::array<Row, 4> quaternion; ///< w, x, y, z
    Row b11;
    Row b12;
    Row b22;
    Row logArea; ///< log(b11·b22), of twice the area in m²
};

/// Triangles in slices, the last one padded.
std::vector<CornerSlice> cornerSlices(std::span<const Triangle> triangles);

/// Frames and edges of the triangles of one slice; computed in double precision.
/// \pre Every triangle of the slice has an area.
void fillTriangleSlice(Positions positions, const CornerSlice& corners, TriangleSlice& out);

/// Marks (by 1) the triangles whose area is below 1e-12 of the squared diagonal of the pose's bounding box;
/// leaves the other marks as they are.
/// \param marks  one per triangle.
void markDegenerate(Positions positions, std::span<const Triangle> triangles, std::span<std::uint8_t> marks);

} // namespace quadrille
