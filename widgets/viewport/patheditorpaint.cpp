// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"
#include "widgets/viewport/patheditorprivate.h"
#include "widgets/viewport/toolpaint.h"
#include "widgets/viewport/viewportoverlay.h"

#include <QPainter>
#include <cmath>
#include <limits>

namespace quadrille::widgets {

namespace {

QPolygonF polygon(const PathEditor& editor, const std::vector<QVector3D>& points)
{
    QPolygonF pixels;
    for (const QVector3D& point : points) {
        QPointF pixel;
        if (editor.camera().project(point, editor.viewSize(), &pixel))
            pixels << pixel;
    }
    return pixels;
}

/// Small arrowheads that tell which way the path runs.
void drawDirection(QPainter& painter, const QPolygonF& line, const QColor& color)
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

} // namespace

std::vector<QVector3D> PathEditor::Private::handles() const
{
    std::vector<QVector3D> all;
    for (std::size_t i = 0; i < shape.points.size(); ++i)
        if (!isHandle(shape.kind, i))
            all.push_back(shape.points[i]);
    for (const PathStretch& stretch : shape.stretches) {
        if (curve.isEmpty())
            break;
        all.push_back(curve.at(stretch.from));
        all.push_back(curve.at(std::min(stretch.to, curve.length())));
    }
    for (const PathObstacle& obstacle : shape.obstacles)
        all.insert(all.end(), obstacle.corners.begin(), obstacle.corners.end());
    return all;
}

QVector3D PathEditor::Private::clearPlace(const PathStretch& stretch) const
{
    const double to = std::min(stretch.to, curve.length());
    const std::vector<QVector3D> handles = this->handles();
    constexpr int places = 40;
    QVector3D best = curve.at((stretch.from + to) / 2.0);
    float widest = -1.0F;
    // From the middle to both sides: of places that are as good, the one nearest to the middle is taken.
    for (int i = 0; i < places; ++i) {
        const int away = (i + 1) / 2;
        const double aside = (i % 2 == 0 ? 1.0 : -1.0) * away / places;
        const QVector3D place = curve.at(stretch.from + (to - stretch.from) * (0.5 + aside));
        float nearest = std::numeric_limits<float>::max();
        for (const QVector3D& handle : handles)
            nearest = std::min(nearest, (place - handle).length());
        if (nearest > widest * 1.02F) {
            widest = nearest;
            best = place;
        }
    }
    return best;
}

void PathEditor::refreshMarks()
{
    SceneMarks marks;
    if (d->active) {
        marks.handles = d->handles();
        const QColor line = Theme::color(ColorRole::ViewportText);
        const QColor demanded = Theme::color(ColorRole::Demanded);
        for (const PathStretch& stretch : d->shape.stretches) {
            if (d->curve.isEmpty())
                break;
            marks.curves.push_back({.points = d->curve.part(stretch.from, stretch.to),
                                    .color = demanded,
                                    .colors = {},
                                    .width = 9.0F});
            marks.labels.push_back({d->clearPlace(stretch), stretch.text, demanded});
        }
        if (!d->curve.isEmpty())
            marks.curves.push_back({.points = d->curve.points(), .color = line, .colors = {}, .width = 2.5F});
        for (const PathObstacle& obstacle : d->shape.obstacles) {
            const QColor color =
                Theme::color(obstacle.problem.isEmpty() ? ColorRole::Line : ColorRole::Error);
            const auto outline = obstacle.isDisc()
                                     ? circleOnGround(obstacle.corners[0], obstacle.radius, d->up())
                                     : obstacle.corners;
            marks.areas.push_back({.outline = outline, .color = color, .hatched = true});
            if (d->shape.clearance > 0.0F) {
                auto around = widenedOutline(obstacle, d->shape.clearance, d->up());
                around.push_back(around.front());
                marks.curves.push_back({.points = around,
                                        .color = color,
                                        .colors = {},
                                        .width = 1.5F,
                                        .dash = d->ruler().of(0.08F)});
            }
            if (!obstacle.problem.isEmpty())
                marks.labels.push_back({obstacle.corners[0], obstacle.problem, color});
        }
    }
    d->viewport.setMarks(QStringLiteral("path"), marks);
    emit repaintRequested();
}

void PathEditor::Private::paintSpace(QPainter& painter) const
{
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const bool isActive = selected.kind == PathPart::Kind::Point && selected.index == static_cast<int>(i);
        if (isHandle(shape.kind, i) && !isActive)
            continue;
        const QVector3D foot = onGround(shape.points[i]);
        const auto from = project(shape.points[i]);
        const auto to = project(foot);
        if (!from || !to)
            continue;
        const QColor color = Theme::color(isActive ? ColorRole::AccentText : ColorRole::Line);
        paintToolLine(painter, {*from, *to}, color, isActive ? 1.5 : 1.0, Qt::DashLine);
        const double pixels = static_cast<double>(ruler().of(0.06F) / unitsPerPixel(foot));
        const double flat =
            std::max(0.25, std::abs(std::sin(static_cast<double>(owner.camera().pitch) * M_PI / 180.0)));
        painter.setPen(QPen(color, 1.5));
        painter.drawEllipse(*to, pixels, pixels * flat);
        if (isActive)
            paintToolWords(painter, (*from + *to) / 2.0 + QPointF(44.0, 8.0),
                           ruler().text(static_cast<double>((shape.points[i] - foot).length())));
    }
}

void PathEditor::Private::paintHandles(QPainter& painter) const
{
    using Kind = PathPart::Kind;
    const QColor line = Theme::color(ColorRole::Text);
    if (shape.kind == PathKind::Bezier) {
        for (std::size_t i = 0; i < shape.points.size(); ++i) {
            if (isHandle(shape.kind, i))
                paintToolLine(
                    painter,
                    polygon(owner, {shape.points[i],
                                    shape.points[anchorIndex(shape.kind, anchorOf(shape.kind, i))]}),
                    Theme::color(ColorRole::TextMuted), 1.0, Qt::SolidLine);
        }
    }
    for (const PathPart& part : parts()) {
        const auto pixel = owner.pixelOf(part);
        if (!pixel)
            continue;
        HandleLook look{.color = line, .isSelected = part == selected, .isHovered = part == hovered};
        switch (part.kind) {
        case Kind::StretchStart:
        case Kind::StretchEnd:
            look.form = HandleLook::Form::Diamond;
            look.color = Theme::color(ColorRole::Demanded);
            break;
        case Kind::Obstacle:
            look.form = HandleLook::Form::Cross;
            look.radius = 6.0;
            break;
        case Kind::ObstacleCorner:
            look.form = HandleLook::Form::Square;
            look.radius = 4.0;
            break;
        case Kind::Lift:
            painter.setPen(Qt::NoPen);
            paintToolLine(painter,
                          {*pixel + QPointF(-5, -2), *pixel + QPointF(0, -8), *pixel + QPointF(5, -2)},
                          Theme::color(ColorRole::AccentText), 2.0, Qt::SolidLine);
            paintToolLine(painter, {*pixel + QPointF(-5, 2), *pixel + QPointF(0, 8), *pixel + QPointF(5, 2)},
                          Theme::color(ColorRole::AccentText), 2.0, Qt::SolidLine);
            continue;
        default:
            if (isHandle(shape.kind, static_cast<std::size_t>(part.index))) {
                look.radius = 3.5;
                look.color = Theme::color(ColorRole::TextMuted);
            } else if (part.index + 1 == static_cast<int>(shape.points.size())) {
                look.form = HandleLook::Form::Square;
            }
            break;
        }
        paintHandle(painter, *pixel, look);
    }
}

void PathEditor::Private::paintDrawing(QPainter& painter) const
{
    const QColor accent = Theme::color(ColorRole::AccentText);
    const auto dot = [&](const QVector3D& place) {
        if (const auto pixel = project(place))
            paintHandle(painter, *pixel, {.color = accent});
    };
    if (mode == Mode::Draw) {
        const std::vector<QVector3D> planned = preview();
        if (drag.kind == PathDrag::Kind::Stroke && drag.moved) {
            paintToolLine(painter, polygon(owner, drag.stroke), accent, 2.0, Qt::SolidLine);
        } else if (!planned.empty()) {
            const SampledCurve sampled(sampler(shape.kind, planned));
            paintToolLine(painter, polygon(owner, sampled.points()), accent, 2.0, Qt::DashLine);
            if (const auto pixel = project(planned.back()))
                paintToolWords(painter, *pixel + QPointF(0.0, 24.0), ruler().text(sampled.length()));
        }
        if (drag.kind == PathDrag::Kind::Pull && pointer && drag.moved) {
            paintToolLine(painter, polygon(owner, {2.0F * drag.start - *pointer, *pointer}), accent, 1.0,
                          Qt::SolidLine);
            dot(*pointer);
            dot(2.0F * drag.start - *pointer);
        }
        if (firstPoint)
            dot(*firstPoint);
    } else if (mode == Mode::Polygon) {
        std::vector<QVector3D> outline = corners;
        if (pointer)
            outline.push_back(*pointer);
        paintToolLine(painter, polygon(owner, outline), accent, 2.0, Qt::DashLine);
        for (const QVector3D& corner : corners)
            dot(corner);
    } else if (drag.kind == PathDrag::Kind::Radius && pointer) {
        const float radius = (*pointer - drag.start).length();
        std::vector<QVector3D> circle = circleOnGround(drag.start, radius, up());
        circle.push_back(circle.front());
        paintToolLine(painter, polygon(owner, circle), accent, 2.0, Qt::DashLine);
        if (const auto pixel = project(*pointer))
            paintToolWords(painter, *pixel + QPointF(0.0, 24.0), ruler().text(static_cast<double>(radius)));
    }
    if (pointer && drag.kind == PathDrag::Kind::None)
        dot(*pointer);
}

QString PathEditor::Private::hint() const
{
    switch (mode) {
    case Mode::Draw:
        return shape.kind == PathKind::Bezier
                   ? PathEditor::tr(
                         "Click for a point, pull for its handles · Return ends · Backspace takes one back")
                   : PathEditor::tr(
                         "Click for points, or drag a stroke · Return ends · Backspace takes one back");
    case Mode::Disc:
        return PathEditor::tr("Drag from the middle of the obstacle · Esc gives up");
    case Mode::Polygon:
        return PathEditor::tr("Click the corners of the obstacle · Return ends · Esc gives up");
    case Mode::Edit:
        break;
    }
    return {};
}

void PathEditor::paint(QPainter& painter) const
{
    if (!d->active)
        return;
    if (!d->curve.isEmpty())
        drawDirection(painter, polygon(*this, d->curve.points()), Theme::color(ColorRole::ViewportText));
    if (d->shape.inSpace)
        d->paintSpace(painter);
    d->paintHandles(painter);
    if (d->mode == Mode::Edit)
        return;
    d->paintDrawing(painter);
    constexpr double margin = 24.0;
    paintToolWords(painter, {viewSize().width() / 2.0, viewSize().height() - margin}, d->hint());
}

} // namespace quadrille::widgets
