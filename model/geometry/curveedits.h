// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacecurve.h"
#include "model/geometry/symmetry.h"

#include <span>
#include <vector>

namespace quadrille {

/// Which of the two pieces that a closed curve cuts a surface into.
enum class CurveSide
{
    Smaller, ///< of less area: towards the end of the limb
    Larger,
};

/// A closed curve with the points that lead it.
struct GuidedCurve
{
    std::vector<VertexIndex> points;
    std::vector<VertexIndex> vertices;
};

/// The closed curve of least length near another that surrounds the same: it never collapses, since it has
/// to pass once around between what lies beyond its reach on either side. \param curve  closed, simple,
/// separating. \param travel  how far each of its points may go at most, metres over the surface.
/// \param obstacles  vertices that it must not touch.
/// \throws Error CurveBoundsNothing.
std::vector<VertexIndex> shortenedCurve(const SurfaceGraph& graph, std::span<const VertexIndex> curve,
                                        double travel, std::span<const VertexIndex> obstacles = {});

/// The curve at a distance over the surface from another: the second one that an overlap needs.
/// \param curve  closed, simple, separating. \param obstacles  vertices that it must not touch.
/// \throws Error CurveBoundsNothing, CurveNoParallel (the surface ends before, or obstacles leave no way).
std::vector<VertexIndex> parallelCurve(const SurfaceGraph& graph, std::span<const VertexIndex> curve,
                                       double metres, CurveSide side,
                                       std::span<const VertexIndex> obstacles = {});

/// The curve on the other side of the body. With an exact symmetry vertex by vertex; with one of shape only
/// through the vertices nearest to the points' counterparts, routed anew. A curve without points gets some.
/// \throws Error as SurfaceCurve::setPoints.
GuidedCurve mirroredCurve(const std::shared_ptr<const SurfaceGraph>& graph, const Symmetry& symmetry,
                          const GuidedCurve& curve, const CurveSettings& settings = {});

/// Points that lead a curve that has none: as few, at least three and at most a dozen, as lead a SurfaceCurve
/// along it within an edge or two.
std::vector<VertexIndex> guidesOf(const std::shared_ptr<const SurfaceGraph>& graph,
                                  std::span<const VertexIndex> curve, const CurveSettings& settings = {});

} // namespace quadrille
