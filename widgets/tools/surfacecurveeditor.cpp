// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacecurveeditor.h"

#include "widgets/theme/theme.h"
#include "widgets/tools/surfacecurveeditorprivate.h"

#include <QtMath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

SurfaceCurveEditor::SurfaceCurveEditor(Viewport& viewport, QObject* parent)
    : HandleTool(parent), d(std::make_unique<Private>(*this, viewport))
{
    connect(&Theme::instance(), &Theme::changed, this, &SurfaceCurveEditor::repaintRequested);
    connect(&viewport, &Viewport::figureChanged, this, [this](int figure) {
        if (figure != d->figure)
            return;
        d->seenCache.reset();
        emit repaintRequested();
    });
}

SurfaceCurveEditor::~SurfaceCurveEditor() = default;

void SurfaceCurveEditor::setFigure(int figure)
{
    if (figure == d->figure)
        return;
    d->figure = figure;
    d->neighbours.clear();
    d->seenCache.reset();
    d->pointer.reset();
    d->cursor.reset();
    d->drag.reset();
    emit repaintRequested();
}

int SurfaceCurveEditor::figure() const
{
    return d->figure;
}

void SurfaceCurveEditor::setCurves(std::vector<ShownCurve> curves)
{
    if (d->drag &&
        (d->drag->part.curve >= static_cast<int>(curves.size()) ||
         d->drag->part.point >=
             static_cast<int>(curves[static_cast<std::size_t>(d->drag->part.curve)].points.size())))
        d->drag.reset(); // undone under the pointer
    d->curves = std::move(curves);
    d->seenCache.reset();
    d->hovered = {};
    if (!d->isThere(d->selected))
        setSelected({});
    emit repaintRequested();
}

const std::vector<ShownCurve>& SurfaceCurveEditor::curves() const
{
    return d->curves;
}

void SurfaceCurveEditor::setDrawn(int curve)
{
    d->drawn = curve;
    emit repaintRequested();
}

int SurfaceCurveEditor::drawn() const
{
    return d->drawn;
}

void SurfaceCurveEditor::setPreview(std::vector<std::uint32_t> vertices)
{
    d->preview = std::move(vertices);
    emit repaintRequested();
}

void SurfaceCurveEditor::setRefusal(const QString& text)
{
    d->refusal = text;
    emit repaintRequested();
}

const QString& SurfaceCurveEditor::refusal() const
{
    return d->refusal;
}

void SurfaceCurveEditor::setActive(bool active)
{
    if (active == d->active)
        return;
    if (!active) {
        endDrag(false);
        setMode(Mode::Edit);
        setSelected({});
    }
    d->active = active;
    emit repaintRequested();
}

bool SurfaceCurveEditor::isActive() const
{
    return d->active;
}

void SurfaceCurveEditor::setMode(Mode mode)
{
    if (mode == d->mode)
        return;
    d->mode = mode;
    d->refusal.clear();
    d->preview.clear();
    d->pointer.reset();
    d->cursor.reset();
    d->hovered = {};
    if (mode == Mode::Draw)
        setSelected({});
    emit cursorRequested(mode == Mode::Draw ? Qt::CrossCursor : Qt::ArrowCursor);
    emit modeChanged(mode);
    emit repaintRequested();
}

SurfaceCurveEditor::Mode SurfaceCurveEditor::mode() const
{
    return d->mode;
}

void SurfaceCurveEditor::setSelected(const SurfaceCurvePart& part)
{
    if (part == d->selected)
        return;
    d->selected = part;
    emit selectionChanged(part);
    emit repaintRequested();
}

const SurfaceCurvePart& SurfaceCurveEditor::selected() const
{
    return d->selected;
}

bool SurfaceCurveEditor::isDragging() const
{
    return d->drag.has_value();
}

std::optional<QPointF> SurfaceCurveEditor::pixelOf(const SurfaceCurvePart& part) const
{
    return d->isThere(part) ? d->project(d->vertexOf(part)) : std::nullopt;
}

bool SurfaceCurveEditor::isSeen(const SurfaceCurvePart& part) const
{
    if (!d->isThere(part))
        return false;
    const auto curve = static_cast<std::size_t>(part.curve);
    const auto pixel = d->project(d->vertexOf(part));
    const std::size_t at = part.kind == SurfaceCurvePart::Kind::Point
                               ? d->curves[curve].points[static_cast<std::size_t>(part.point)]
                               : 0;
    return pixel && QRectF(QPointF(), viewSize()).contains(*pixel) && d->seen()[curve][at];
}

SurfaceCurvePart SurfaceCurveEditor::partAt(const QPointF& position) const
{
    SurfaceCurvePart found;
    double nearest = surfacePointReach;
    for (const SurfaceCurvePart& part : d->points()) {
        const auto pixel = pixelOf(part);
        if (!pixel || (!isSeen(part) && part != d->selected))
            continue;
        const double advantage = part == d->selected ? 4.0 : 0.0;
        const double distance = distanceBetween(*pixel, position);
        if (distance < surfacePointReach && distance - advantage < nearest) {
            nearest = distance - advantage;
            found = part;
        }
    }
    if (found.kind != SurfaceCurvePart::Kind::None)
        return found;
    nearest = surfaceCurveReach;
    for (std::size_t c = 0; c < d->curves.size(); ++c) {
        const ShownCurve& curve = d->curves[c];
        const std::size_t count = curve.vertices.size();
        for (std::size_t i = 0; i < (curve.isClosed ? count : count - std::min<std::size_t>(count, 1)); ++i) {
            const std::size_t next = (i + 1) % count;
            if (!d->seen()[c][i] && !d->seen()[c][next])
                continue;
            const auto a = d->project(curve.vertices[i]);
            const auto b = d->project(curve.vertices[next]);
            if (const double distance = a && b ? distanceToSegment(position, *a, *b) : surfaceCurveReach;
                distance < nearest) {
                nearest = distance;
                found = {SurfaceCurvePart::Kind::Curve, static_cast<int>(c), 0};
            }
        }
    }
    return found;
}

void SurfaceCurveEditor::reveal(const SurfaceCurvePart& part)
{
    const auto shape = d->shape();
    if (!shape || !d->isThere(part) || isSeen(part))
        return;
    const std::uint32_t vertex = d->vertexOf(part);
    const QVector3D normal = d->normalAt(vertex);
    Turntable view = camera();
    const bool isUpright = view.upAxis == UpAxis::Y;
    const float ahead = isUpright ? normal.z() : -normal.y();
    const float rise = isUpright ? normal.y() : normal.z();
    if (std::hypot(normal.x(), ahead) > 0.05F)
        view.yaw = qRadiansToDegrees(std::atan2(normal.x(), ahead));
    constexpr float steepest = 60.0F; // degrees
    view.pitch = std::clamp(qRadiansToDegrees(std::asin(std::clamp(rise, -1.0F, 1.0F))), -steepest, steepest);
    QPointF pixel;
    if (!view.project(shape->place(vertex), viewSize(), &pixel) ||
        !QRectF(QPointF(), viewSize()).contains(pixel))
        view.target = shape->place(vertex);
    d->viewport.setCamera(view);
}

void SurfaceCurveEditor::viewChanged()
{
    d->seenCache.reset();
    d->pointer.reset();
}

} // namespace quadrille::widgets
