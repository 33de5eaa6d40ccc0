// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"

#include <array>
#include <span>
#include <vector>

namespace quadrille {

/// A row of edges over which a surface is opened, as a spiral staircase is: who crosses it from right to left
/// comes to the sheet above, back to the sheet below. A closed curve that begins and ends one sheet apart
/// goes once around each end of the cut, and so cannot be drawn together to a point.
class CrossCut
{
public:
    /// \param path  vertices of which each shares an edge with the next, and with no later one.
    CrossCut(const SurfaceGraph& graph, std::vector<VertexIndex> path);

    const std::vector<VertexIndex>& path() const { return m_path; }
    /// +1 where an edge leads to the sheet above, −1 to the sheet below, else 0.
    int crossing(VertexIndex from, VertexIndex to) const
    {
        return m_isNear[from.value] && m_isNear[to.value] ? lookUp(from, to) : 0;
    }
    bool isNear(VertexIndex v) const { return m_isNear[v.value]; }
    /// Sheets that a curve climbs. \param curve  closed.
    int climbOf(std::span<const VertexIndex> curve) const;

private:
    int lookUp(VertexIndex from, VertexIndex to) const;

    std::vector<VertexIndex> m_path;
    std::vector<bool> m_isNear; ///< on the path or beside it
    /// From vertices of the path to those on their left, ascending.
    std::vector<std::array<VertexIndex, 2>> m_ups;
};

/// The way of the fewest edges; empty where there is none.
std::vector<VertexIndex> fewestEdges(const SurfaceGraph& graph, VertexIndex from, VertexIndex to);

} // namespace quadrille
