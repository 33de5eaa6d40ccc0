// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace quadrille {

/// Gives equal rows of bytes equal numbers, counted from zero in order of first occurrence.
class RowClasses
{
public:
    std::uint32_t classOf(std::string row);

private:
    std::unordered_map<std::string, std::uint32_t> m_classes;
};

/// Which vertex each split vertex becomes.
struct Weld
{
    std::vector<std::uint32_t> vertexOf; ///< per split vertex its welded vertex
    std::vector<std::uint32_t> firstOf;  ///< per welded vertex the first split vertex that became it

    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(firstOf.size()); }
};

/// Joins the vertices that a format split for normals or texture coordinates. Welded vertices are numbered in
/// the order of their first split vertex.
///
/// Two vertices are joined when
/// - their positions are equal (bit by bit, but −0 = 0) and their attribute classes are equal, and
/// - the surface continues from one to the other: each has a triangle with an edge that lies on an edge of
///   the other's (same positions and classes at both ends), runs the other way, and has no neighbour of its
///   own yet.
/// A split by shading or texture always cuts along whole edges, so this undoes it; shells that touch in a
/// point, fans that meet in one vertex, vertices without a triangle and the two sides of a folded or
/// two-sided triangle stay apart. Where several cuts lie on the same edge (stacked boxes), they are closed in
/// file order, which keeps shells that are stored one after the other apart; more than 64 sides on one edge
/// are no surface and left as they are.
///
/// \param positions  one per split vertex, finite.
/// \param attributeClasses  one per split vertex (bones, weights, morph deltas: see RowClasses), or empty.
/// \param triangles  indices of split vertices, in range.
/// Cost: O(n log n).
Weld weldVertices(std::span<const Vec3f> positions, std::span<const std::uint32_t> attributeClasses,
                  std::span<const std::array<std::uint32_t, 3>> triangles);

} // namespace quadrille
