// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacecurvedrawing.h"

#include <utility>

namespace quadrille::widgets {

void SurfaceCurveDrawing::hover(const SurfaceCurveLayout& layout, const QPointF& pixel,
                                Qt::KeyboardModifiers modifiers)
{
    m_cursor.reset();
    m_pointer = layout.view().placeAt(pixel, modifiers);
}

bool SurfaceCurveDrawing::leave()
{
    return std::exchange(m_pointer, std::nullopt).has_value();
}

SurfaceCurveDrawing::Outcome SurfaceCurveDrawing::click(const SurfaceCurveLayout& layout,
                                                        const QPointF& pixel, Qt::KeyboardModifiers modifiers)
{
    if (layout.closesAt(pixel))
        return {.isDone = true, .point = std::nullopt};
    return {.point = layout.view().placeAt(pixel, modifiers)};
}

void SurfaceCurveDrawing::moveCursor(const SurfaceCurveLayout& layout, int key,
                                     Qt::KeyboardModifiers modifiers)
{
    m_cursor = m_cursor ? layout.view().vertexTowards(*m_cursor, key, modifiers) : layout.firstCursor();
    m_pointer = m_cursor ? layout.view().placeAt(*m_cursor, modifiers) : std::nullopt;
}

std::optional<SurfacePlace> SurfaceCurveDrawing::placeAtCursor(const SurfaceCurveLayout& layout)
{
    if (!m_cursor)
        m_cursor = layout.firstCursor();
    return m_cursor ? layout.view().placeAt(*m_cursor, {}) : std::nullopt;
}

} // namespace quadrille::widgets
