// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacecurvedrag.h"

#include "widgets/tools/handletool.h"

namespace quadrille::widgets {

SurfaceCurveDrag::SurfaceCurveDrag(const SurfaceCurveLayout& layout, const SurfaceCurvePart& point,
                                   const QPointF& pixel)
    : m_point(point), m_pressedAt(pixel), m_grabbed(layout.pixelOf(point).value_or(pixel) - pixel)
{
}

std::optional<SurfacePlace> SurfaceCurveDrag::moveTo(const SurfaceView& view, const QPointF& pixel,
                                                     Qt::KeyboardModifiers modifiers)
{
    m_moved = m_moved || HandleTool::isDrag(m_pressedAt, pixel);
    if (!m_moved)
        return std::nullopt;
    const auto place = view.placeAt(pixel + m_grabbed, modifiers);
    if (place)
        m_last = place;
    return place;
}

} // namespace quadrille::widgets
