// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Nodes over an atlas at which warps are kept: node (i, j) lies at the centre of texel (i · spacing, j ·
/// spacing), the last ones perhaps beyond the edge; in between warps are bilinear, beyond them as at the
/// last.
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

/// Some nodes of a row.
struct NodeRun
{
    int row = 0;
    int column = 0; ///< the first
    int count = 0;
};

/// What moves a texture whose backward warp is `from` to where one with the warp `to` lies: d with d(x) =
/// to(x) − from(x + d(x)), so that both show the same at x + d(x) and at x. Zero where both are the same. By
/// fixed-point iteration, which converges where warps do not fold. \param nodes  at which it is wanted; zero
/// at others. \return 2 values per node.
std::vector<float> warpBetween(std::span<const float> from, std::span<const float> to, const WarpGrid& grid,
                               std::span<const NodeRun> nodes);
/// The same in place of another warp.
void setWarpBetween(std::span<const float> from, std::span<const float> to, const WarpGrid& grid,
                    std::span<const NodeRun> nodes, std::vector<float>& between);

} // namespace quadrille
