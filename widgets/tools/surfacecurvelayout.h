// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/surfaceview.h"

namespace quadrille::widgets {

/// Curves on a surface as they are shown.
struct SurfaceCurveContent
{
    std::vector<ShownCurve> curves;
    int drawn = -1; ///< the curve that points are added to; −1: one that is not there yet
    std::vector<std::uint32_t> preview; ///< from the last point to the pointer, while drawing
    SurfaceCurvePart selected;

    bool has(const SurfaceCurvePart& part) const;
    /// Of a curve the first one. \pre has(part).
    std::uint32_t vertexOf(const SurfaceCurvePart& part) const;
    /// Half the way along the curve to its next point; none where no vertex lies between. \pre has(part).
    std::optional<std::uint32_t> vertexAfter(const SurfaceCurvePart& part) const;
    /// Null for none.
    const ShownCurve* drawnCurve() const;
    /// All points of all curves, in the order in which keys walk over them.
    std::vector<SurfaceCurvePart> points() const;
};

/// Per curve and vertex, whether it can be seen; none before that was asked for.
using SeenVertices = std::optional<std::vector<std::vector<bool>>>;

/// Where the parts of curves on a surface are in a view, and which one is under a pixel.
class SurfaceCurveLayout
{
public:
    static constexpr double pointReach = 12.0; ///< pixels from which a point is taken hold of
    static constexpr double curveReach = 8.0;

    /// \param content  outlives the layout, as does `seen`.
    /// \param seen  filled when first needed (see visibleVertices); to be taken away when anything else of a
    /// layout is another.
    SurfaceCurveLayout(const SurfaceCurveContent& content, const SurfaceView& view, SeenVertices& seen)
        : m_content(content), m_view(view), m_seen(seen)
    {
    }
    const SurfaceCurveContent& content() const { return m_content; }
    const ShownCurve& curve(int index) const { return m_content.curves[static_cast<std::size_t>(index)]; }
    const SurfaceView& view() const { return m_view; }

    /// Also behind the body; none where the part is not there.
    std::optional<QPointF> pixelOf(const SurfaceCurvePart& part) const;
    /// Whether a point, or the first vertex of a curve, is on the side of the figure that is seen.
    bool isSeen(const SurfaceCurvePart& part) const;
    /// Per vertex of a curve.
    const std::vector<bool>& seenOf(int curve) const { return seen()[static_cast<std::size_t>(curve)]; }
    /// What would be taken hold of at a pixel.
    SurfaceCurvePart partAt(const QPointF& pixel) const;
    /// Around a curve.
    QRectF boxOf(int curve) const;
    /// The point of a curve that stands before a pixel on it.
    int pointBefore(int curve, const QPointF& pixel) const;
    /// Whether a click at a pixel ends the curve that is drawn.
    bool closesAt(const QPointF& pixel) const;
    /// Where the keyboard begins to draw.
    std::optional<std::uint32_t> firstCursor() const;

private:
    const std::vector<std::vector<bool>>& seen() const;
    SurfaceCurvePart pointAt(const QPointF& pixel) const;
    SurfaceCurvePart curveAt(const QPointF& pixel) const;

    const SurfaceCurveContent& m_content;
    SurfaceView m_view;
    SeenVertices& m_seen;
};

/// How the pointer looks over a part while nothing is drawn.
Qt::CursorShape cursorFor(const SurfaceCurvePart& part);

} // namespace quadrille::widgets
