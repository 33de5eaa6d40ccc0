// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/rowwarp.h"

#include <algorithm>

namespace quadrille {

RowWarp::RowWarp(const WarpGrid& grid, std::span<const float> warp, int width, std::vector<float>& rows)
    : m_grid(grid), m_warp(warp), m_width(static_cast<std::size_t>(width))
{
    rows.resize(4 * m_width + lookupLanes);
    m_rows = rows.data();
}

void RowWarp::moveTo(int y)
{
    const int node = std::min(y / m_grid.spacing, m_grid.height - 1);
    if (node != m_node) {
        if (node == m_node + 1 && m_node >= 0)
            std::copy_n(m_rows + 2 * m_width, 2 * m_width, m_rows);
        else
            spread(node, m_rows);
        spread(std::min(node + 1, m_grid.height - 1), m_rows + 2 * m_width);
        m_node = node;
    }
    m_weight = static_cast<float>(y - node * m_grid.spacing) / static_cast<float>(m_grid.spacing);
}

/// A row of nodes, made as wide as the texels: all x, then all y.
void RowWarp::spread(int node, float* row) const
{
    const float* nodes =
        m_warp.data() + 2 * static_cast<std::size_t>(node) * static_cast<std::size_t>(m_grid.width);
    const auto spacing = static_cast<std::size_t>(m_grid.spacing);
    for (std::size_t x = 0; x < m_width; x += spacing, nodes += 2) {
        const bool isLast = x / spacing + 1 >= static_cast<std::size_t>(m_grid.width);
        const float* next = isLast ? nodes : nodes + 2;
        const std::size_t count = isLast ? m_width - x : std::min(spacing, m_width - x);
        for (std::size_t i = 0; i < count; ++i) {
            const float weight = static_cast<float>(i) / static_cast<float>(spacing);
            row[x + i] = nodes[0] + weight * (next[0] - nodes[0]);
            row[m_width + x + i] = nodes[1] + weight * (next[1] - nodes[1]);
        }
        if (isLast)
            break;
    }
}

} // namespace quadrille
