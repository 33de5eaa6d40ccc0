// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The triangles around each vertex, and beside each triangle. Refers to the topology.
class VertexTriangles
{
public:
    explicit VertexTriangles(const Topology& topology);

    /// Indices, ascending.
    std::span<const std::uint32_t> of(VertexIndex v) const
    {
        return {m_triangles.data() + m_starts[v.value], m_starts[v.value + 1] - m_starts[v.value]};
    }

    /// Calls with each triangle that shares the edge from a corner of a triangle to the next one.
    template <typename Call>
    void forEachBeside(std::uint32_t triangle, std::size_t corner, Call&& call) const
    {
        const std::uint32_t beside = m_beside[triangle][corner];
        if (beside < several)
            call(beside);
        else if (beside == several)
            for (const std::uint32_t other : besideEdge(triangle, corner))
                call(other);
    }

private:
    static constexpr std::uint32_t several = ~0U - 1;
    static constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> besideEdge(std::uint32_t triangle, std::size_t corner) const;

    const Topology* m_topology;
    std::vector<std::uint32_t> m_starts;
    std::vector<std::uint32_t> m_triangles;
    std::vector<std::array<std::uint32_t, 3>> m_beside; ///< or `several`, or `none`
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
