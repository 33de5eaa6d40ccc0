// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/atlastexels.h"

#include "model/core/badargument.h"
#include "model/render/rasterizer.h"
#include "model/render/tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

/// The layout as triangles in a picture, each as often as it shows in the atlas.
struct Layout
{
    std::vector<ScreenVertex> corners; ///< three for each triangle
    std::vector<Triangle> triangles;
    std::vector<TriangleIndex> sources; ///< which of the mesh's triangles each one is
};

Layout layoutOf(const TopologyData& data, int width, int height)
{
    constexpr double farthest = 1 << 19; // see projectScene
    constexpr double mostTurns = 16;     // of one triangle; beyond, all is covered by it anyway
    Layout layout;
    const auto add = [&](const std::array<Vec2d, 3>& p, const Vec2d& shift, std::size_t source) {
        const auto first = static_cast<std::uint32_t>(layout.corners.size());
        for (const Vec2d& corner : p)
            layout.corners.push_back({corner.x() + shift.x(), corner.y() + shift.y(), 1});
        layout.triangles.push_back({VertexIndex(first), VertexIndex(first + 1), VertexIndex(first + 2)});
        layout.sources.emplace_back(source);
    };
    for (std::size_t t = 0; t < data.triangleUvs.size(); ++t) {
        std::array<Vec2d, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vec2d uv = data.uvs[data.triangleUvs[t][c]].cast<double>();
            p[c] = {uv.x() * width, (1 - uv.y()) * height};
        }
        const Vec2d size(width, height);
        const Vec2d turns = p[0].cwiseMin(p[1]).cwiseMin(p[2]).cwiseQuotient(size).array().floor();
        for (Vec2d& corner : p)
            corner -= turns.cwiseProduct(size);
        const Vec2d far = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
        if (!(far.maxCoeff() < farthest)) // nor where it is not a number
            continue;
        for (double y = 0; y < std::min(far.y(), mostTurns * height); y += height)
            for (double x = 0; x < std::min(far.x(), mostTurns * width); x += width)
                add(p, {-x, -y}, t);
    }
    return layout;
}

} // namespace

AtlasTexels atlasTexels(const Topology& topology, int width, int height)
{
    if (!topology.hasUvs())
        throw Error(ErrorCode::NoUvs);
    constexpr int largest = 16384;
    if (width < 1 || height < 1 || width > largest || height > largest)
        refuse("Textures have a size of 1 to 16384 texels", "Change the size.");
    constexpr int tileSize = 64;
    const Layout layout = layoutOf(topology.data(), width, height);
    const ScreenScene scene = projectScene(layout.corners, layout.triangles, width, height, tileSize);
    AtlasTexels atlas{.width = width, .height = height};
    TileBuffer buffer(tileSize);
    for (int tile = 0; tile < scene.tileCount(); ++tile) {
        drawTile(scene, tile, buffer);
        const int left = tile % scene.tilesAcross * tileSize;
        const int top = tile / scene.tilesAcross * tileSize;
        for (int y = top; y < std::min(top + tileSize, height); ++y) {
            for (int x = left; x < std::min(left + tileSize, width); ++x) {
                const std::uint32_t item = buffer.items[buffer.index(x, y)];
                if (item == noTriangle)
                    continue;
                const ScreenTriangle& t = scene.triangles[item];
                atlas.places.push_back({static_cast<std::uint32_t>(y * width + x), layout.sources[t.triangle],
                                        surfaceWeights(scene, t, x, y).tail<2>()});
            }
        }
    }
    std::ranges::sort(atlas.places, {}, &AtlasTexels::Place::texel);
    if (atlas.places.empty())
        refuse("No texel of the texture is used by the UV layout",
               "Export the mesh with finite UVs that are not all at one place.");
    return atlas;
}

} // namespace quadrille
