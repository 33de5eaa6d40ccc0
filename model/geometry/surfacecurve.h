// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacegraph.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

class PieceRouter;

struct CurveSettings
{
    /// How much creases attract a curve, 0 … 1: the share of its cost that a way along a full crease is
    /// spared.
    double creases = 0.5;
};

/// A closed curve over the edges of a surface through chosen points, while it is edited. Its pieces follow
/// the shortest ways over the surface (not over the edges, which would zig-zag), as near as vertices lie to
/// them.
///
/// It closes itself at every moment: one point gives the shortest loop around the limb there, two the
/// shortest loop around it through both; with more the pieces go the shorter way, except for one that goes
/// round where the curve would not surround anything otherwise. Where there is nothing to go around (a
/// sheet) one or two points give no curve yet.
///
/// An edit re-routes the pieces beside the point alone; the other pieces and the obstacles are gone around.
/// Cost: about the surface within the length of the two pieces.
class SurfaceCurve
{
public:
    explicit SurfaceCurve(std::shared_ptr<const SurfaceGraph> graph, const CurveSettings& settings = {});
    ~SurfaceCurve();
    SurfaceCurve(SurfaceCurve&&) noexcept;
    SurfaceCurve& operator=(SurfaceCurve&&) noexcept;

    /// Vertices that no piece may touch from now on: those of other curves.
    void setObstacles(std::span<const VertexIndex> vertices);

    /// A curve as it was stored: nothing is routed. \param vertices  a closed curve through the points in
    /// their order (or against it); where it does not pass them, or is none on this mesh, a curve is routed
    /// anew. \throws Error as setPoints.
    void restore(std::vector<VertexIndex> points, std::vector<VertexIndex> vertices);

    /// Every edit leaves the curve as it was when it throws.
    /// \throws Error CurveNoRoute (from, to: nothing leads from one point to the next but through other
    /// curves or pieces, or they lie on separate components), CurvePointTwice, CurvePointTaken (an obstacle
    /// is there), CurveVertexOutside.
    void setPoints(std::vector<VertexIndex> points);
    /// \param before  0 … number of points.
    void insert(std::size_t before, VertexIndex point);
    void move(std::size_t index, VertexIndex to);
    void remove(std::size_t index);

    const std::vector<VertexIndex>& points() const { return m_points; }
    /// The closed curve, beginning at the first point; empty where it does not close yet.
    const std::vector<VertexIndex>& vertices() const { return m_vertices; }
    /// Where in `vertices` each point stands, ascending; empty where it does not close yet.
    std::vector<std::size_t> places() const;
    /// In front of which point a new one belongs that lies on or near a vertex of the curve, for `insert`.
    /// \param place  in `vertices`.
    std::size_t pointAfter(std::size_t place) const;

private:
    /// From each point the vertices up to the next one, without it; empty where it is still to be routed.
    using Pieces = std::vector<std::vector<VertexIndex>>;
    void route(std::vector<VertexIndex> points, Pieces kept);

    std::vector<VertexIndex> m_points;
    Pieces m_pieces;
    std::vector<VertexIndex> m_vertices;
    std::unique_ptr<PieceRouter> m_router;
};

/// Length over the edges, metres. \param curve  closed.
double lengthOf(const SurfaceGraph& graph, std::span<const VertexIndex> curve);

} // namespace quadrille
