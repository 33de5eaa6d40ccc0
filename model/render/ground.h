// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/render/tiles.h"
#include "model/sequence/axes.h"
#include "model/sequence/topology.h"

#include <span>
#include <vector>

namespace quadrille {

/// The horizontal plane on which a figure stands.
struct GroundPlane
{
    UpAxis up = UpAxis::Y;
    double height = 0;

    Eigen::Index vertical() const { return static_cast<Eigen::Index>(up); }
    /// The two horizontal coordinates of a point.
    Vec2d flat(const Vec3d& point) const
    {
        const Eigen::Index v = vertical();
        return {point[(v + 1) % 3], point[(v + 2) % 3]};
    }
};

/// How dark the ground is under a figure: 0 … 1 on a grid that stays with the world, so that shadows do not
/// shimmer while the figure moves.
class ShadowMap
{
public:
    /// No shadow anywhere.
    ShadowMap() = default;
    /// \param toLight unit vector towards the light, above the ground.
    /// \param texel side of a cell of the grid, in units of the scene.
    /// \param coarseness ≥ 1: how many times larger the cells are made, for the sake of speed; the shadow is
    /// as wide as without.
    ShadowMap(Positions positions, std::span<const Triangle> triangles, const GroundPlane& ground,
              const Vec3d& toLight, double texel, double coarseness = 1);

    /// \param point horizontal coordinates as GroundPlane::flat gives them.
    float at(const Vec2d& point) const;

    double texel() const { return m_texel; }
    /// The outer corner of the first cell.
    Vec2d corner() const
    {
        return {m_texel * static_cast<double>(m_firstX), m_texel * static_cast<double>(m_firstY)};
    }
    int width() const { return m_width; }
    int height() const { return m_height; }
    /// Rows of cells along the first horizontal coordinate.
    const std::vector<float>& darkness() const { return m_darkness; }

private:
    double m_texel = 1;
    std::int64_t m_firstX = 0; ///< grid coordinates of the first cell
    std::int64_t m_firstY = 0;
    int m_width = 0;
    int m_height = 0;
    std::vector<float> m_darkness; ///< rows of cells
};

/// How much of a pixel lies on lines of a grid: 0 … 1, smooth at any distance.
/// \param point in cells. \param footprint of the pixel, in cells. \param lineWidth in cells.
float gridCoverage(const Vec2d& point, const Vec2d& footprint, double lineWidth);

} // namespace quadrille
