// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/playback/figureshadow.h"

#include "model/core/bounds.h"
#include "model/render/ground.h"

namespace quadrille {

namespace {

/// Cells that a figure is high, as in exported pictures.
constexpr double cellsPerHeight = 160;

} // namespace

widgets::GroundShadow figureShadow(const widgets::ShadowWish& wish, const Topology& topology, double height)
{
    const GroundPlane ground{.up = wish.up == widgets::UpAxis::Y ? UpAxis::Y : UpAxis::Z,
                             .height = static_cast<double>(wish.ground)};
    const Eigen::Index up = ground.vertical();
    const Positions positions(reinterpret_cast<const Vec3f*>(wish.positions.data()),
                              wish.positions.size() / 3);
    const Vec3d toLight(static_cast<double>(wish.toLight.x()), static_cast<double>(wish.toLight.y()),
                        static_cast<double>(wish.toLight.z()));
    if (height <= 0) {
        const Bounds bounds = boundsOf(positions);
        height = bounds.isEmpty() ? 1 : bounds.size()[up];
    }
    const ShadowMap map(positions, topology.triangles(), ground, toLight, height / cellsPerHeight + 1e-9,
                        wish.coarseness);
    Vec3d corner;
    corner[up] = ground.height;
    corner[(up + 1) % 3] = map.corner().x();
    corner[(up + 2) % 3] = map.corner().y();
    const Vec3f place = corner.cast<float>();
    return {.corner = {place.x(), place.y(), place.z()},
            .cell = map.texel(),
            .columns = map.width(),
            .rows = map.height(),
            .darkness = map.darkness()};
}

} // namespace quadrille
