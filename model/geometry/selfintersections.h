// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace quadrille {

/// Whether two triangles go through each other: whether they have more than single points in common and do
/// not lie in one plane. Triangles that only touch, and those without area, do not. Exact for coordinates
/// that are within a factor of 2^28 of each other. Source: Guigue & Devillers 2003; Shewchuk 1997.
bool trianglesCross(const std::array<Vec3f, 3>& a, const std::array<Vec3f, 3>& b);

/// Finds where a surface goes through itself, in one pose after the other: a tree of boxes, built once, whose
/// boxes follow the poses. Immutable; safe from any thread.
class SelfIntersections
{
public:
    /// \param pose  of all vertices: triangles that lie near each other in it are searched together.
    SelfIntersections(std::shared_ptr<const Topology> topology, Positions pose);

    using Pair = std::array<TriangleIndex, 2>;

    /// Pairs of triangles that go through each other and have no vertex in common, ascending, the smaller
    /// one first. \param pose  of all vertices, finite.
    std::vector<Pair> find(Positions pose) const;

private:
    /// Triangles of m_order; the left child of an inner node comes right after it.
    struct Node
    {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        std::uint32_t right = 0; ///< 0: a leaf
    };
    struct Box;
    void build(std::vector<Vec3f>& middles, std::uint32_t first, std::uint32_t count);
    class Search;

    std::shared_ptr<const Topology> m_topology;
    std::vector<std::uint32_t> m_order; ///< triangles
    std::vector<Node> m_nodes;
};

} // namespace quadrille
