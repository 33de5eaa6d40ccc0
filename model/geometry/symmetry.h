// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/topology.h"

#include <filesystem>
#include <span>
#include <vector>

namespace quadrille {

/// A point at a triangle of the surface: weighted corners, and an offset in the triangle's own frame (x along
/// v1 − v3, z along the normal; see PoseFrames), metres.
struct OppositePoint
{
    Triangle corners;
    Vec3f weights = Vec3f::Zero();
    Vec3f offset = Vec3f::Zero();
};

/// Where each vertex of a mesh has its counterpart on the other side of the body.
struct Symmetry
{
    /// Per vertex the one opposite, its own index in the middle; an involution that keeps the connectivity,
    /// with triangles turned round. Empty where the mesh is symmetric in shape only.
    std::vector<VertexIndex> opposite;
    /// Per vertex the point opposite, where the mesh is symmetric in shape only.
    std::vector<OppositePoint> points;
    /// Of the vertices, how many have a counterpart within the tolerance; 1 where `opposite` is known.
    double share = 1;

    bool isExact() const { return points.empty(); }
    std::size_t vertexCount() const { return isExact() ? opposite.size() : points.size(); }
};

/// How far a symmetry of shape only may be off.
struct SymmetrySettings
{
    /// Between a vertex that is reflected and the surface, diagonals of the pose's bounding box.
    double tolerance = 0.01;
    /// Of the vertices, how many must be within the tolerance.
    double leastShare = 0.95;
};

/// Finds the left–right symmetry of a mesh: first by its connectivity, which does not mind the pose (faces
/// map to faces with reversed orientation, grown from a seed edge; polygons that were cut into fans count as
/// faces, too; of several such maps the one that keeps the lengths of edges best). Where the connectivity has
/// none, by shape: the plane across which the pose is most like its reflection, and the surface points
/// nearest to the reflected vertices.
/// \param pose  roughly symmetric where the connectivity is not, or where components are alike.
/// \throws Error NoSymmetry, with the share of the vertices that have a counterpart; Cancelled.
Symmetry findSymmetry(const Topology& topology, Positions pose, const SymmetrySettings& settings = {},
                      const Progress& progress = {});

/// A symmetry that is known. \param opposite  per vertex the one opposite.
/// \throws Error SymmetryMapWrong (another number of vertices, an index out of range, no involution, a face
/// whose counterparts are no face, no vertex that moves).
Symmetry checkedSymmetry(const Topology& topology, std::vector<VertexIndex> opposite,
                         const std::filesystem::path& file = {});

/// Reads per vertex the index of the one opposite: a NumPy array of whole numbers (.npy), or text with
/// numbers separated by blanks, commas, semicolons or line ends, or rows of two: vertex, opposite.
/// \throws Error file errors, FileSyntax, SymmetryMapWrong.
Symmetry readSymmetry(const Topology& topology, const std::filesystem::path& file);

/// Of each vertex the place of its counterpart in a pose: the pose before it is reflected.
/// \pre The pose has the symmetry's vertices.
std::vector<Vec3f> counterparts(const Symmetry& symmetry, Positions pose);

/// A plane of reflection.
struct ReflectionPlane
{
    Vec3d normal = Vec3d::UnitX(); ///< of length 1
    Vec3d point = Vec3d::Zero();

    Vec3d reflected(const Vec3d& p) const { return p - 2 * normal.dot(p - point) * normal; }
};

/// The plane across which points lie nearest to their counterparts, by the mean squared distance.
/// \pre Both are as many.
ReflectionPlane reflectionPlane(Positions points, Positions counterparts);

} // namespace quadrille
