// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <cstdint>
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

/// Whether an involution maps each face to one of reversed orientation.
bool reversesFaces(const FaceEdges& edges, const std::vector<VertexIndex>& opposite);

} // namespace quadrille
