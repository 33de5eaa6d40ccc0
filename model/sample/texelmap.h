// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// Which point of the surface each texel shows.
struct TexelMap
{
    static constexpr std::int32_t none = -1;

    int size = 0; ///< of the square, texels
    /// Per texel its triangle; texels around charts have that of the nearest texel inside.
    std::vector<std::int32_t> triangle;
    std::vector<Vec2f> barycentric; ///< weights of the second and third corner
    std::vector<bool> isInside;     ///< not only around a chart

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
    }
};

/// \param size side of the texture, texels.
/// \param gutter texels around each chart that are filled too.
TexelMap mapTexels(const TopologyData& faces, int size, int gutter);

} // namespace quadrille
