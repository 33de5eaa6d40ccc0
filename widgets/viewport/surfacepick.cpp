// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/surfacepick.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::widgets {

// Möller and Trumbore's test.
std::optional<SurfaceHit> pickSurface(const FigureMesh& mesh, std::span<const float> positions,
                                      const QVector3D& offset, const Ray& ray)
{
    const QVector3D origin = ray.origin - offset;
    const auto corner = [&](std::uint32_t vertex) {
        const float* p = &positions[std::size_t{3} * vertex];
        return QVector3D(p[0], p[1], p[2]);
    };
    SurfaceHit best;
    best.distance = std::numeric_limits<float>::infinity();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& triangle = mesh.triangles[t];
        const QVector3D a = corner(triangle[0]);
        const QVector3D ab = corner(triangle[1]) - a;
        const QVector3D ac = corner(triangle[2]) - a;
        const QVector3D p = QVector3D::crossProduct(ray.direction, ac);
        const float determinant = QVector3D::dotProduct(ab, p);
        if (std::abs(determinant) < std::numeric_limits<float>::min())
            continue;
        const QVector3D s = origin - a;
        const float u = QVector3D::dotProduct(s, p) / determinant;
        if (u < 0.0F || u > 1.0F)
            continue;
        const QVector3D q = QVector3D::crossProduct(s, ab);
        const float v = QVector3D::dotProduct(ray.direction, q) / determinant;
        if (v < 0.0F || u + v > 1.0F)
            continue;
        const float distance = QVector3D::dotProduct(ac, q) / determinant;
        if (distance > 0.0F && distance < best.distance) {
            best.distance = distance;
            best.triangle = static_cast<std::uint32_t>(t);
            best.barycentric = {1.0F - u - v, u, v};
        }
    }
    if (!std::isfinite(best.distance))
        return std::nullopt;
    const auto nearest = std::max_element(best.barycentric.begin(), best.barycentric.end());
    best.vertex = mesh.triangles[best.triangle][static_cast<std::size_t>(nearest - best.barycentric.begin())];
    best.point = ray.origin + ray.direction * best.distance;
    return best;
}

} // namespace quadrille::widgets
