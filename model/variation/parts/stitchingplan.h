// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/parts/partoverlap.h"

#include <array>
#include <cstdint>
#include <vector>

namespace quadrille {

/// A triangle of the mesh and where its corners are among the vertices of a part.
struct PartTriangle
{
    std::uint32_t triangle = 0;
    std::array<std::uint32_t, 3> corners{};
};

/// A vertex of the mesh and where it is among the vertices of a part.
struct PartVertex
{
    std::uint32_t vertex = 0;
    std::uint32_t place = 0;
};

/// A part's own triangles, outside the overlap with its parent and those with its children, and that overlap.
struct PartPlan
{
    std::vector<PartTriangle> own;
    std::vector<std::uint32_t> overlapTriangles; ///< of the mesh, as PartOverlap numbers them
    std::vector<std::uint32_t> inPart;           ///< of each overlap vertex, where the part has it
    std::vector<std::uint32_t> inParent;         ///< of each overlap vertex, where the parent has it
};

/// Where a connected component of the mesh comes to lie.
struct ComponentPlan
{
    std::int32_t component = 0;
    std::size_t part = 0;             ///< the one nearest to the root of those that it belongs to
    std::vector<PartVertex> anchors;  ///< which lie, on the average, where the part was laid
    std::vector<PartVertex> carriers; ///< of other components and the same part, which carry it along
};

/// \pre The parts belong to the topology.
std::vector<PartPlan> planParts(const Topology& topology, const BodyParts& parts);

/// In the order in which they can be placed: components with seams from the root outwards, then the others.
std::vector<ComponentPlan> planComponents(const Topology& topology, const BodyParts& parts, Positions pose);

/// Where a part has some of its vertices.
std::vector<std::uint32_t> placesOf(const BodyPart& part, std::span<const VertexIndex> vertices);

} // namespace quadrille
