// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/surfacecurvelayout.h"

namespace quadrille::widgets {

/// Understands the pointer, and the cursor that keys move over the surface, while a curve is drawn. It knows
/// where a point would be added, and changes no curve.
class SurfaceCurveDrawing
{
public:
    /// What a click comes to: the end of the curve, a point of it, or nothing.
    struct Outcome
    {
        bool isDone = false;
        std::optional<SurfacePlace> point;
    };

    /// Where a click would draw; none beside the body.
    const std::optional<SurfacePlace>& pointer() const { return m_pointer; }
    /// Whether keys brought the pointer there.
    bool hasCursor() const { return m_cursor.has_value(); }
    void hover(const SurfaceCurveLayout& layout, const QPointF& pixel, Qt::KeyboardModifiers modifiers);
    /// The pointer is not there any more, or the view is another. \return whether it was on the body.
    bool leave();
    static Outcome click(const SurfaceCurveLayout& layout, const QPointF& pixel,
                         Qt::KeyboardModifiers modifiers);
    /// Moves the cursor as an arrow key does; one that is not there yet comes to where it begins.
    void moveCursor(const SurfaceCurveLayout& layout, int key, Qt::KeyboardModifiers modifiers);
    /// Where Insert adds a point; none on a figure without triangles.
    std::optional<SurfacePlace> placeAtCursor(const SurfaceCurveLayout& layout);

private:
    std::optional<SurfacePlace> m_pointer;
    std::optional<std::uint32_t> m_cursor;
};

} // namespace quadrille::widgets
