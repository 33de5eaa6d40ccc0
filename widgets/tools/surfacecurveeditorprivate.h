// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pixeldistances.h"
#include "widgets/tools/surfacecurveeditor.h"
#include "widgets/tools/surfacevisibility.h"

#include <QPolygonF>
#include <QRectF>

namespace quadrille::widgets {

inline constexpr double surfacePointReach = 12.0; // pixels
inline constexpr double surfaceCurveReach = 8.0;

/// A point that is being moved by the mouse.
struct SurfaceDrag
{
    SurfaceCurvePart part;
    QPointF pressedAt;
    QPointF grabbed; ///< from the pointer to the point at the press
    bool moved = false;
    std::optional<SurfacePlace> last;
};

struct SurfaceCurveEditor::Private
{
    explicit Private(SurfaceCurveEditor& editor, Viewport& shown) : owner(editor), viewport(shown) {}

    SurfaceCurveEditor& owner;
    Viewport& viewport;
    int figure = -1;
    std::vector<ShownCurve> curves;
    int drawn = -1;
    std::vector<std::uint32_t> preview;
    QString refusal;
    bool active = true;
    Mode mode = Mode::Edit;
    SurfaceCurvePart selected;
    SurfaceCurvePart hovered;
    std::optional<SurfaceDrag> drag;
    std::optional<QPointF> pressedAt;                   ///< of a press that was left to the camera
    std::optional<SurfacePlace> pointer;                ///< where a click would draw
    std::optional<std::uint32_t> cursor;                ///< of the keyboard, while drawing
    bool isMenuPress = false;                           ///< the right button is down on a part
    std::vector<std::vector<std::uint32_t>> neighbours; ///< of each vertex; filled when first needed
    mutable std::optional<std::vector<std::vector<bool>>> seenCache;

    std::optional<FigureShape> shape() const;
    std::optional<QPointF> project(std::uint32_t vertex) const;
    /// Where a curve is drawn: smoother than from vertex to vertex, through its points all the same.
    std::vector<QVector3D> linePlaces(const std::vector<std::uint32_t>& vertices,
                                      const std::vector<std::size_t>& fixed, bool isClosed) const;
    /// From a place of such a line to the next, on the view; empty behind the camera.
    QPolygonF pieceOf(const std::vector<QVector3D>& line, std::size_t index, bool isClosed) const;
    /// \pre the part is there.
    std::uint32_t vertexOf(const SurfaceCurvePart& part) const;
    bool isThere(const SurfaceCurvePart& part) const;
    const ShownCurve* drawnCurve() const;
    /// Per curve and vertex, whether it can be seen.
    const std::vector<std::vector<bool>>& seen() const;
    std::optional<SurfacePlace> placeAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const;
    /// A place right at a vertex.
    std::optional<SurfacePlace> placeAt(std::uint32_t vertex, Qt::KeyboardModifiers modifiers) const;
    /// The vertex that an arrow key leads to, some vertices on.
    std::uint32_t neighbourAt(std::uint32_t vertex, const QPointF& direction, int steps);
    /// Where the keyboard begins to draw.
    std::optional<std::uint32_t> firstCursor() const;
    /// Whether a click here ends the curve that is drawn.
    bool closesAt(const QPointF& pixel) const;
    /// The point of a curve that stands before a place on it.
    int pointBefore(int curve, const QPointF& pixel) const;
    std::vector<SurfaceCurvePart> points() const;
    QVector3D normalAt(std::uint32_t vertex) const;
    /// Whether a curve is worked on: selected, under the pointer or drawn.
    bool isInHand(int curve) const;
    /// Around a curve on the view.
    QRectF boxOf(int curve) const;

    void paintCurve(QPainter& painter, int curve) const;
    void paintPoints(QPainter& painter, int curve) const;
    /// \param middle  of all curves on the view. \param taken  by names before it.
    void paintName(QPainter& painter, int curve, const QPointF& middle, std::vector<QRectF>& taken) const;
    void paintDrawing(QPainter& painter) const;
    void paintHint(QPainter& painter) const;
    /// What mouse and keys do now.
    QString hint() const;
};

} // namespace quadrille::widgets
