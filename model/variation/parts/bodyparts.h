// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/sequence/topology.h"

#include <span>
#include <string>
#include <string_view>
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

    /// The part of a name. \pre There is one.
    std::size_t indexOf(std::string_view name) const;
};

/// Cuts a mesh into the parts that some curves bound; curves that no part names do not cut. Components that
/// no curve lies on, and vertices without triangles, belong to the part with the vertex nearest to them in
/// the pose. Without descriptions the whole mesh is one part, "body". \param pose  of all vertices, metres;
/// also tells parent from child where one part alone hangs on the root: the root is the greater. \throws
/// Error the first of `partProblems`.
BodyParts cutIntoParts(const Topology& topology, Positions pose, std::span<const PartCurve> curves,
                       std::span<const PartDescription> descriptions);

/// What is wrong with a curve or a part, and where.
struct PartProblem
{
    Error error;
    std::string curve; ///< its name; empty where the fault is a part's alone
    std::string part;
    std::vector<VertexIndex> at; ///< the vertices to show; empty where it has no place
};

/// All that is wrong with curves and parts, curves first. Those of curves: CurveVertexOutside, CurveShort,
/// CurveOpen, CurveMeetsItself, CurveMeetsOther, CurveDoesNotSeparate, CurveNameTaken; those of parts:
/// PartNameTaken, PartRootMissing, PartRootTwice, PartParentUnknown, PartCycle, PartCurveCount,
/// PartCurveUnknown, PartCurveShared, PartCurvesApart, PartMisplaced, PartEmpty. Of what follows from
/// another fault nothing is said.
std::vector<PartProblem> partProblems(const Topology& topology, std::span<const PartCurve> curves,
                                      std::span<const PartDescription> descriptions);

/// Names of the curves that no part uses.
std::vector<std::string> unusedCurves(std::span<const PartCurve> curves,
                                      std::span<const PartDescription> descriptions);

/// Where a vertex belongs, as indices into BodyParts::parts.
struct VertexPart
{
    int part = -1;    ///< the part; in an overlap the child
    int overlap = -1; ///< the child whose overlap with its parent holds the vertex; −1 outside of overlaps
};
std::vector<VertexPart> partOfVertex(const BodyParts& parts, std::uint32_t vertexCount);

} // namespace quadrille
