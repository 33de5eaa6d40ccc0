// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace quadrille {

/// Nodes over an atlas at which warps are kept: node (i, j) lies at the centre of texel (i · spacing, j ·
/// spacing), the last ones perhaps beyond the edge; in between warps are bilinear.
struct WarpGrid
{
    int spacing = 4; ///< texels
    int width = 0;   ///< nodes
    int height = 0;

    /// As many nodes as it takes to lie around all texels of an atlas.
    static WarpGrid over(int width, int height, int spacing = 4)
    {
        const auto nodesOver = [spacing](int size) { return (size - 1 + spacing - 1) / spacing + 1; };
        return {spacing, nodesOver(width), nodesOver(height)};
    }
    std::int64_t nodes() const { return std::int64_t{width} * height; }
    bool operator==(const WarpGrid&) const = default;
};

} // namespace quadrille
