// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// A closed curve on a mesh: vertices of which each shares an edge with the next, and the last with the
/// first.
struct PartCurve
{
    std::string name;
    std::vector<VertexIndex> vertices;

    bool operator==(const PartCurve&) const = default;
};

/// A part of the body as the user describes it. The root has neither parent nor curves.
struct PartDescription
{
    std::string name;
    std::string parent;
    /// Names of the two curves that bound what the part shares with its parent, in any order.
    std::vector<std::string> curves;

    bool operator==(const PartDescription&) const = default;
};

/// A part of the body as vertices and triangles of the whole mesh, with all that it shares with its
/// neighbours (CVS §4).
struct BodyPart
{
    std::string name;
    int parent = -1; ///< in BodyParts::parts; the root has none
    /// Ascending, with the overlaps shared with the parent and with the children.
    std::vector<VertexIndex> vertices;
    /// All triangles between these vertices that belong to the part, ascending.
    std::vector<TriangleIndex> triangles;
    /// What it shares with its parent, with both curves, ascending; empty for the root.
    std::vector<VertexIndex> overlap;
    std::vector<TriangleIndex> overlapTriangles;
    /// The curves of that overlap: where the part ends inside its parent, and where the parent ends inside
    /// the part.
    std::vector<VertexIndex> end;
    std::vector<VertexIndex> parentEnd;
};

/// A tree of parts; parents stand before their children, so the root is first. Every triangle belongs to one
/// part, or, in an overlap, to a part and its parent.
struct BodyParts
{
    std::vector<BodyPart> parts;
};

/// Cuts a mesh into the parts that some curves bound. Components that no curve lies on belong to the part
/// with the vertex nearest to them in the pose. Without descriptions the whole mesh is one part.
/// \param pose  of all vertices, metres.
/// \throws Error with the name of the curve or part and what is wrong: a curve that is open,
/// meets itself, meets another or does not separate the mesh, a vertex that the mesh has not; a part whose
/// two curves bound nothing together, that would be empty, or that hangs on no other.
BodyParts cutIntoParts(const Topology& topology, Positions pose, std::span<const PartCurve> curves,
                       std::span<const PartDescription> descriptions);

} // namespace quadrille
