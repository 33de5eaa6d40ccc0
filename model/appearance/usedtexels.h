// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// The texels of an atlas that its UV layout uses, and a gutter around each chart.
struct UsedTexels
{
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> texels; ///< row · width + column, ascending, rows from top to bottom
    std::vector<std::uint16_t> charts; ///< per used texel, the chart that it belongs to
    std::vector<std::uint8_t>
        covered; ///< per used texel: 1 where a triangle covers its centre, 0 in the gutter
    int chartCount = 0;

    bool operator==(const UsedTexels&) const = default;
};

/// Finds them: charts are the pieces of the layout that hang together by UVs, numbered by their first
/// triangle; a texel whose centre lies on an edge is covered, and where charts overlap it belongs to the
/// first of them. Textures repeat: what lies outside [0, 1] uses texels of the other side.
///
/// \param width,height  size of the textures, texels.
/// \param gutter  width of the margin around charts, texels. Gutters of two charts never overlap: a texel
/// goes to the nearest chart, to the first where two are as near. \throws Error NoUvs where the topology has
/// none; BadArgument where no texel is used, or sizes are not positive. Cost: O(triangles + texels · gutter).
UsedTexels usedTexels(const Topology& topology, int width, int height, int gutter = 4);

} // namespace quadrille
