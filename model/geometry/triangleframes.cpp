// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/triangleframes.h"

#include "model/geometry/geometrykernels.h"

#include <Eigen/Geometry>
#include <cassert>
#include <limits>

namespace quadrille {

std::vector<CornerSlice> cornerSlices(std::span<const Triangle> triangles)
{
    std::vector<CornerSlice> slices((triangles.size() + sliceTriangles - 1) / sliceTriangles);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        CornerSlice& slice = slices[t / sliceTriangles];
        for (std::size_t corner = 0; corner < 3; ++corner)
            slice.vertices[corner][slice.count] = triangles[t][corner].value;
        ++slice.count;
    }
    return slices;
}

void fillTriangleSlice(Positions positions, const CornerSlice& corners, TriangleSlice& out)
{
    fillTriangleFrames(positions.front().data(), corners, out);
    for (std::size_t t = corners.count; t < sliceTriangles; ++t) {
        for (TriangleSlice::Row& row : out.quaternion)
            row[t] = 0;
        out.b11[t] = out.b22[t] = 1;
        out.b12[t] = out.logArea[t] = 0;
    }
}

void markDegenerate(Positions positions, std::span<const Triangle> triangles, std::span<std::uint8_t> marks)
{
    assert(marks.size() == triangles.size());
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::max());
    Vec3f high = -low;
    for (const Vec3f& p : positions) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double least = 1e-12 * (high - low).cast<double>().squaredNorm();
    // |cross product|² against (2 · area)², without a root.
    const double limit = 4 * least * least;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Vec3d origin = positions[triangles[t][2].value].cast<double>();
        const Vec3d normal = (positions[triangles[t][0].value].cast<double>() - origin)
                                 .cross(positions[triangles[t][1].value].cast<double>() - origin);
        const double doubled = normal.squaredNorm();
        if (doubled < limit || doubled == 0)
            marks[t] = 1;
    }
}

} // namespace quadrille
