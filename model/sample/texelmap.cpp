// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/texelmap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

void rasteriseTriangle(TexelMap& map, const std::array<Eigen::Vector2d, 3>& p, std::int32_t triangle)
{
    const Eigen::Vector2d e1 = p[1] - p[0];
    const Eigen::Vector2d e2 = p[2] - p[0];
    const double area = e1.x() * e2.y() - e1.y() * e2.x();
    if (area == 0)
        return;
    const auto low = [&](int axis) { return std::min({p[0][axis], p[1][axis], p[2][axis]}) - 0.5; };
    const auto high = [&](int axis) { return std::max({p[0][axis], p[1][axis], p[2][axis]}) - 0.5; };
    for (int y = std::max(0, static_cast<int>(std::ceil(low(1)))); y <= std::min(map.size - 1.0, high(1));
         ++y)
        for (int x = std::max(0, static_cast<int>(std::ceil(low(0)))); x <= std::min(map.size - 1.0, high(0));
             ++x) {
            const Eigen::Vector2d q = Eigen::Vector2d(x + 0.5, y + 0.5) - p[0];
            const double b = (q.x() * e2.y() - q.y() * e2.x()) / area;
            const double c = (e1.x() * q.y() - e1.y() * q.x()) / area;
            if (b < 0 || c < 0 || b + c > 1)
                continue;
            const std::size_t texel = map.index(x, y);
            map.triangle[texel] = triangle;
            map.barycentric[texel] = Vec2f(static_cast<float>(b), static_cast<float>(c));
            map.isInside[texel] = true;
        }
}

} // namespace

TexelMap mapTexels(const TopologyData& faces, int size, int gutter)
{
    TexelMap map;
    map.size = size;
    const std::size_t count = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    map.triangle.assign(count, TexelMap::none);
    map.barycentric.assign(count, Vec2f::Zero());
    map.isInside.assign(count, false);
    for (std::size_t t = 0; t < faces.triangleUvs.size(); ++t) {
        std::array<Eigen::Vector2d, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec2f& uv = faces.uvs[faces.triangleUvs[t][c]];
            p[c] = Eigen::Vector2d(uv.x(), 1.0 - uv.y()) * size;
        }
        rasteriseTriangle(map, p, static_cast<std::int32_t>(t));
    }
    for (int ring = 0; ring < gutter; ++ring) {
        const std::vector<std::int32_t> before = map.triangle;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const std::size_t texel = map.index(x, y);
                if (before[texel] != TexelMap::none)
                    continue;
                for (const auto& [dx, dy] :
                     {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
                    if (x + dx < 0 || x + dx >= size || y + dy < 0 || y + dy >= size)
                        continue;
                    const std::size_t near = map.index(x + dx, y + dy);
                    if (before[near] == TexelMap::none)
                        continue;
                    map.triangle[texel] = before[near];
                    map.barycentric[texel] = map.barycentric[near];
                    break;
                }
            }
    }
    return map;
}

} // namespace quadrille
