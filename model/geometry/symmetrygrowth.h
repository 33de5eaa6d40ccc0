// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/symmetry.h"
#include "model/sequence/topology.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace quadrille {

/// Faces as closed rows of vertices, and their half-edges: the half-edge h leads from vertices[h] to the next
/// one of its face. −1 where there is none.
struct FaceEdges
{
    std::vector<std::uint32_t> vertices;
    std::vector<std::int32_t> next;
    std::vector<std::int32_t> previous;
    std::vector<std::int32_t> twin; ///< the one back, in the neighbouring face
    std::vector<std::int32_t> face;
    std::vector<std::int32_t> faceSizes;

    std::int32_t count() const { return static_cast<std::int32_t>(vertices.size()); }
    std::uint32_t from(std::int32_t h) const { return vertices[static_cast<std::size_t>(h)]; }
    std::uint32_t to(std::int32_t h) const { return from(next[static_cast<std::size_t>(h)]); }
};

/// \param joinsFans  triangles that follow each other around one first corner are one face again.
FaceEdges faceEdges(const Topology& topology, bool joinsFans);

/// An involution of the vertices that maps faces to faces of reversed orientation.
struct GrownSymmetry
{
    std::vector<VertexIndex> opposite;
    /// How much edges differ in length from their counterparts, root mean square, shares of their own.
    double lengthError = 0;
};

/// The one that keeps the lengths of edges best; nothing where there is none.
/// \param plane  to reflect across, if it is known: components that are alike go where it takes them.
std::optional<GrownSymmetry> grownSymmetry(const Topology& topology, const FaceEdges& edges, Positions pose,
                                           const std::optional<ReflectionPlane>& plane,
                                           const Progress& progress);

/// Whether several components are as large as the largest.
bool hasTwins(const Topology& topology);

/// Whether an involution maps each face to one of reversed orientation.
bool reversesFaces(const FaceEdges& edges, const std::vector<VertexIndex>& opposite);

} // namespace quadrille
