// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/patheditorprivate.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <utility>

namespace quadrille::widgets {

namespace {

bool isArrow(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
           key == Qt::Key_PageUp || key == Qt::Key_PageDown;
}

} // namespace

Qt::CursorShape PathEditor::Private::cursorFor(const PathPart& part, Mode mode)
{
    if (mode != Mode::Edit)
        return Qt::CrossCursor;
    switch (part.kind) {
    case PathPart::Kind::Point:
    case PathPart::Kind::Obstacle:
    case PathPart::Kind::ObstacleCorner:
        return Qt::SizeAllCursor;
    case PathPart::Kind::Lift:
        return Qt::SizeVerCursor;
    case PathPart::Kind::StretchStart:
    case PathPart::Kind::StretchEnd:
    case PathPart::Kind::ObstacleRadius:
        return Qt::SizeHorCursor;
    case PathPart::Kind::Curve:
        return Qt::PointingHandCursor;
    case PathPart::Kind::None:
        break;
    }
    return Qt::ArrowCursor;
}

bool PathEditor::isReady() const
{
    return d->active;
}

bool PathEditor::isDrawing() const
{
    return d->mode != Mode::Edit;
}

void PathEditor::leave()
{
    d->pointer.reset();
    d->hovered = {};
}

bool PathEditor::press(const QMouseEvent& event)
{
    d->clickOnNothing.reset();
    if (isDragging())
        return true;
    if (event.button() == Qt::RightButton && d->mode != Mode::Edit) {
        finishMode();
        return true;
    }
    if (event.button() == Qt::RightButton) {
        d->isMenuPress = partAt(event.position()).kind != PathPart::Kind::None;
        return d->isMenuPress;
    }
    if (event.button() != Qt::LeftButton)
        return false;
    if (d->mode == Mode::Edit) {
        const PathPart part = partAt(event.position());
        if (part.kind == PathPart::Kind::None || part.kind == PathPart::Kind::Curve) {
            d->clickOnNothing = event.position();
            return false;
        }
        d->drag = d->startOf(part, event);
        if (part.kind == PathPart::Kind::ObstacleRadius)
            d->drag.start = d->drag.grabbed;
        else
            setSelected(part.kind == PathPart::Kind::Lift ? PathPart{PathPart::Kind::Point, part.index, 0}
                                                          : part);
        if (part.kind == PathPart::Kind::ObstacleRadius)
            setSelected({PathPart::Kind::Obstacle, part.index, 0});
        emit repaintRequested();
        return true;
    }
    const auto place = d->newPlace(event.position(), event.modifiers());
    if (!place)
        return true;
    d->pointer = place;
    if (d->mode == Mode::Polygon) {
        const auto first = d->corners.empty() ? std::nullopt : d->project(d->corners.front());
        constexpr double closeEnough = 12.0; // pixels
        if (first && d->corners.size() > 2 && (*first - event.position()).manhattanLength() < closeEnough) {
            finishMode();
            return true;
        }
        d->corners.push_back(*place);
        emit repaintRequested();
        return true;
    }
    d->drag = {};
    d->drag.kind = d->mode == Mode::Disc               ? PathDrag::Kind::Radius
                   : d->shape.kind == PathKind::Bezier ? PathDrag::Kind::Pull
                                                       : PathDrag::Kind::Stroke;
    d->drag.start = *place;
    d->drag.pressedAt = event.position();
    d->drag.stroke = {*place};
    return true;
}

bool PathEditor::move(const QMouseEvent& event)
{
    if (!isDragging()) {
        if (event.buttons() == Qt::NoButton)
            hover(event);
        return false;
    }
    if (!d->drag.moved && !isDrag(d->drag.pressedAt, event.position()))
        return true;
    d->drag.moved = true;
    if (d->drag.kind == PathDrag::Kind::Part) {
        dragTo(event);
        return true;
    }
    const float height = d->drag.start[d->upIndex()];
    if (const auto place = d->placeAt(event.position(), height)) {
        d->pointer = place;
        d->drag.stroke.push_back(*place);
    }
    emit repaintRequested();
    return true;
}

void PathEditor::hover(const QMouseEvent& event)
{
    if (d->mode != Mode::Edit) {
        d->pointer = d->newPlace(event.position(), event.modifiers());
        emit repaintRequested();
        return;
    }
    const PathPart part = partAt(event.position());
    if (part == d->hovered)
        return;
    d->hovered = part;
    emit cursorRequested(Private::cursorFor(part, d->mode));
    emit repaintRequested();
}

bool PathEditor::release(const QMouseEvent& event)
{
    if (event.button() == Qt::RightButton && std::exchange(d->isMenuPress, false)) {
        if (const PathPart part = partAt(event.position()); part.kind != PathPart::Kind::None)
            askMenu(part, event.position(), event.globalPosition().toPoint());
        return true;
    }
    if (!isDragging()) {
        if (d->clickOnNothing && !isDrag(*d->clickOnNothing, event.position()))
            setSelected({});
        d->clickOnNothing.reset();
        return false;
    }
    if (event.button() == Qt::LeftButton)
        endDrag(true);
    return true;
}

bool PathEditor::doubleClick(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return false;
    if (d->mode != Mode::Edit) {
        finishMode();
        return true;
    }
    const PathPart part = partAt(event.position());
    if (part.kind == PathPart::Kind::None)
        return false;
    if (part.kind == PathPart::Kind::Curve) {
        double distance = 0.0;
        insertPoint(d->lengthAt(event.position(), &distance).value_or(0.0));
        return true;
    }
    if (part.kind == PathPart::Kind::Point && d->shape.kind == PathKind::Bezier) {
        setSelected(part);
        smoothSelected();
    } else {
        emit activated(part);
    }
    return true;
}

void PathEditor::askMenu(const PathPart& part, const QPointF& position, const QPoint& globalPosition)
{
    double distance = 0.0;
    if (part.kind != PathPart::Kind::Curve)
        setSelected(part);
    emit contextMenuRequested(part, d->lengthAt(position, &distance).value_or(0.0), globalPosition);
}

bool PathEditor::wantsKey(const QKeyEvent& event) const
{
    const bool hasSelection = d->placeOf(d->selected).has_value();
    switch (event.key()) {
    case Qt::Key_Escape:
        return isDragging() || hasSelection || isDrawing();
    case Qt::Key_Menu:
        return hasSelection;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return isDrawing() || hasSelection;
    case Qt::Key_Insert:
        return isDrawing() || !d->shape.points.empty();
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        return !d->parts().empty();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return hasSelection || (isDrawing() && !d->drawnPoints().empty());
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
        return d->selected.kind == PathPart::Kind::Obstacle;
    default:
        return isArrow(event.key()) && hasSelection;
    }
}

void PathEditor::leaveDrawing()
{
    setMode(Mode::Edit);
}

void PathEditor::clearSelection()
{
    setSelected({});
}

void PathEditor::confirm()
{
    if (!finishMode())
        emit activated(d->selected);
}

void PathEditor::askMenuByKey()
{
    if (const auto pixel = pixelOf(d->selected))
        askMenu(d->selected, *pixel, d->viewport.mapToGlobal(pixel->toPoint()));
}

bool PathEditor::removeByKey()
{
    if (d->mode != Mode::Draw || isDragging())
        return deleteSelected();
    // Takes back the last point, as drawing programs do.
    const std::size_t anchors = anchorCount(d->shape.kind, d->shape.points.size());
    d->firstPoint.reset();
    if (anchors > 0)
        emit pointsEdited(removedAnchor(d->shape.kind, d->shape.points, anchors - 1), PathEdit::Delete, true);
    emit repaintRequested();
    return true;
}

bool PathEditor::pressOther(const QKeyEvent& event)
{
    constexpr float radiusStep = 0.05F; // metres
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return resizeSelected(d->ruler().of(radiusStep));
    case Qt::Key_Minus:
        return resizeSelected(-d->ruler().of(radiusStep));
    default:
        return nudge(event.key(), event.modifiers());
    }
}

} // namespace quadrille::widgets
