// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/render/camera.h"
#include "model/sequence/topology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Places the scene in a picture: x to the right and y down in samples, depth forward.
struct Projection
{
    Vec3d eye;
    Vec3d right;
    Vec3d up;
    Vec3d forward;
    double focal;   ///< samples
    double centerX; ///< samples
    double centerY;
    double nearDistance;
    double farDistance;

    Projection(const Camera& camera, int width, int height);
    /// The direction, one long along `forward`, in which a point of the picture is seen.
    Vec3d ray(double x, double y) const
    {
        return forward + right * ((x - centerX) / focal) - up * ((y - centerY) / focal);
    }
};

/// A vertex in the picture.
struct ScreenVertex
{
    double x; ///< samples
    double y;
    double nearness; ///< linear in the picture, larger is nearer: 1 / depth, or any key
};

/// A triangle ready to be drawn: its corners counter-clockwise in the picture as drawn (y down).
struct ScreenTriangle
{
    std::array<std::int32_t, 3> x; ///< 1/256 sample
    std::array<std::int32_t, 3> y;
    std::array<float, 3> nearness;
    std::uint32_t triangle;            ///< index of the triangle that it is, or is a part of
    std::uint32_t piece;               ///< index into ScreenScene::pieces, or noPiece
    std::array<std::uint8_t, 3> order; ///< which corner of the triangle each of the three is, when whole
    bool isBack;                       ///< its corners run clockwise as seen

    static constexpr std::uint32_t noPiece = 0xFFFFFFFFU;
};

/// Part of a triangle that was cut: per corner the weights of the whole triangle's corners.
using PieceCorners = std::array<Vec3f, 3>;

/// Triangles in a picture, sorted into square tiles.
struct ScreenScene
{
    int width = 0;
    int height = 0;
    int tileSize = 0;
    int tilesAcross = 0;
    int tilesDown = 0;
    std::vector<ScreenTriangle> triangles;
    std::vector<PieceCorners> pieces;
    std::vector<std::uint32_t> tileStarts; ///< tiles + 1 offsets into tileItems
    std::vector<std::uint32_t> tileItems;  ///< indices of triangles, ascending in each tile

    int tileCount() const { return tilesAcross * tilesDown; }
};

/// Projects, cuts and sorts the triangles of a mesh.
ScreenScene projectScene(Positions positions, std::span<const Triangle> triangles,
                         const Projection& projection, int width, int height, int tileSize);
/// \overload for vertices that are in the picture already (within ±2²⁰ samples); nothing is cut.
ScreenScene projectScene(std::span<const ScreenVertex> vertices, std::span<const Triangle> triangles,
                         int width, int height, int tileSize);

/// The samples of one tile: tileSize × tileSize, rows from top to bottom.
struct TileBuffer
{
    std::size_t tileSize;
    std::vector<std::uint32_t> items; ///< indices into ScreenScene::triangles, or noTriangle
    std::vector<float> nearness;      ///< 0 where nothing is

    explicit TileBuffer(int size);
    /// Of a sample of the picture that lies in the tile.
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) % tileSize * tileSize + static_cast<std::size_t>(x) % tileSize;
    }
};

/// Draws one tile; `buffer` is overwritten.
/// \param lowest nearness that a surface must exceed to be seen.
void drawTile(const ScreenScene& scene, int tile, TileBuffer& buffer, float lowest = 0);

/// The parts of the triangle's area on the far side of each edge, at the middle of sample (x, y), times twice
/// 256²; entry i belongs to corner i. All are ≥ 0 inside.
inline std::array<std::int64_t, 3> edgeValues(const ScreenTriangle& t, int x, int y)
{
    const std::int64_t px = std::int64_t{x} * 256 + 128;
    const std::int64_t py = std::int64_t{y} * 256 + 128;
    std::array<std::int64_t, 3> values;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3;
        const std::size_t b = (i + 2) % 3;
        values[i] =
            std::int64_t{t.x[b] - t.x[a]} * (py - t.y[a]) - std::int64_t{t.y[b] - t.y[a]} * (px - t.x[a]);
    }
    return values;
}

/// The weights of the whole triangle's three corners at the middle of a sample inside, true on the surface.
Vec3f surfaceWeights(const ScreenScene& scene, const ScreenTriangle& triangle, int x, int y);

} // namespace quadrille
