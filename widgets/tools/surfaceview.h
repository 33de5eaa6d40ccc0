// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/showncurve.h"

namespace quadrille::widgets {

/// A figure as it stands in a view: turns its vertices into pixels, and pixels into places on it.
struct SurfaceView
{
    int figure = -1; ///< that places are on
    FigureShape shape;
    Turntable camera;
    QSizeF size; ///< logical pixels

    QVector3D place(std::uint32_t vertex) const { return shape.place(vertex); }
    /// None behind the camera.
    std::optional<QPointF> project(const QVector3D& place) const;
    std::optional<QPointF> project(std::uint32_t vertex) const { return project(place(vertex)); }
    /// Whether a pixel lies on the view.
    bool contains(const QPointF& pixel) const { return QRectF(QPointF(), size).contains(pixel); }
    QPointF middle() const { return {size.width() / 2.0, size.height() / 2.0}; }

    /// None beside the figure. Alt keeps it from snapping, here and below.
    std::optional<SurfacePlace> placeAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const;
    /// A place right at a vertex; none where that has no triangle.
    std::optional<SurfacePlace> placeAt(std::uint32_t vertex, Qt::KeyboardModifiers modifiers) const;
    /// The vertex whose pixel is nearest; none where all are behind the camera.
    std::optional<std::uint32_t> nearestVertex(const QPointF& pixel) const;
    /// The vertex that an arrow key leads to along edges, five vertices on with Shift; the same where none
    /// lies that way.
    std::uint32_t vertexTowards(std::uint32_t vertex, int key, Qt::KeyboardModifiers modifiers) const;
    /// The camera turned so that it looks at a vertex from outside, and moved where it would not show it.
    Turntable facing(std::uint32_t vertex) const;
};

} // namespace quadrille::widgets
