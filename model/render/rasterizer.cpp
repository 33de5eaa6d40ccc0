// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/rasterizer.h"

#include "model/render/tiles.h"

#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace quadrille {

RasterBuffers rasterize(Positions positions, std::span<const Triangle> triangles, const Camera& camera,
                        int width, int height, bool withBarycentrics)
{
    return rasterize(positions, triangles, Projection(camera, width, height), width, height,
                     withBarycentrics);
}

RasterBuffers rasterize(Positions positions, std::span<const Triangle> triangles,
                        const Projection& projection, int width, int height, bool withBarycentrics)
{
    constexpr int tileSize = 64;
    const ScreenScene scene = projectScene(positions, triangles, projection, width, height, tileSize);
    const std::size_t samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    RasterBuffers out{width, height, std::vector<std::uint32_t>(samples, noTriangle),
                      std::vector<float>(samples, std::numeric_limits<float>::infinity()),
                      std::vector<Vec2f>(withBarycentrics ? samples : 0, Vec2f::Zero())};
    const float lowest = static_cast<float>(1 / projection.farDistance);
    tbb::parallel_for(tbb::blocked_range<int>(0, scene.tileCount()), [&](const auto& range) {
        TileBuffer buffer(tileSize);
        for (int tile = range.begin(); tile != range.end(); ++tile) {
            drawTile(scene, tile, buffer, lowest);
            const int left = tile % scene.tilesAcross * tileSize;
            const int top = tile / scene.tilesAcross * tileSize;
            for (int y = top; y < std::min(top + tileSize, height); ++y) {
                for (int x = left; x < std::min(left + tileSize, width); ++x) {
                    const std::size_t from = buffer.index(x, y);
                    if (buffer.items[from] == noTriangle)
                        continue;
                    const auto to = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                    static_cast<std::size_t>(x);
                    const ScreenTriangle& t = scene.triangles[buffer.items[from]];
                    out.triangles[to] = t.triangle;
                    out.depths[to] = 1.0F / buffer.nearness[from];
                    if (withBarycentrics)
                        out.barycentrics[to] = surfaceWeights(scene, t, x, y).tail<2>();
                }
            }
        }
    });
    return out;
}

} // namespace quadrille
