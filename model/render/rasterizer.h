// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/render/camera.h"
#include "model/sequence/topology.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

struct Projection;

/// What a sample of the picture sees where it sees nothing.
inline constexpr std::uint32_t noTriangle = 0xFFFFFFFFU;

/// What every sample of a picture sees; rows from top to bottom, sample (x, y) at (x + ½, y + ½).
struct RasterBuffers
{
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> triangles; ///< height × width; the nearest triangle or `noTriangle`
    std::vector<float> depths; ///< height × width; along the direction of view, ∞ where nothing is
    /// height × width; weights of the triangle's second and third corner, true on the surface
    /// (perspective-correct); empty unless asked for.
    std::vector<Vec2f> barycentrics;
};

/// Draws triangles with a depth buffer: from both sides, each sample on a shared edge exactly once
/// (top-left rule on a grid of 1/256 of a sample), cut at the near distance. Of triangles at the same depth
/// the first wins. The same bytes for any number of threads and on any x86-64 machine.
/// \param positions finite; triangles with corners outside ±10⁶ heights of the picture are cut there.
/// \pre width, height in [1, 16384].
RasterBuffers rasterize(Positions positions, std::span<const Triangle> triangles, const Camera& camera,
                        int width, int height, bool withBarycentrics = false);
/// \overload for a camera whose picture is placed otherwise, as that of a calibrated one.
RasterBuffers rasterize(Positions positions, std::span<const Triangle> triangles,
                        const Projection& projection, int width, int height, bool withBarycentrics = false);

} // namespace quadrille
