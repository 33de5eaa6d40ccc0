// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/projection/textureprojector.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace quadrille::test {

/// Where a texel lies.
inline Vec3d pointOf(const AtlasTexels::Place& place, Positions positions,
                     std::span<const Triangle> triangles)
{
    const Triangle& corners = triangles[place.triangle.value];
    const Vec3f point = (1 - place.weights.sum()) * positions[corners[0].value] +
                        place.weights.x() * positions[corners[1].value] +
                        place.weights.y() * positions[corners[2].value];
    return point.cast<double>();
}

/// Whether a segment meets a triangle between its ends (Möller & Trumbore 1997).
inline bool meets(const Vec3d& from, const Vec3d& to, const std::array<Vec3d, 3>& triangle)
{
    const Vec3d direction = to - from;
    const Vec3d first = triangle[1] - triangle[0];
    const Vec3d second = triangle[2] - triangle[0];
    const Vec3d p = direction.cross(second);
    const double determinant = first.dot(p);
    if (std::abs(determinant) < 1e-18)
        return false;
    const Vec3d offset = from - triangle[0];
    const double u = offset.dot(p) / determinant;
    const Vec3d q = offset.cross(first);
    const double v = direction.dot(q) / determinant;
    const double t = second.dot(q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < 1;
}

/// Whether a camera without distortion sees a texel, as plain as can be: a ray against all triangles.
/// \param tolerance  of the way: what lies so near to the texel does not hide it.
inline bool plainlySees(const PinholeCamera& camera, const AtlasTexels::Place& place, Positions positions,
                        std::span<const Triangle> triangles, double tolerance = 0.002)
{
    const auto cornersOf = [&](const Triangle& triangle) {
        return std::array{positions[triangle[0].value].cast<double>().eval(),
                          positions[triangle[1].value].cast<double>().eval(),
                          positions[triangle[2].value].cast<double>().eval()};
    };
    const Vec3d point = pointOf(place, positions, triangles);
    const Vec3d inCamera = camera.inCamera(point);
    if (inCamera.z() <= 0)
        return false;
    const double x = camera.cx + camera.fx * inCamera.x() / inCamera.z();
    const double y = camera.cy + camera.fy * inCamera.y() / inCamera.z();
    if (x < 0 || y < 0 || x > camera.width - 1 || y > camera.height - 1)
        return false;
    const Vec3d eye = camera.centre();
    const auto own = cornersOf(triangles[place.triangle.value]);
    if ((own[1] - own[0]).cross(own[2] - own[0]).dot(eye - point) <= 0)
        return false;
    const Vec3d end = point + tolerance * (eye - point);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (t != place.triangle.value && meets(eye, end, cornersOf(triangles[t])))
            return false;
    return true;
}

} // namespace quadrille::test
