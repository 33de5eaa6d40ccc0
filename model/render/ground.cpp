// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/ground.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Cells on each side of the finest grid beyond the figure, for the blur.
constexpr int widestBorder = 40;
constexpr int largestGrid = 2048;

using Field = std::vector<float>;

/// Mean over 2 × radius + 1 cells along rows, of rows `width` long; zero outside.
void blurRows(const Field& in, Field& out, int width, int height, int radius)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) {
            const float* from = in.data() + static_cast<std::ptrdiff_t>(y) * width;
            float* to = out.data() + static_cast<std::ptrdiff_t>(y) * width;
            const double scale = 1.0 / (2 * radius + 1);
            double sum = 0;
            for (int x = 0; x < std::min(radius, width); ++x)
                sum += from[x];
            for (int x = 0; x < width; ++x) {
                sum += x + radius < width ? from[x + radius] : 0.0F;
                to[x] = static_cast<float>(sum * scale);
                sum -= x >= radius ? from[x - radius] : 0.0F;
            }
        }
    });
}

void transpose(const Field& in, Field& out, int width, int height)
{
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const auto& range) {
        for (int y = range.begin(); y != range.end(); ++y) {
            for (int x = 0; x < width; ++x)
                out[static_cast<std::size_t>(x) * static_cast<std::size_t>(height) +
                    static_cast<std::size_t>(y)] =
                    in[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
        }
    });
}

/// Two box blurs each way: near enough to a bell curve.
void blur(Field& field, int width, int height, int radius)
{
    Field other(field.size());
    blurRows(field, other, width, height, radius);
    blurRows(other, field, width, height, radius);
    transpose(field, other, width, height);
    blurRows(other, field, height, width, radius);
    blurRows(field, other, height, width, radius);
    transpose(other, field, height, width);
}

struct Grid
{
    std::int64_t firstX;
    std::int64_t firstY;
    int width;
    int height;
};

/// Height above the ground, per cell, of the lowest surface over it along a direction; −1 where none is.
Field lowestHeights(std::span<const ScreenVertex> vertices, std::span<const Triangle> triangles,
                    const Grid& grid, double highest)
{
    constexpr int tileSize = 64;
    const ScreenScene scene = projectScene(vertices, triangles, grid.width, grid.height, tileSize);
    Field heights(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), -1.0F);
    tbb::parallel_for(tbb::blocked_range<int>(0, scene.tileCount()), [&](const auto& range) {
        TileBuffer buffer(tileSize);
        for (int tile = range.begin(); tile != range.end(); ++tile) {
            drawTile(scene, tile, buffer);
            const int left = tile % scene.tilesAcross * tileSize;
            const int top = tile / scene.tilesAcross * tileSize;
            for (int y = top; y < std::min(top + tileSize, grid.height); ++y) {
                for (int x = left; x < std::min(left + tileSize, grid.width); ++x) {
                    const std::size_t sample = buffer.index(x, y);
                    if (buffer.items[sample] != ScreenTriangle::noPiece)
                        heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                                static_cast<std::size_t>(x)] =
                            std::max(static_cast<float>(highest) - buffer.nearness[sample], 0.0F);
                }
            }
        }
    });
    return heights;
}

} // namespace

ShadowMap::ShadowMap(Positions positions, std::span<const Triangle> triangles, const GroundPlane& ground,
                     const Vec3d& toLight, double texel, double coarseness)
    : m_texel(texel * coarseness)
{
    const auto coarser = [coarseness](int cells) {
        return std::max(1, static_cast<int>(std::lround(cells / coarseness)));
    };
    const int border = coarser(widestBorder);
    const Eigen::Index up = ground.vertical();
    const Vec2d lean = ground.flat(toLight) / toLight[up];
    std::vector<ScreenVertex> straight(positions.size());
    std::vector<ScreenVertex> cast(positions.size());
    Vec2d low = Vec2d::Constant(std::numeric_limits<double>::infinity());
    Vec2d high = -low;
    double highest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3d p = positions[i].cast<double>();
        const double height = p[up] - ground.height;
        const Vec2d foot = ground.flat(p);
        const Vec2d shade = foot - lean * height;
        straight[i] = {foot.x(), foot.y(), height};
        cast[i] = {shade.x(), shade.y(), height};
        low = low.cwiseMin(foot).cwiseMin(shade);
        high = high.cwiseMax(foot).cwiseMax(shade);
        highest = std::max(highest, height);
    }
    // A scene that would need too many cells gets larger ones.
    m_texel = std::max(m_texel, (high - low).maxCoeff() / (largestGrid - 2 * border - 2));
    m_firstX = static_cast<std::int64_t>(std::floor(low.x() / m_texel)) - border;
    m_firstY = static_cast<std::int64_t>(std::floor(low.y() / m_texel)) - border;
    m_width = static_cast<int>(static_cast<std::int64_t>(std::floor(high.x() / m_texel)) - m_firstX) + border;
    m_height =
        static_cast<int>(static_cast<std::int64_t>(std::floor(high.y() / m_texel)) - m_firstY) + border;
    const double above = highest * 1.001 + 1e-6;
    for (auto* vertices : {&straight, &cast}) {
        for (ScreenVertex& v : *vertices) {
            v.x = v.x / m_texel - static_cast<double>(m_firstX);
            v.y = v.y / m_texel - static_cast<double>(m_firstY);
            v.nearness = above - v.nearness;
        }
    }
    const Grid grid{m_firstX, m_firstY, m_width, m_height};
    const Field over = lowestHeights(straight, triangles, grid, above);
    const Field along = lowestHeights(cast, triangles, grid, above);

    // What is close to the ground casts a sharp shadow, what is high above a soft one.
    const float reach = static_cast<float>(55 * m_texel / coarseness);
    Field contact(over.size());
    Field sharp(over.size());
    Field soft(over.size());
    for (std::size_t i = 0; i < over.size(); ++i) {
        const float closeness = over[i] < 0 ? 0.0F : std::max(1.0F - over[i] / (0.35F * reach), 0.0F);
        contact[i] = closeness * closeness;
        if (along[i] < 0)
            continue;
        const float share = std::min(along[i] / reach, 1.0F);
        sharp[i] = 1 - share;
        soft[i] = share;
    }
    blur(contact, m_width, m_height, coarser(4));
    blur(sharp, m_width, m_height, coarser(2));
    blur(soft, m_width, m_height, coarser(7));
    m_darkness.resize(over.size());
    for (std::size_t i = 0; i < over.size(); ++i)
        m_darkness[i] = 1 - (1 - 0.75F * contact[i]) * (1 - 0.62F * std::min(sharp[i] + soft[i], 1.0F));
}

float ShadowMap::at(const Vec2d& point) const
{
    const double x = point.x() / m_texel - static_cast<double>(m_firstX) - 0.5;
    const double y = point.y() / m_texel - static_cast<double>(m_firstY) - 0.5;
    if (!(x >= 0 && y >= 0 && x < m_width - 1 && y < m_height - 1))
        return 0;
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const auto fx = static_cast<float>(x - column);
    const auto fy = static_cast<float>(y - row);
    const float* cell = m_darkness.data() + static_cast<std::ptrdiff_t>(row) * m_width + column;
    const float upper = cell[0] + (cell[1] - cell[0]) * fx;
    const float lower = cell[m_width] + (cell[m_width + 1] - cell[m_width]) * fx;
    return upper + (lower - upper) * fy;
}

float gridCoverage(const Vec2d& point, const Vec2d& footprint, double lineWidth)
{
    double open = 1;
    for (Eigen::Index i = 0; i < 2; ++i) {
        const double size = std::max(footprint[i], 1e-9);
        const double width = std::max(lineWidth, size);
        const double distance = std::abs(point[i] - std::floor(point[i] + 0.5));
        double covered = std::clamp((width / 2 + size / 2 - distance) / size, 0.0, 1.0);
        covered *= lineWidth / width; // a line thinner than a pixel is fainter instead
        // Lines closer than pixels melt into their mean.
        const double melt = std::clamp(size * 2 - 1, 0.0, 1.0);
        open *= 1 - (covered + (lineWidth - covered) * melt);
    }
    return static_cast<float>(1 - open);
}

} // namespace quadrille
