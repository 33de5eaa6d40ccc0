// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

/// A mesh of any kind as a surface that linear systems can be solved on: vertices at one place are one,
/// triangles that lose a corner by that are left out, and what does not hang together is bridged. Immutable.
class SolidTarget
{
public:
    /// \param positions  of all vertices, metres.
    /// \throws Error VertexCountMismatch, NonFiniteCoordinate (with the vertex), NoFaces where no triangle
    /// has an area. Cost: O(vertices · log vertices).
    SolidTarget(const Topology& mesh, Positions positions);

    const std::shared_ptr<const Topology>& topology() const { return m_topology; }
    Positions positions() const { return m_positions; }
    /// Triangle of the surface of one of the mesh; nothing where it was left out.
    std::optional<std::size_t> triangleOf(TriangleIndex triangle) const;

    /// How a connected component is held: one of its vertices by a near one of the largest component.
    struct Bridge
    {
        std::uint32_t vertex = 0;
        std::uint32_t onto = 0; ///< the vertex itself: the largest component
    };
    /// One of each component.
    const std::vector<Bridge>& bridges() const { return m_bridges; }

    /// Of each vertex of the mesh the one of the surface that it moves with. Those that no triangle uses keep
    /// their offset to the nearest one, see `offsets`.
    const std::vector<std::uint32_t>& vertices() const { return m_vertices; }
    /// A vertex of the mesh that lies apart from the one that it moves with.
    struct Offset
    {
        std::uint32_t vertex = 0; ///< of the mesh
        Vec3f offset = Vec3f::Zero();
    };
    const std::vector<Offset>& offsets() const { return m_offsets; }

private:
    void weld(const Topology& mesh, Positions positions);
    void bridge();
    void attachLoose(Positions positions);

    std::shared_ptr<const Topology> m_topology;
    std::vector<Vec3f> m_positions;
    std::vector<std::uint32_t> m_vertices;
    std::vector<std::int32_t> m_triangles; ///< of the mesh: of the surface, −1 where left out
    std::vector<Bridge> m_bridges;
    std::vector<Offset> m_offsets;
};

} // namespace quadrille
