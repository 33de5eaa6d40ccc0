// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pathlayout.h"

namespace quadrille::widgets {

/// Moves a part of a path under the pointer: along the ground, up and down, or along the curve.
class PathDrag
{
public:
    /// \param pixel  where the part is taken hold of.
    PathDrag(const PathLayout& layout, const PathPart& part, const QPointF& pixel,
             Qt::KeyboardModifiers modifiers);
    const PathPart& part() const { return m_part; }
    /// The shape at the press.
    const PathShape& before() const { return m_before; }
    bool hasMoved() const { return m_moved; }
    /// The shape with the part under a pixel; none before that is far enough not to be a click, or where
    /// the pixel means no place.
    std::optional<PathShape> moveTo(const PathLayout& layout, const QPointF& pixel,
                                    Qt::KeyboardModifiers modifiers);

private:
    QVector3D lifted(const GroundView& view, const QPointF& pixel, Qt::KeyboardModifiers modifiers) const;

    PathPart m_part;
    PathShape m_before;
    QPointF m_pressedAt;
    QVector3D m_start;        ///< of the part
    QVector3D m_grabbed;      ///< the place under the pointer at the press, in the part's plane
    bool m_isLifting = false; ///< up and down instead of along the ground
    bool m_moved = false;
};

} // namespace quadrille::widgets
