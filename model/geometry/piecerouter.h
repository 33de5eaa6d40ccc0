// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/curveneighbourhood.h"
#include "model/geometry/looparound.h"
#include "model/geometry/surfacecurve.h"
#include "model/geometry/surfaceroute.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

/// Routes the pieces of a closed curve: the shortest ways, and where these surround nothing, ways that go
/// once around the limb at its first point, where there is one.
class PieceRouter
{
public:
    /// From each point the vertices up to the next one, without it; empty where it is still to be routed.
    using Pieces = std::vector<std::vector<VertexIndex>>;

    PieceRouter(std::shared_ptr<const SurfaceGraph> graph, const CurveSettings& settings);

    void setObstacles(std::span<const VertexIndex> vertices);

    /// Whether vertices are a closed row of edges of this mesh, each passed once.
    bool isClosed(std::span<const VertexIndex> vertices) const;

    /// Routes what is missing. \return one piece per point; none where so few points bound nothing.
    /// \throws Error as SurfaceCurve::setPoints.
    Pieces routed(const std::vector<VertexIndex>& points, Pieces kept);

private:
    /// The way of one piece while it is chosen; without length where there is none.
    struct Plan
    {
        OpenedSurface surface;
        std::size_t piece;
        SheetVertex from;
        SheetVertex to;
        float length;
        SurfaceDistances distances;
    };
    void check(const std::vector<VertexIndex>& points) const;
    void findLimb(const std::vector<VertexIndex>& points);
    bool isAround(const Pieces& pieces);
    std::vector<bool> reachFor(const std::vector<VertexIndex>& points) const;
    int climbOf(const std::vector<VertexIndex>& piece, VertexIndex end) const;
    static Plan shortestPlan(const OpenedSurface& surface, std::size_t piece,
                             const std::vector<VertexIndex>& points);
    static bool leadAround(std::vector<Plan>& plans, int climb);
    bool routeAll(std::vector<Plan>& plans, std::vector<bool> blocked, Pieces& pieces) const;
    /// What came of it: pieces, or the ends of one that found no way.
    struct Attempt
    {
        std::optional<Pieces> pieces;
        std::array<VertexIndex, 2> stuck;
    };
    Attempt attempt(const OpenedSurface& surface, const std::vector<VertexIndex>& points, Pieces kept) const;

    std::shared_ptr<const SurfaceGraph> m_graph;
    CurveSettings m_settings;
    std::vector<bool> m_obstacles;
    std::optional<VertexIndex> m_limbAt; ///< where `m_loop` was looked for
    std::optional<std::vector<VertexIndex>> m_loop;
    float m_limbLimit = 0; ///< how far from the loop `m_limb` is known
    std::optional<CurveNeighbourhood> m_limb;
    CurveWorth m_worth;
};

} // namespace quadrille
