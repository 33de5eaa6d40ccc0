// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/sequence/topology.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// Where the texels of an atlas lie on the surface.
struct AtlasTexels
{
    struct Place
    {
        std::uint32_t texel = 0; ///< row · width + column, rows from top to bottom
        TriangleIndex triangle;  ///< that covers its middle; the first, where several do
        Vec2f weights;           ///< of the triangle's second and third corner
    };

    int width = 0;
    int height = 0;
    std::vector<Place> places; ///< by texel, ascending
};

/// Finds them. Textures repeat: what lies outside of [0, 1] covers texels of the other side.
/// \param width,height  texels, 1 … 16384.
/// \throws Error NoUvs; BadArgument where no texel is covered. Cost: O(triangles + texels).
AtlasTexels atlasTexels(const Topology& topology, int width, int height);

} // namespace quadrille
