// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/shading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace quadrille {

IncidentTriangles trianglesOfVertices(std::span<const Triangle> triangles, std::uint32_t vertexCount)
{
    IncidentTriangles result;
    result.starts.assign(vertexCount + std::size_t{1}, 0);
    for (const Triangle& triangle : triangles) {
        for (const VertexIndex v : triangle)
            ++result.starts[v.value + std::size_t{1}];
    }
    for (std::size_t v = 1; v < result.starts.size(); ++v)
        result.starts[v] += result.starts[v - 1];
    result.triangles.resize(triangles.size() * 3);
    std::vector<std::uint32_t> next(result.starts.begin(), result.starts.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (const VertexIndex v : triangles[t])
            result.triangles[next[v.value]++] = t;
    }
    return result;
}

std::vector<Vec3f> vertexNormals(Positions positions, std::span<const Triangle> triangles,
                                 const IncidentTriangles& neighbours)
{
    std::vector<Vec3f> faces(triangles.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces.size(), 2048), [&](const auto& range) {
        for (std::size_t t = range.begin(); t != range.end(); ++t) {
            const Vec3f& a = positions[triangles[t][0].value];
            faces[t] = (positions[triangles[t][1].value] - a).cross(positions[triangles[t][2].value] - a);
        }
    });
    std::vector<Vec3f> normals(positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, normals.size(), 2048), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            Vec3d sum = Vec3d::Zero();
            for (std::uint32_t i = neighbours.starts[v]; i < neighbours.starts[v + 1]; ++i)
                sum += faces[neighbours.triangles[i]].cast<double>();
            const double length = std::sqrt(sum.squaredNorm());
            normals[v] = length > 0 ? Vec3f((sum / length).cast<float>()) : Vec3f::Zero();
        }
    });
    return normals;
}

Lights::Lights(const Projection& projection, UpAxis up)
{
    const Vec3d vertical = upVector(up);
    // The lights turn with the camera but stay upright, so that shadows do not swing when it tilts.
    Vec3d back = -projection.forward + projection.forward.dot(vertical) * vertical;
    if (back.squaredNorm() < 1e-6)
        back = projection.up * (projection.forward.dot(vertical) > 0 ? 1.0 : -1.0);
    back.normalize();
    const Vec3d right = vertical.cross(back);
    const auto direction = [&](double r, double u, double b) {
        return Vec3f((r * right + u * vertical + b * back).normalized().cast<float>());
    };
    m_up = vertical.cast<float>();
    m_key = direction(-0.62, 1.0, 0.62);
    m_fill = direction(0.85, 0.20, 0.60);
    m_rim = direction(0.45, 0.55, -0.90);
}

Vec3f Lights::shade(const Vec3f& color, const Vec3f& normal, const Vec3f& toEye,
                    const Material& material) const
{
    const auto facing = [&normal](const Vec3f& light, float wrap) {
        return std::max((normal.dot(light) + wrap) / (1 + wrap), 0.0F);
    };
    const Vec3f keyColor(1.06F, 1.0F, 0.93F);
    const Vec3f fillColor(0.82F, 0.92F, 1.10F);
    const Vec3f sky(1.0F, 1.02F, 1.06F);
    const Vec3f floor(0.52F, 0.49F, 0.47F);
    const float above = 0.5F + 0.5F * normal.dot(m_up);
    const Vec3f ambient = (floor + (sky - floor) * above) * material.ambient;
    const float key = facing(m_key, 0.25F);
    const Vec3f diffuse = (keyColor * key + fillColor * (0.34F * facing(m_fill, 0.4F))) * material.diffuse;

    const Vec3f half = (m_key + toEye).normalized();
    float gloss = std::max(normal.dot(half), 0.0F);
    for (int i = 0; i < 5; ++i)
        gloss *= gloss; // to the power of 32
    const float grazing = 1 - std::max(normal.dot(toEye), 0.0F);
    const float rim = facing(m_rim, 0.1F) * grazing * grazing * material.rim;
    const float shine = gloss * key * material.specular;

    Vec3f light =
        color.cwiseProduct(ambient + diffuse + fillColor * rim) + Vec3f::Constant(shine + 0.12F * rim);
    for (float& value : light.reshaped()) {
        // Highlights roll off instead of being clipped.
        constexpr float knee = 0.8F;
        if (value > knee)
            value = knee + (1 - knee) * (value - knee) / (value - knee + (1 - knee));
    }
    return light;
}

} // namespace quadrille
