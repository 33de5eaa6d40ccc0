// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/texturebake.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Light that reaches a point from outside: 1 in the open, less in corners.
double openness(const Body& body, const Vec3d& p, const Vec3d& normal)
{
    double hidden = 0;
    for (const auto& [distance, weight] :
         {std::pair{0.008, 0.22}, std::pair{0.022, 0.28}, std::pair{0.05, 0.28}, std::pair{0.10, 0.22}})
        hidden += weight * std::clamp((distance - body.distance(p + distance * normal)) / distance, 0.0, 1.0);
    return 1 - std::min(hidden, 1.0);
}

} // namespace

Image bakeTexture(const SurfaceMesh& mesh, const Body& body, const TexelMap& texels, const Palette& palette)
{
    Image image(texels.size, texels.size);
    const std::vector<Vec3d> normals = vertexNormals(mesh);
    tbb::parallel_for(0, texels.size, [&](int y) {
        for (int x = 0; x < texels.size; ++x) {
            const std::size_t texel = texels.index(x, y);
            std::uint8_t* pixel = image.pixel(x, y);
            pixel[3] = 255;
            if (texels.triangle[texel] == TexelMap::none) {
                std::fill_n(pixel, 3, static_cast<std::uint8_t>(96));
                continue;
            }
            const Triangle& t = mesh.triangles[static_cast<std::size_t>(texels.triangle[texel])];
            const Eigen::Vector2d b = texels.barycentric[texel].cast<double>();
            const auto blend = [&](const std::vector<Vec3d>& values) {
                return Vec3d((1 - b.x() - b.y()) * values[t[0].value] + b.x() * values[t[1].value] +
                             b.y() * values[t[2].value]);
            };
            const Vec3d p = blend(mesh.points);
            const Vec3d n = blend(normals).normalized();
            const FigurePart part = body.partAt(p);
            const bool isHair = part == FigurePart::Head && body.isHair(p);
            const Vec3d colour = paint({body.toReference(p, part), n, part, isHair}, palette);
            const double light = (0.50 + 0.50 * openness(body, p + 0.002 * n, n)) * (0.965 + 0.035 * n.y());
            for (int c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(std::clamp(255 * colour[c] * light + 0.5, 0.0, 255.0));
        }
    });
    return image;
}

} // namespace quadrille
