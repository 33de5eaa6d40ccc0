// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace quadrille {

struct HalfEdgeTraits : OpenMesh::DefaultTraits
{
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// Half-edge adjacency of a topology. Vertex handles are vertex indices; points are not filled.
struct HalfEdges
{
    HalfEdgeMesh mesh;
    /// Per face of `mesh` its triangle in the topology.
    std::vector<TriangleIndex> triangleOfFace;
    /// Triangles that a half-edge structure cannot hold (non-manifold); left out of `mesh`.
    std::vector<TriangleIndex> leftOut;
};

} // namespace quadrille
