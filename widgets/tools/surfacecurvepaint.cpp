// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacecurvepaint.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/smoothline.h"
#include "widgets/tools/surfacecurveeditor.h"
#include "widgets/tools/toolpaint.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double hiddenOpacity = 0.45;

/// Where a curve can be seen, and where the body hides it, as lines on the view.
struct Stretches
{
    std::vector<QPolygonF> seen;
    std::vector<QPolygonF> hidden;
};

/// A curve as it is painted.
struct CurveState
{
    bool isDrawn = false;
    bool isSelected = false;
    bool isHovered = false;

    bool isInHand() const { return isDrawn || isSelected || isHovered; }
};

CurveState stateOf(int curve, const SurfaceCurveLayout& layout, const SurfaceCurveLook& look)
{
    const auto isOf = [curve](const SurfaceCurvePart& part) {
        return part.kind != SurfaceCurvePart::Kind::None && part.curve == curve;
    };
    return {.isDrawn = look.isDrawing && curve == layout.content().drawn,
            .isSelected = isOf(layout.content().selected),
            .isHovered = isOf(look.hovered)};
}

/// A sign that something is wrong.
void paintBadge(QPainter& painter, const QPointF& at)
{
    constexpr double radius = 7.0;
    painter.setPen(QPen(Theme::color(ColorRole::Base), 1.5));
    painter.setBrush(Theme::color(ColorRole::Error));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(Theme::textOn(Theme::color(ColorRole::Error)), 1.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(at - QPointF(0.0, 3.6), at + QPointF(0.0, 0.8));
    painter.drawPoint(at + QPointF(0.0, 3.6));
}

/// Where a curve is drawn: smoother than from vertex to vertex, through its points all the same.
std::vector<QVector3D> linePlaces(const SurfaceView& view, const std::vector<std::uint32_t>& vertices,
                                  const std::vector<std::size_t>& fixed, bool isClosed)
{
    std::vector<QVector3D> line;
    line.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices)
        line.push_back(view.place(vertex));
    return withoutZigzag(std::move(line), fixed, isClosed);
}

/// From a place of such a line to the next, on the view; empty behind the camera.
QPolygonF pieceOf(const SurfaceView& view, const std::vector<QVector3D>& line, std::size_t index,
                  bool isClosed)
{
    constexpr int pieces = 4;
    QPolygonF pixels;
    for (int piece = 0; piece <= pieces; ++piece) {
        const float share = static_cast<float>(piece) / pieces;
        const auto pixel = view.project(smoothPlace(line, index, share, isClosed));
        if (!pixel)
            return {};
        pixels << *pixel;
    }
    return pixels;
}

/// The stretches of a curve up to a place in its vertices, and those from there on.
std::array<Stretches, 2> stretchesOf(const SurfaceCurveLayout& layout, int index, std::size_t last)
{
    const ShownCurve& curve = layout.curve(index);
    const std::vector<bool>& visible = layout.seenOf(index);
    const std::size_t count = curve.vertices.size();
    const std::vector<QVector3D> places =
        linePlaces(layout.view(), curve.vertices, curve.points, curve.isClosed);
    std::array<Stretches, 2> stretches;
    std::vector<QPolygonF>* current = nullptr;
    for (std::size_t i = 0; i + (curve.isClosed ? 0 : 1) < count; ++i) {
        const QPolygonF smooth = pieceOf(layout.view(), places, i, curve.isClosed);
        Stretches& piece = stretches[i >= last ? 1 : 0];
        auto* wanted = visible[i] && visible[(i + 1) % count] ? &piece.seen : &piece.hidden;
        if (smooth.isEmpty()) {
            current = nullptr;
            continue;
        }
        if (wanted != current)
            wanted->push_back({smooth.front()});
        wanted->back() += smooth.mid(1);
        current = wanted;
    }
    return stretches;
}

void paintHidden(QPainter& painter, const std::vector<QPolygonF>& lines, QColor color)
{
    color.setAlphaF(static_cast<float>(hiddenOpacity));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, 1.5, Qt::DashLine, Qt::FlatCap, Qt::RoundJoin));
    for (const QPolygonF& line : lines)
        painter.drawPolyline(line);
}

void paintCurve(QPainter& painter, const SurfaceCurveLayout& layout, int index, const CurveState& state)
{
    const ShownCurve& curve = layout.curve(index);
    // While it is drawn, the piece that closes it is only what would be.
    const std::size_t last =
        state.isDrawn && !curve.points.empty() ? curve.points.back() : curve.vertices.size();
    const auto [line, closing] = stretchesOf(layout, index, last);
    const QColor color =
        !curve.problem.isEmpty() && !state.isDrawn ? Theme::color(ColorRole::Error) : curve.color;
    const double width = state.isSelected ? 4.0 : state.isHovered ? 3.5 : 2.5;
    paintHidden(painter, line.hidden, color);
    paintHidden(painter, closing.hidden, color);
    for (const QPolygonF& stretch : closing.seen)
        paintToolLine(painter, stretch, color, 1.5, Qt::DotLine);
    for (const QPolygonF& stretch : line.seen)
        paintToolLine(painter, stretch, color, width, Qt::SolidLine);
}

void paintCurvePoints(QPainter& painter, const SurfaceCurveLayout& layout, int index,
                      const SurfaceCurveLook& look)
{
    const ShownCurve& curve = layout.curve(index);
    const CurveState state = stateOf(index, layout, look);
    // From afar, points of curves that nobody works on would hide the curves.
    constexpr double roomy = 18.0; // pixels of the box around a curve for each point
    const QRectF box = layout.boxOf(index);
    const bool isSmall =
        !state.isInHand() && box.width() + box.height() < roomy * static_cast<double>(curve.points.size());
    const bool isWrong = !curve.problem.isEmpty() && index != layout.content().drawn;
    for (int point = 0; point < static_cast<int>(curve.points.size()); ++point) {
        const SurfaceCurvePart part{SurfaceCurvePart::Kind::Point, index, point};
        const auto pixel = layout.pixelOf(part);
        if (!pixel)
            continue;
        HandleLook handle{.color = Theme::color(isWrong ? ColorRole::Error : ColorRole::Text),
                          .isSelected = part == layout.content().selected,
                          .isHovered = part == look.hovered};
        if (state.isDrawn && point == 0)
            handle.form = HandleLook::Form::Square;
        const bool isSeen = layout.isSeen(part);
        if (isSmall && !isSeen)
            continue;
        if (isSmall || (!isSeen && !handle.isSelected))
            handle.radius = isSmall ? 1.5 : 3.0;
        painter.setOpacity(isSeen || handle.isSelected ? 1.0 : hiddenOpacity);
        paintHandle(painter, *pixel, handle);
        painter.setOpacity(1.0);
    }
}

/// The outermost pixel of a curve that can be seen, on its right or left side.
std::optional<QPointF> edgeOf(const SurfaceCurveLayout& layout, int index, bool isRight)
{
    const std::vector<std::uint32_t>& vertices = layout.curve(index).vertices;
    std::optional<QPointF> edge;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (const auto pixel = layout.view().project(vertices[i]);
            pixel && layout.seenOf(index)[i] && (!edge || (pixel->x() > edge->x()) == isRight))
            edge = pixel;
    return edge;
}

/// \param middle  of all curves on the view. \param taken  by names before it.
void paintName(QPainter& painter, const SurfaceCurveLayout& layout, int index, const CurveState& state,
               const QPointF& middle, std::vector<QRectF>& taken)
{
    const ShownCurve& curve = layout.curve(index);
    const bool isWrong = !curve.problem.isEmpty() && !state.isDrawn;
    const QString text = isWrong && state.isSelected ? curve.problem : curve.name;
    const QRectF box = layout.boxOf(index);
    constexpr double roomy = 70.0; // pixels
    if (text.isEmpty() || (!isWrong && !state.isInHand() && box.width() + box.height() < roomy))
        return;
    // Outwards from the body, so that the words do not hide it.
    const bool isRight = box.center().x() >= middle.x();
    const auto edge = edgeOf(layout, index, isRight);
    if (!edge)
        return;
    constexpr double away = 24.0;
    const double badge = isWrong ? 20.0 : 0.0;
    const QFontMetricsF metrics(painter.font());
    QRectF plate(0.0, 0.0, metrics.horizontalAdvance(text) + 16.0, metrics.height() + 6.0);
    plate.moveTop(edge->y() - plate.height() / 2.0);
    if (isRight)
        plate.moveLeft(std::min(edge->x() + away + badge, layout.view().size.width() - plate.width() - 4.0));
    else
        plate.moveRight(std::max(edge->x() - away, plate.width() + badge + 4.0));
    const auto isTaken = [&](const QRectF& other) { return other.intersects(plate); };
    for (int tries = 0; tries < 20 && std::any_of(taken.begin(), taken.end(), isTaken); ++tries)
        plate.translate(0.0, plate.height() / 2.0);
    taken.push_back(plate.adjusted(-badge, 0.0, 0.0, 0.0));
    painter.setPen(QPen(Theme::color(ColorRole::ViewportText), 1.0));
    painter.drawLine(*edge, QPointF(isRight ? plate.left() - badge : plate.right(), plate.center().y()));
    paintToolWords(painter, plate.center(), text);
    if (isWrong)
        paintBadge(painter, QPointF(plate.left() - badge / 2.0, plate.center().y()));
}

/// What mouse and keys do now.
QString drawingHint(const SurfaceCurveLayout& layout, const SurfaceCurveLook& look)
{
    const ShownCurve* curve = layout.content().drawnCurve();
    if (curve == nullptr || curve->points.empty())
        return SurfaceCurveEditor::tr("Click on the body for the first point · drag to turn · Esc leaves");
    if (look.hovered.kind == SurfaceCurvePart::Kind::Point)
        return SurfaceCurveEditor::tr("Click to close the curve");
    return SurfaceCurveEditor::tr("Click for points around the body · Return or a click on the first point "
                                  "closes · Backspace takes one back");
}

} // namespace

void paintSurfaceCurves(QPainter& painter, const SurfaceCurveLayout& layout, const SurfaceCurveLook& look)
{
    // What is worked on lies on top.
    std::vector<int> order(layout.content().curves.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_partition(order.begin(), order.end(),
                          [&](int curve) { return !stateOf(curve, layout, look).isInHand(); });
    QRectF all;
    for (const int curve : order)
        all |= layout.boxOf(curve);
    std::vector<QRectF> taken{look.occupied};
    for (const int curve : order)
        paintCurve(painter, layout, curve, stateOf(curve, layout, look));
    for (const int curve : order)
        paintName(painter, layout, curve, stateOf(curve, layout, look), all.center(), taken);
    for (const int curve : order)
        paintCurvePoints(painter, layout, curve, look);
}

void paintSurfaceDrawing(QPainter& painter, const SurfaceCurveLayout& layout,
                         const SurfaceCurveDrawing& drawing, const SurfaceCurveLook& look)
{
    const QColor accent = Theme::color(ColorRole::AccentText);
    QPolygonF line;
    const std::vector<QVector3D> places = linePlaces(layout.view(), layout.content().preview, {}, false);
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        line += pieceOf(layout.view(), places, i, false);
    if (line.size() > 1)
        paintToolLine(painter, line, accent, 2.0, Qt::DashLine);
    if (!drawing.pointer() || look.hovered.kind != SurfaceCurvePart::Kind::None)
        return;
    if (const auto pixel = layout.view().project(drawing.pointer()->pick.point))
        paintHandle(painter, line.isEmpty() ? *pixel : line.last(),
                    {.form = drawing.hasCursor() ? HandleLook::Form::Diamond : HandleLook::Form::Circle,
                     .radius = 4.0,
                     .color = accent});
}

void paintSurfaceHint(QPainter& painter, const SurfaceCurveLayout& layout, const SurfaceCurveLook& look)
{
    const QString text = !look.refusal.isEmpty() ? look.refusal
                         : look.isDrawing        ? drawingHint(layout, look)
                                                 : QString();
    if (text.isEmpty())
        return;
    const QRectF plate = paintToolHint(painter, layout.view().size, text);
    if (!look.refusal.isEmpty())
        paintBadge(painter, {plate.left() - 12.0, plate.center().y()});
}

} // namespace quadrille::widgets
