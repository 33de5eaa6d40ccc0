// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/halfedges.h"

#include "model/sequence/lazyhalfedges.h"

namespace quadrille {

namespace {

HalfEdges buildHalfEdges(const TopologyData& data)
{
    HalfEdges result;
    result.mesh.reserve(data.vertexCount, data.triangles.size() * 3 / 2, data.triangles.size());
    for (std::uint32_t v = 0; v < data.vertexCount; ++v)
        result.mesh.add_vertex({0, 0, 0});
    for (std::uint32_t t = 0; t < data.triangles.size(); ++t) {
        const auto handle = [&](std::size_t c) {
            return HalfEdgeMesh::VertexHandle(static_cast<int>(data.triangles[t][c].value));
        };
        const auto face = result.mesh.add_face(handle(0), handle(1), handle(2));
        (face.is_valid() ? result.triangleOfFace : result.leftOut).push_back(TriangleIndex(t));
    }
    return result;
}

} // namespace

const HalfEdges& Topology::halfEdges() const
{
    std::call_once(m_halfEdges->once, [this] {
        m_halfEdges->halfEdges = std::make_shared<const HalfEdges>(buildHalfEdges(m_data));
    });
    return *m_halfEdges->halfEdges;
}

} // namespace quadrille
