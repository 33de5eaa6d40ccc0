// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/procrustes.h"
#include "model/sequence/io/registry.h"
#include "model/transfer/transferclip.h"
#include "model/transfer/transfersolver.h"
#include "tests/model/transition/bars.h"

#include <algorithm>
#include <numbers>

namespace quadrille::test {

inline constexpr double degree = std::numbers::pi / 180;

/// Some triangles, evenly spread over all; every one for a step of 1.
inline std::vector<TriangleIndex> everyTriangle(const Topology& mesh, std::size_t step = 1)
{
    std::vector<TriangleIndex> marks;
    for (std::size_t t = 0; t < mesh.triangles().size(); t += step)
        marks.emplace_back(t);
    return marks;
}

inline std::vector<Triangle> trianglesOf(const Topology& mesh, std::span<const TriangleIndex> marks)
{
    std::vector<Triangle> triangles;
    for (const TriangleIndex mark : marks)
        triangles.push_back(mesh.triangles()[mark.value]);
    return triangles;
}

/// The mesh of a file, as it stands in its first frame.
inline PosedMesh firstPose(const std::filesystem::path& file)
{
    const MeshSequence sequence = openSequences(file).sequences.front();
    const Frame frame = sequence.frame(FrameIndex(0));
    return {sequence.topology, {frame.positions().begin(), frame.positions().end()}};
}

/// The greatest distance of vertices once both poses have their means at one place.
inline double largestDistance(Positions a, Positions b)
{
    const Vec3d shift = centroid(b) - centroid(a);
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        largest = std::max(largest, (a[v].cast<double>() + shift - b[v].cast<double>()).norm());
    return largest;
}

/// A pose of a target by the rotations of marks from one pose of a mesh of the same topology to another.
inline std::vector<Vec3f> transferred(const Bar& bar, const std::vector<Vec3f>& pose,
                                      std::span<const TriangleIndex> marks,
                                      FieldKind kind = FieldKind::Quaternions)
{
    MarkTracker tracker(singleTriangles(trianglesOf(*bar.topology, marks)), bar.positions);
    const TransferSolver solver(std::make_shared<const TransferTarget>(*bar.topology, bar.positions), marks,
                                kind);
    std::vector<Vec3f> out(bar.positions.size());
    TransferSolver::Scratch scratch;
    solver.pose(tracker.next(pose), out, scratch);
    return out;
}

} // namespace quadrille::test
