// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/warpgrid.h"

#include "model/appearance/lookupkernels.h"

namespace quadrille {

std::vector<float> warpBetween(std::span<const float> from, std::span<const float> to, const WarpGrid& grid,
                               std::span<const NodeRun> nodes)
{
    std::vector<float> between;
    setWarpBetween(from, to, grid, nodes, between);
    return between;
}

void setWarpBetween(std::span<const float> from, std::span<const float> to, const WarpGrid& grid,
                    std::span<const NodeRun> nodes, std::vector<float>& between)
{
    between.assign(to.size(), 0);
    std::vector<float> columns;
    columns.reserve(static_cast<std::size_t>(grid.width));
    for (int column = 0; column < grid.width; ++column)
        columns.push_back(static_cast<float>(column * grid.spacing));
    for (const NodeRun& run : nodes) {
        const auto begin = static_cast<std::size_t>(run.row) * static_cast<std::size_t>(grid.width) +
                           static_cast<std::size_t>(run.column);
        undoWarp(from.data(), grid, columns.data() + run.column, run.row * grid.spacing, run.count,
                 to.data() + 2 * begin, between.data() + 2 * begin);
    }
}

} // namespace quadrille
