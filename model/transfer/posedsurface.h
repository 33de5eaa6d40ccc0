// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"
#include "model/transfer/solidtarget.h"
#include "model/transfer/transferclip.h"

#include <optional>
#include <span>

namespace quadrille {

/// A mesh in one pose with the surface that ways over it use. Immutable; safe from any thread.
class PosedSurface
{
public:
    /// \param mesh  must outlive this. \throws Error as SolidTarget.
    explicit PosedSurface(const PosedMesh& mesh)
        : m_mesh(&mesh)
        , m_solid(*mesh.topology, mesh.positions)
        , m_graph(m_solid.topology(), m_solid.positions())
    {
    }

    const PosedMesh& mesh() const { return *m_mesh; }
    const SurfaceGraph& graph() const { return m_graph; }
    /// Triangle of the graph of one of the mesh; nothing where it has no area.
    std::optional<std::size_t> onGraph(TriangleIndex triangle) const { return m_solid.triangleOf(triangle); }
    /// Of a triangle of the mesh, vertices of the graph; none where it has no area.
    std::span<const VertexIndex> corners(TriangleIndex triangle) const
    {
        const auto own = onGraph(triangle);
        return own ? std::span<const VertexIndex>(m_graph.topology().triangles()[*own])
                   : std::span<const VertexIndex>();
    }

private:
    const PosedMesh* m_mesh;
    SolidTarget m_solid;
    SurfaceGraph m_graph;
};

} // namespace quadrille
