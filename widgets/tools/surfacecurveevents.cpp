// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What mouse and keys do to the curves.
#include "widgets/tools/surfacecurveeditorprivate.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <utility>

namespace quadrille::widgets {

namespace {

using CurvePart = SurfaceCurvePart;

/// Where an arrow key points on the view; null for other keys.
QPointF directionOf(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return {-1.0, 0.0};
    case Qt::Key_Right:
        return {1.0, 0.0};
    case Qt::Key_Up:
        return {0.0, -1.0};
    case Qt::Key_Down:
        return {0.0, 1.0};
    default:
        return {};
    }
}

int stepsOf(Qt::KeyboardModifiers modifiers)
{
    return modifiers.testFlag(Qt::ShiftModifier) ? 5 : 1;
}

} // namespace

bool SurfaceCurveEditor::isReady() const
{
    return d->active && d->shape();
}

bool SurfaceCurveEditor::isDrawing() const
{
    return d->mode == Mode::Draw;
}

void SurfaceCurveEditor::leave()
{
    d->hovered = {};
    if (std::exchange(d->pointer, std::nullopt))
        emit pointerMoved(std::nullopt);
}

bool SurfaceCurveEditor::press(const QMouseEvent& event)
{
    d->pressedAt.reset();
    if (isDragging())
        return true;
    if (d->mode == Mode::Draw) {
        if (event.button() == Qt::LeftButton)
            d->pressedAt = event.position();
        return false;
    }
    const CurvePart part = partAt(event.position());
    if (event.button() == Qt::RightButton) {
        d->isMenuPress = part.kind != CurvePart::Kind::None;
        return d->isMenuPress;
    }
    if (event.button() != Qt::LeftButton)
        return false;
    if (part.kind == CurvePart::Kind::Curve && event.modifiers().testFlag(Qt::ControlModifier)) {
        if (const auto place = d->placeAt(event.position(), event.modifiers()))
            insertAt({CurvePart::Kind::Point, part.curve, d->pointBefore(part.curve, event.position())},
                     *place);
        return true;
    }
    if (part.kind != CurvePart::Kind::Point) {
        d->pressedAt = event.position();
        return false;
    }
    SurfaceDrag drag;
    drag.part = part;
    drag.pressedAt = event.position();
    drag.grabbed = pixelOf(part).value_or(event.position()) - event.position();
    d->drag = drag;
    setSelected(part);
    emit cursorRequested(Qt::ClosedHandCursor);
    emit repaintRequested();
    return true;
}

bool SurfaceCurveEditor::move(const QMouseEvent& event)
{
    if (!isDragging()) {
        if (event.buttons() == Qt::NoButton)
            hover(event);
        return false;
    }
    if (d->drag->moved || isDrag(d->drag->pressedAt, event.position())) {
        d->drag->moved = true;
        dragTo(event);
    }
    return true;
}

void SurfaceCurveEditor::hover(const QMouseEvent& event)
{
    if (d->mode == Mode::Draw) {
        d->cursor.reset();
        const auto before = d->hovered;
        d->hovered =
            d->closesAt(event.position()) ? CurvePart{CurvePart::Kind::Point, d->drawn, 0} : CurvePart{};
        if (before != d->hovered)
            emit cursorRequested(d->hovered.kind == CurvePart::Kind::Point ? Qt::PointingHandCursor
                                                                           : Qt::CrossCursor);
        d->pointer = d->placeAt(event.position(), event.modifiers());
        emit pointerMoved(d->pointer);
        emit repaintRequested();
        return;
    }
    const CurvePart part = partAt(event.position());
    if (part == d->hovered)
        return;
    d->hovered = part;
    emit cursorRequested(part.kind == CurvePart::Kind::Point   ? Qt::OpenHandCursor
                         : part.kind == CurvePart::Kind::Curve ? Qt::PointingHandCursor
                                                               : Qt::ArrowCursor);
    emit repaintRequested();
}

void SurfaceCurveEditor::dragTo(const QMouseEvent& event)
{
    const auto place = d->placeAt(event.position() + d->drag->grabbed, event.modifiers());
    if (!place) // beside the body: it stays where it was last
        return;
    d->drag->last = place;
    const CurvePart part = d->drag->part;
    emit pointMoved(part.curve, part.point, *place, false);
}

bool SurfaceCurveEditor::release(const QMouseEvent& event)
{
    if (event.button() == Qt::RightButton && std::exchange(d->isMenuPress, false)) {
        if (const CurvePart part = partAt(event.position()); part.kind != CurvePart::Kind::None) {
            setSelected(part);
            emit contextMenuRequested(part, event.globalPosition().toPoint());
        }
        return true;
    }
    if (isDragging()) {
        if (event.button() == Qt::LeftButton)
            endDrag(true);
        return true;
    }
    const auto pressed = std::exchange(d->pressedAt, std::nullopt);
    if (pressed && !isDrag(*pressed, event.position())) {
        if (d->mode == Mode::Draw)
            clickWhileDrawing(event);
        else
            setSelected(partAt(event.position()));
    }
    return false; // the camera ends what it began
}

void SurfaceCurveEditor::clickWhileDrawing(const QMouseEvent& event)
{
    if (d->closesAt(event.position()))
        finishDrawing();
    else if (const auto place = d->placeAt(event.position(), event.modifiers()))
        emit pointAdded(*place);
}

bool SurfaceCurveEditor::doubleClick(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (d->mode == Mode::Draw) {
        finishDrawing();
        return true;
    }
    const CurvePart part = partAt(event.position());
    if (part.kind == CurvePart::Kind::Curve) {
        if (const auto place = d->placeAt(event.position(), event.modifiers()))
            insertAt({CurvePart::Kind::Point, part.curve, d->pointBefore(part.curve, event.position())},
                     *place);
    }
    return part.kind != CurvePart::Kind::None;
}

void SurfaceCurveEditor::endDrag(bool commit)
{
    if (!d->drag)
        return;
    const SurfaceDrag drag = *std::exchange(d->drag, std::nullopt);
    emit cursorRequested(Qt::ArrowCursor);
    emit repaintRequested();
    if (!drag.last)
        return;
    if (commit)
        emit pointMoved(drag.part.curve, drag.part.point, *drag.last, true);
    else
        emit moveCancelled(drag.part.curve);
}

void SurfaceCurveEditor::finishDrawing()
{
    emit drawingFinished();
    setMode(Mode::Edit);
}

void SurfaceCurveEditor::insertAt(const CurvePart& part, const SurfacePlace& place)
{
    emit pointInserted(part.curve, part.point, place);
    setSelected({CurvePart::Kind::Point, part.curve, part.point + 1});
}

void SurfaceCurveEditor::insertByKey()
{
    if (d->mode == Mode::Draw) {
        if (!d->cursor)
            d->cursor = d->firstCursor();
        if (const auto place = d->cursor ? d->placeAt(*d->cursor, {}) : std::nullopt)
            emit pointAdded(*place);
        return;
    }
    // Half the way to the next point, along the curve.
    const ShownCurve& curve = d->curves[static_cast<std::size_t>(d->selected.curve)];
    const auto point = static_cast<std::size_t>(d->selected.point);
    const std::size_t from = curve.points.empty() ? 0 : curve.points[point];
    const std::size_t to = point + 1 < curve.points.size()
                               ? curve.points[point + 1]
                               : curve.vertices.size() + (curve.points.empty() ? 0 : curve.points.front());
    const std::size_t middle = ((from + to) / 2) % curve.vertices.size();
    if (const auto place = d->placeAt(curve.vertices[middle], Qt::AltModifier); place && to > from + 1)
        insertAt({CurvePart::Kind::Point, d->selected.curve, d->selected.point}, *place);
}

bool SurfaceCurveEditor::selectNext(int step)
{
    const CurvePart next = partAfter(d->points(), d->selected, step);
    setSelected(next);
    reveal(next);
    return next.kind != CurvePart::Kind::None;
}

void SurfaceCurveEditor::nudge(int key, Qt::KeyboardModifiers modifiers)
{
    const CurvePart part = d->selected;
    const std::uint32_t from = d->vertexOf(part);
    const std::uint32_t to = d->neighbourAt(from, directionOf(key), stepsOf(modifiers));
    // Snapping would take small steps back.
    if (const auto place = d->placeAt(to, Qt::AltModifier); place && to != from)
        emit pointMoved(part.curve, part.point, *place, true);
    reveal(d->selected);
}

void SurfaceCurveEditor::moveCursor(int key, Qt::KeyboardModifiers modifiers)
{
    if (d->cursor)
        d->cursor = d->neighbourAt(*d->cursor, directionOf(key), stepsOf(modifiers));
    else
        d->cursor = d->firstCursor();
    d->pointer = d->cursor ? d->placeAt(*d->cursor, modifiers) : std::nullopt;
    emit pointerMoved(d->pointer);
    emit repaintRequested();
}

void SurfaceCurveEditor::removeSelected()
{
    const CurvePart part = d->selected;
    if (!d->isThere(part))
        return;
    if (part.kind == CurvePart::Kind::Curve)
        emit curveRemovalRequested(part.curve);
    else
        emit pointRemovalRequested(part.curve, part.point);
}

bool SurfaceCurveEditor::wantsKey(const QKeyEvent& event) const
{
    const bool hasSelection = d->isThere(d->selected);
    const bool hasPoint = hasSelection && d->selected.kind == CurvePart::Kind::Point;
    switch (event.key()) {
    case Qt::Key_Escape:
        return isDrawing() || isDragging() || hasSelection;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Insert:
        return isDrawing() || hasSelection;
    case Qt::Key_Menu:
        return hasSelection;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return !isDrawing() && !d->points().empty();
    default:
        return !directionOf(event.key()).isNull() && (isDrawing() || hasPoint) &&
               !event.modifiers().testFlag(Qt::ControlModifier);
    }
}

void SurfaceCurveEditor::leaveDrawing()
{
    setMode(Mode::Edit);
}

void SurfaceCurveEditor::clearSelection()
{
    setSelected({});
}

void SurfaceCurveEditor::confirm()
{
    if (isDrawing())
        finishDrawing();
    else
        emit activated(d->selected.curve);
}

void SurfaceCurveEditor::askMenuByKey()
{
    if (const auto pixel = pixelOf(d->selected))
        emit contextMenuRequested(d->selected, d->viewport.mapToGlobal(pixel->toPoint()));
}

bool SurfaceCurveEditor::removeByKey()
{
    if (isDrawing())
        emit lastPointRemovalRequested();
    else
        removeSelected();
    return true;
}

bool SurfaceCurveEditor::pressOther(const QKeyEvent& event)
{
    if (isDrawing())
        moveCursor(event.key(), event.modifiers());
    else
        nudge(event.key(), event.modifiers());
    return true;
}

} // namespace quadrille::widgets
