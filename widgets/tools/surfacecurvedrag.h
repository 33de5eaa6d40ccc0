// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/surfacecurvelayout.h"

namespace quadrille::widgets {

/// Moves a point of a curve over the surface, under the pointer.
class SurfaceCurveDrag
{
public:
    /// \param point  a point of the layout's. \param pixel  where it is taken hold of.
    SurfaceCurveDrag(const SurfaceCurveLayout& layout, const SurfaceCurvePart& point, const QPointF& pixel);
    const SurfaceCurvePart& point() const { return m_point; }
    /// Where it was moved to last; none where it was not.
    const std::optional<SurfacePlace>& last() const { return m_last; }
    /// Where the point goes now. None before the pixel is far enough not to be a click, and beside the body,
    /// where the point stays at its last place.
    std::optional<SurfacePlace> moveTo(const SurfaceView& view, const QPointF& pixel,
                                       Qt::KeyboardModifiers modifiers);

private:
    SurfaceCurvePart m_point;
    QPointF m_pressedAt;
    QPointF m_grabbed; ///< from the pointer to the point at the press
    bool m_moved = false;
    std::optional<SurfacePlace> m_last;
};

} // namespace quadrille::widgets
