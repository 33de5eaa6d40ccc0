// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/warpgrid.h"

#include "model/appearance/decodekernels.h"

namespace quadrille {

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
