// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/warpgrid.h"

#include "model/appearance/decodekernels.h"

#include <algorithm>
#include <utility>

namespace quadrille {

Vec2f warpAt(std::span<const float> nodes, const WarpGrid& grid, const Vec2f& place)
{
    const auto along = [&](float at, int count) {
        const float position =
            std::clamp(at / static_cast<float>(grid.spacing), 0.0F, static_cast<float>(count - 1));
        const int node = std::min(static_cast<int>(position), std::max(0, count - 2));
        return std::pair(node, position - static_cast<float>(node));
    };
    const auto [i, tx] = along(place.x(), grid.width);
    const auto [j, ty] = along(place.y(), grid.height);
    const auto node = [&](int column, int row) {
        column = std::min(column, grid.width - 1);
        row = std::min(row, grid.height - 1);
        const float* n = nodes.data() + 2 * (std::ptrdiff_t{row} * grid.width + column);
        return Vec2f(n[0], n[1]);
    };
    return (1 - ty) * ((1 - tx) * node(i, j) + tx * node(i + 1, j)) +
           ty * ((1 - tx) * node(i, j + 1) + tx * node(i + 1, j + 1));
}

std::vector<float> warpBetween(std::span<const float> from, std::span<const float> to, const WarpGrid& grid)
{
    std::vector<float> between(to.size());
    for (int row = 0; row < grid.height; ++row) {
        const auto begin = 2 * static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width);
        warpRowBetween(from.data(), to.data() + begin, grid, row, between.data() + begin);
    }
    return between;
}

} // namespace quadrille
