// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/decodekernels.h"
#include "model/appearance/warpgrid.h"

#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// The warps of the texels of a row, between those of the rows of nodes around it.
class RowWarp
{
public:
    /// \param warp  x, y of each node, in rows; kept by reference. \param width  texels. \param rows  what
    /// the warps of two rows of nodes are kept in.
    RowWarp(const WarpGrid& grid, std::span<const float> warp, int width, std::vector<float>& rows);

    /// \pre y does not descend.
    void moveTo(int y);
    /// Of the texels from a column on.
    WarpRows at(int x) const
    {
        const float* first = m_rows + x;
        return {{first, first + 2 * m_width}, {first + m_width, first + 3 * m_width}, m_weight};
    }
    /// Of one texel.
    Vec2f of(int x) const
    {
        const WarpRows rows = at(x);
        return {rows.x[0][0] + rows.weight * (rows.x[1][0] - rows.x[0][0]),
                rows.y[0][0] + rows.weight * (rows.y[1][0] - rows.y[0][0])};
    }

private:
    void spread(int node, float* row) const;

    const WarpGrid& m_grid;
    std::span<const float> m_warp;
    std::size_t m_width;
    float* m_rows = nullptr;
    int m_node = -1;
    float m_weight = 0;
};

} // namespace quadrille
