// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathpaint.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/patheditor.h"
#include "widgets/tools/toolpaint.h"
#include "widgets/viewport/scenemarks.h"

#include <QPainter>
#include <cmath>

namespace quadrille::widgets {

namespace {

/// Small arrowheads that tell which way the path runs.
void paintDirection(QPainter& painter, const QPolygonF& line, const QColor& color)
{
    constexpr double apart = 90.0; // pixels
    constexpr double size = 5.0;
    double walked = apart / 2.0;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QLineF piece(line[i], line[i + 1]);
        walked += piece.length();
        if (walked < apart || piece.length() < 1e-6)
            continue;
        walked = 0.0;
        const QPointF along = (piece.p2() - piece.p1()) / piece.length();
        const QPointF across(-along.y(), along.x());
        const QPointF tip = piece.center() + size * along;
        paintToolLine(painter,
                      QPolygonF{tip - size * along * 1.6 + size * across, tip,
                                tip - size * along * 1.6 - size * across},
                      color, 2.0, Qt::SolidLine);
    }
}

/// Lines from points in space to the ground below them.
void paintFeet(QPainter& painter, const PathLayout& layout)
{
    const GroundView& view = layout.view();
    const PathShape& shape = layout.shape();
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const bool isActive = layout.selected().kind == PathPart::Kind::Point && layout.selected().at() == i;
        if (isHandle(shape.kind, i) && !isActive)
            continue;
        const QVector3D foot = view.onGround(shape.points[i]);
        const auto from = view.project(shape.points[i]);
        const auto to = view.project(foot);
        if (!from || !to)
            continue;
        const QColor color = Theme::color(isActive ? ColorRole::AccentText : ColorRole::Line);
        paintToolLine(painter, {*from, *to}, color, isActive ? 1.5 : 1.0, Qt::DashLine);
        const double pixels = static_cast<double>(view.ruler.of(0.06F) / view.unitsPerPixel(foot));
        const double flat =
            std::max(0.25, std::abs(std::sin(static_cast<double>(view.camera.pitch) * M_PI / 180.0)));
        painter.setPen(QPen(color, 1.5));
        painter.drawEllipse(*to, pixels, pixels * flat);
        if (isActive)
            paintToolWords(painter, (*from + *to) / 2.0 + QPointF(44.0, 8.0),
                           view.ruler.text(static_cast<double>((shape.points[i] - foot).length())));
    }
}

/// The arrow up and down.
void paintLift(QPainter& painter, const QPointF& at)
{
    painter.setPen(Qt::NoPen);
    for (const double way : {-1.0, 1.0})
        paintToolLine(painter,
                      {at + QPointF(-5, 2 * way), at + QPointF(0, 8 * way), at + QPointF(5, 2 * way)},
                      Theme::color(ColorRole::AccentText), 2.0, Qt::SolidLine);
}

HandleLook lookOf(const PathPart& part, const PathShape& shape)
{
    using Kind = PathPart::Kind;
    using Form = HandleLook::Form;
    switch (part.kind) {
    case Kind::StretchStart:
    case Kind::StretchEnd:
        return {.form = Form::Diamond, .color = Theme::color(ColorRole::Demanded)};
    case Kind::Obstacle:
        return {.form = Form::Cross, .radius = 6.0, .color = Theme::color(ColorRole::Text)};
    case Kind::ObstacleCorner:
        return {.form = Form::Square, .radius = 4.0, .color = Theme::color(ColorRole::Text)};
    default:
        break;
    }
    if (isHandle(shape.kind, part.at()))
        return {.radius = 3.5, .color = Theme::color(ColorRole::TextMuted)};
    const bool isLast = part.at() + 1 == shape.points.size();
    return {.form = isLast ? Form::Square : Form::Circle, .color = Theme::color(ColorRole::Text)};
}

void paintHandles(QPainter& painter, const PathLayout& layout, const PathPart& hovered)
{
    const PathShape& shape = layout.shape();
    for (std::size_t i = 0; i < shape.points.size(); ++i)
        if (isHandle(shape.kind, i)) {
            const QVector3D& anchor = shape.points[anchorIndex(shape.kind, anchorOf(shape.kind, i))];
            paintToolLine(painter, layout.view().project(std::vector{shape.points[i], anchor}),
                          Theme::color(ColorRole::TextMuted), 1.0, Qt::SolidLine);
        }
    for (const PathPart& part : layout.parts()) {
        const auto pixel = layout.pixelOf(part);
        if (!pixel)
            continue;
        if (part.kind == PathPart::Kind::Lift) {
            paintLift(painter, *pixel);
            continue;
        }
        HandleLook look = lookOf(part, shape);
        look.isSelected = part == layout.selected();
        look.isHovered = part == hovered;
        paintHandle(painter, *pixel, look);
    }
}

void paintDot(QPainter& painter, const GroundView& view, const QVector3D& place)
{
    if (const auto pixel = view.project(place))
        paintHandle(painter, *pixel, {.color = Theme::color(ColorRole::AccentText)});
}

void paintLine(QPainter& painter, const GroundView& view, const std::vector<QVector3D>& line, double width,
               Qt::PenStyle style)
{
    paintToolLine(painter, view.project(line), Theme::color(ColorRole::AccentText), width, style);
}

/// How long something is, below a place.
void paintLength(QPainter& painter, const GroundView& view, const QVector3D& place, double length)
{
    if (const auto pixel = view.project(place))
        paintToolWords(painter, *pixel + QPointF(0.0, 24.0), view.ruler.text(length));
}

void paintPoints(QPainter& painter, const PathLayout& layout, const PathDrawing& drawing,
                 const PathSampler& sampler)
{
    const GroundView& view = layout.view();
    const std::vector<QVector3D> planned = drawing.preview(layout.shape());
    if (drawing.gesture() == PathDrawing::Gesture::Stroke && drawing.hasMoved()) {
        paintLine(painter, view, drawing.stroke(), 2.0, Qt::SolidLine);
    } else if (!planned.empty()) {
        const SampledCurve sampled(sampler(layout.shape().kind, planned));
        paintLine(painter, view, sampled.points(), 2.0, Qt::DashLine);
        paintLength(painter, view, planned.back(), sampled.length());
    }
    if (drawing.gesture() == PathDrawing::Gesture::Pull && drawing.pointer() && drawing.hasMoved()) {
        const QVector3D handle = *drawing.pointer();
        const QVector3D opposite = 2.0F * drawing.start() - handle;
        paintLine(painter, view, {opposite, handle}, 1.0, Qt::SolidLine);
        paintDot(painter, view, handle);
        paintDot(painter, view, opposite);
    }
    if (drawing.firstPoint())
        paintDot(painter, view, *drawing.firstPoint());
}

/// What mouse and keys do.
QString hint(PathMode mode, PathKind kind)
{
    switch (mode) {
    case PathMode::Draw:
        return kind == PathKind::Bezier
                   ? PathEditor::tr(
                         "Click for a point, pull for its handles · Return ends · Backspace takes one back")
                   : PathEditor::tr(
                         "Click for points, or drag a stroke · Return ends · Backspace takes one back");
    case PathMode::Disc:
        return PathEditor::tr("Drag from the middle of the obstacle · Esc gives up");
    case PathMode::Polygon:
        return PathEditor::tr("Click the corners of the obstacle · Return ends · Esc gives up");
    case PathMode::Edit:
        break;
    }
    return {};
}

} // namespace

void paintPath(QPainter& painter, const PathLayout& layout, const PathPart& hovered)
{
    if (!layout.curve().isEmpty())
        paintDirection(painter, layout.view().project(layout.curve().points()),
                       Theme::color(ColorRole::ViewportText));
    if (layout.shape().inSpace)
        paintFeet(painter, layout);
    paintHandles(painter, layout, hovered);
}

void paintPathDrawing(QPainter& painter, const PathLayout& layout, const PathDrawing& drawing,
                      const PathSampler& sampler)
{
    const GroundView& view = layout.view();
    const auto& pointer = drawing.pointer();
    if (drawing.mode() == PathMode::Draw) {
        paintPoints(painter, layout, drawing, sampler);
    } else if (drawing.mode() == PathMode::Polygon) {
        std::vector<QVector3D> outline = drawing.corners();
        if (pointer)
            outline.push_back(*pointer);
        paintLine(painter, view, outline, 2.0, Qt::DashLine);
        for (const QVector3D& corner : drawing.corners())
            paintDot(painter, view, corner);
    } else if (drawing.gesture() == PathDrawing::Gesture::Radius && pointer) {
        const float radius = (*pointer - drawing.start()).length();
        std::vector<QVector3D> circle = circleOnGround(drawing.start(), radius, view.up());
        circle.push_back(circle.front());
        paintLine(painter, view, circle, 2.0, Qt::DashLine);
        paintLength(painter, view, *pointer, static_cast<double>(radius));
    }
    if (pointer && drawing.gesture() == PathDrawing::Gesture::None)
        paintDot(painter, view, *pointer);
    constexpr double margin = 24.0;
    paintToolWords(painter, {view.size.width() / 2.0, view.size.height() - margin},
                   hint(drawing.mode(), layout.shape().kind));
}

} // namespace quadrille::widgets
