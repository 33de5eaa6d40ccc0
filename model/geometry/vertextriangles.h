// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The triangles around each vertex.
class VertexTriangles
{
public:
    explicit VertexTriangles(const Topology& topology);

    /// Indices, ascending.
    std::span<const std::uint32_t> of(VertexIndex v) const
    {
        return {m_triangles.data() + m_starts[v.value], m_starts[v.value + 1] - m_starts[v.value]};
    }

private:
    std::vector<std::uint32_t> m_starts;
    std::vector<std::uint32_t> m_triangles;
};

bool hasCorner(const Triangle& triangle, VertexIndex v);
/// Whether its corners follow each other like this, seen from outside.
bool hasDirectedEdge(const Triangle& triangle, VertexIndex from, VertexIndex to);
/// Whether some triangle has this edge.
bool haveEdge(const Topology& topology, const VertexTriangles& around, VertexIndex a, VertexIndex b);

enum class TriangleSide : std::uint8_t
{
    Elsewhere, ///< on a piece of the surface that the curve does not lie on
    Left,      ///< of the curve's direction, seen from outside
    Right,
};

/// On which side of a closed curve each triangle lies; nothing where the curve does not part them, or has
/// triangles on one side only. \param curve  closed, over edges.
std::optional<std::vector<TriangleSide>> curveSides(const Topology& topology, const VertexTriangles& around,
                                                    std::span<const VertexIndex> curve);

} // namespace quadrille
