// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What drags, clicks and keys do to the path.
#include "widgets/viewport/patheditorprivate.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr float usualRadius = 0.4F; // metres

} // namespace

double PathEditor::shortestStretch() const
{
    constexpr double metres = 0.05;
    return d->ruler().of(metres);
}

float PathEditor::smallestRadius() const
{
    constexpr float metres = 0.05F;
    return d->ruler().of(metres);
}

PathDrag PathEditor::Private::startOf(const PathPart& part, const QMouseEvent& event) const
{
    PathDrag start;
    start.kind = PathDrag::Kind::Part;
    start.part = part;
    start.before = shape;
    start.pressedAt = event.position();
    start.start = placeOf(part).value_or(QVector3D());
    const bool isAnchor =
        part.kind == PathPart::Kind::Point && !isHandle(shape.kind, static_cast<std::size_t>(part.index));
    start.isLifting = part.kind == PathPart::Kind::Lift ||
                      (isAnchor && shape.inSpace && event.modifiers().testFlag(Qt::AltModifier));
    if (start.isLifting)
        start.grabbed[upIndex()] = heightAt(event.position(), start.start);
    else
        start.grabbed = placeAt(event.position(), start.start[upIndex()]).value_or(start.start);
    return start;
}

void PathEditor::dragTo(const QMouseEvent& event)
{
    const PathDrag& drag = d->drag;
    const PathPart& part = drag.part;
    const auto index = static_cast<std::size_t>(part.index);
    if (part.kind == PathPart::Kind::StretchStart || part.kind == PathPart::Kind::StretchEnd) {
        double distance = 0.0;
        const auto length = d->lengthAt(event.position(), &distance);
        if (!length || index >= d->shape.stretches.size())
            return;
        const PathStretch& before = drag.before.stretches[index];
        if (part.kind == PathPart::Kind::StretchStart)
            emit stretchEdited(part.index, std::clamp(*length, 0.0, before.to - shortestStretch()), before.to,
                               false);
        else
            emit stretchEdited(part.index, before.from, std::max(*length, before.from + shortestStretch()),
                               false);
        return;
    }
    QVector3D place = drag.start;
    if (drag.isLifting) {
        const int up = d->upIndex();
        place[up] += d->heightAt(event.position(), drag.start) - drag.grabbed[up];
        place[up] = std::max(place[up], d->viewport.groundHeight());
        if (const auto step = static_cast<float>(d->ruler().middle());
            event.modifiers().testFlag(Qt::ControlModifier))
            place[up] = std::round(place[up] / step) * step;
    } else if (const auto now = d->placeAt(event.position(), drag.start[d->upIndex()])) {
        place = d->constrained(drag.start, drag.start + *now - drag.grabbed, event.modifiers());
    }
    applyTo(part, place, !event.modifiers().testFlag(Qt::AltModifier), false);
}

void PathEditor::applyTo(const PathPart& part, const QVector3D& place, bool mirrored, bool committed)
{
    const PathShape& base = isDragging() ? d->drag.before : d->shape;
    const auto index = static_cast<std::size_t>(part.index);
    if (part.kind == PathPart::Kind::Point || part.kind == PathPart::Kind::Lift) {
        const bool keepsOpposite =
            mirrored && isHandle(base.kind, index) && isSmooth(base.points, anchorOf(base.kind, index));
        emit pointsEdited(movedPoint(base.kind, base.points, index, place, keepsOpposite), PathEdit::Move,
                          committed);
        return;
    }
    if (index >= base.obstacles.size())
        return;
    PathObstacle obstacle = base.obstacles[index];
    if (part.kind == PathPart::Kind::ObstacleCorner) {
        obstacle.corners[static_cast<std::size_t>(part.corner)] = place;
    } else if (part.kind == PathPart::Kind::ObstacleRadius) {
        obstacle.radius = std::max(smallestRadius(), (place - obstacle.corners.front()).length());
    } else {
        QVector3D middle;
        for (const QVector3D& corner : obstacle.corners)
            middle += corner / static_cast<float>(obstacle.corners.size());
        for (QVector3D& corner : obstacle.corners)
            corner += place - middle;
    }
    emit obstacleEdited(part.index, obstacle, committed);
}

void PathEditor::endDrag(bool commit)
{
    if (d->drag.kind == PathDrag::Kind::Stroke || d->drag.kind == PathDrag::Kind::Pull) {
        finishStroke(commit);
        return;
    }
    if (d->drag.kind == PathDrag::Kind::Radius) {
        if (commit)
            finishObstacle();
        d->drag = {};
        emit repaintRequested();
        return;
    }
    const PathDrag drag = std::exchange(d->drag, {});
    emit repaintRequested();
    if (!drag.moved)
        return;
    const PathShape shape = commit ? d->shape : drag.before;
    const auto index = static_cast<std::size_t>(drag.part.index);
    if (drag.part.kind == PathPart::Kind::Point || drag.part.kind == PathPart::Kind::Lift)
        emit pointsEdited(shape.points, PathEdit::Move, true);
    else if (drag.part.kind == PathPart::Kind::StretchStart || drag.part.kind == PathPart::Kind::StretchEnd)
        emit stretchEdited(drag.part.index, shape.stretches[index].from, shape.stretches[index].to, true);
    else
        emit obstacleEdited(drag.part.index, shape.obstacles[index], true);
}

void PathEditor::finishStroke(bool commit)
{
    const std::vector<QVector3D> pulled = d->preview();
    const PathDrag drag = std::exchange(d->drag, {});
    emit repaintRequested();
    if (!commit)
        return;
    const bool closes = partAt(drag.pressedAt) == PathPart{PathPart::Kind::Point, 0, 0} &&
                        anchorCount(d->shape.kind, d->shape.points.size()) > 2;
    if (!drag.moved) {
        addPoint(closes ? d->shape.points.front() : drag.start);
        if (closes)
            finishMode();
    } else if (drag.kind == PathDrag::Kind::Pull) {
        if (pulled.size() > 1)
            emit pointsEdited(pulled, PathEdit::Add, true);
        else
            addPoint(drag.start);
    } else if (drag.stroke.size() > 1) {
        constexpr float roughness = 6.0F; // pixels
        std::vector<QVector3D> points = d->drawnPoints();
        for (const QVector3D& point : simplifiedStroke(drag.stroke, roughness * d->unitsPerPixel(drag.start)))
            points.push_back(point);
        emit pointsEdited(points, PathEdit::Draw, true);
    }
}

void PathEditor::finishObstacle()
{
    PathObstacle obstacle;
    if (d->mode == Mode::Disc && isDragging()) {
        obstacle.corners = {d->drag.start};
        const float radius = d->pointer ? (*d->pointer - d->drag.start).length() : 0.0F;
        obstacle.radius = d->drag.moved ? std::max(smallestRadius(), radius) : d->ruler().of(usualRadius);
    } else if (d->mode == Mode::Polygon && d->corners.size() > 2) {
        obstacle.corners = d->corners;
    } else {
        return;
    }
    d->drag = {};
    setMode(Mode::Edit);
    emit obstacleAdded(obstacle);
}

bool PathEditor::finishMode()
{
    if (d->mode == Mode::Edit)
        return false;
    if (d->mode == Mode::Polygon && d->corners.size() > 2)
        finishObstacle();
    setMode(Mode::Edit);
    return true;
}

void PathEditor::addPoint(const QVector3D& place)
{
    const std::vector<QVector3D> points = d->drawnPoints();
    constexpr float same = 1e-4F; // metres
    if (points.empty()) {
        d->firstPoint = place;
        emit repaintRequested();
    } else if ((points.back() - place).length() > d->ruler().of(same)) {
        emit pointsEdited(appendedPoint(d->shape.kind, points, place), PathEdit::Add, true);
    }
}

void PathEditor::insertOnCurve(std::size_t anchor, float t, const QVector3D& place)
{
    const auto points = insertedPoint(d->shape.kind, d->shape.points, anchor, t, place);
    emit pointsEdited(points, PathEdit::Insert, true);
    setSelected({PathPart::Kind::Point, static_cast<int>(anchorIndex(d->shape.kind, anchor + 1)), 0});
}

void PathEditor::insertPoint(double length)
{
    if (d->curve.isEmpty())
        return;
    const auto samples = anchorSamples(d->shape.kind, d->shape.points, d->curve.points());
    std::size_t anchor = 0;
    while (anchor + 2 < samples.size() && d->curve.lengthAt(samples[anchor + 1]) <= length)
        ++anchor;
    const QVector3D place = d->curve.at(length);
    const float t =
        d->shape.kind == PathKind::Bezier ? nearestParameter(d->shape.points, anchor, place) : 0.5F;
    insertOnCurve(anchor, t, place);
}

void PathEditor::removeSelected()
{
    deleteSelected();
}

void PathEditor::smoothSelected()
{
    const auto index = static_cast<std::size_t>(d->selected.index);
    if (d->selected.kind == PathPart::Kind::Point && d->shape.kind == PathKind::Bezier)
        emit pointsEdited(smoothedAnchor(d->shape.points, anchorOf(d->shape.kind, index)), PathEdit::Move,
                          true);
}

void PathEditor::insertByKey()
{
    const QVector3D target = d->onGround(camera().target);
    const auto& shape = d->shape;
    const std::vector<QVector3D> points = d->drawnPoints();
    if (d->mode == Mode::Disc) {
        setMode(Mode::Edit);
        emit obstacleAdded({.corners = {target}, .radius = d->ruler().of(usualRadius), .problem = {}});
    } else if (d->mode == Mode::Polygon) {
        QVector3D first = d->ruler().of(usualRadius) * QVector3D(1, 0, 0);
        QVector3D second = d->ruler().of(usualRadius) * QVector3D::crossProduct(d->up(), QVector3D(1, 0, 0));
        setMode(Mode::Edit);
        emit obstacleAdded({.corners = {target + first + second, target - first + second,
                                        target - first - second, target + first - second},
                            .radius = 0,
                            .problem = {}});
    } else if (const auto index = static_cast<std::size_t>(d->selected.index);
               d->selected.kind == PathPart::Kind::Point && index + 1 < points.size()) {
        const auto samples = anchorSamples(shape.kind, shape.points, d->curve.points());
        const std::size_t anchor =
            std::min(anchorOf(shape.kind, index), anchorCount(shape.kind, points.size()) - 2);
        insertPoint((d->curve.lengthAt(samples[anchor]) + d->curve.lengthAt(samples[anchor + 1])) / 2.0);
    } else if (points.empty()) {
        addPoint(shape.inSpace ? target + d->usualHeight * d->up() : target);
    } else {
        QVector3D direction = camera().forward();
        if (points.size() > 1)
            direction = points.back() - points[points.size() - 2];
        direction[d->upIndex()] = 0.0F;
        if (direction.isNull())
            direction = QVector3D(1, 0, 0);
        addPoint(points.back() + d->ruler().of(1.0F) * direction.normalized());
        if (!d->shape.points.empty())
            setSelected({PathPart::Kind::Point, static_cast<int>(d->shape.points.size()) - 1, 0});
    }
}

bool PathEditor::selectNext(int step)
{
    const PathPart next = partAfter(d->parts(), d->selected, step);
    setSelected(next);
    return next.kind != PathPart::Kind::None;
}

bool PathEditor::nudge(int key, Qt::KeyboardModifiers modifiers)
{
    const auto place = d->placeOf(d->selected);
    if (!place)
        return false;
    const auto step = static_cast<float>(modifiers.testFlag(Qt::ShiftModifier)     ? d->ruler().coarse()
                                         : modifiers.testFlag(Qt::ControlModifier) ? d->ruler().fine()
                                                                                   : d->ruler().middle());
    const bool isStart = d->selected.kind == PathPart::Kind::StretchStart;
    const bool isBackwards = key == Qt::Key_Left || key == Qt::Key_Down || key == Qt::Key_PageDown;
    if (isStart || d->selected.kind == PathPart::Kind::StretchEnd) {
        PathStretch stretch = d->shape.stretches[static_cast<std::size_t>(d->selected.index)];
        double& end = isStart ? stretch.from : stretch.to;
        end += static_cast<double>(isBackwards ? -step : step);
        stretch.to = std::max(stretch.to, shortestStretch());
        stretch.from = std::clamp(stretch.from, 0.0, stretch.to - shortestStretch());
        emit stretchEdited(d->selected.index, stretch.from, stretch.to, true);
        return true;
    }
    const bool isLift = key == Qt::Key_PageUp || key == Qt::Key_PageDown;
    const bool isPoint =
        d->selected.kind == PathPart::Kind::Point || d->selected.kind == PathPart::Kind::Lift;
    if (isLift && !(isPoint && d->shape.inSpace))
        return false;
    // The axis that lies nearest to the arrow as the view is turned now.
    const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right;
    const Turntable& view = camera();
    QVector3D wanted = isSideways ? view.right() : QVector3D::crossProduct(d->up(), view.right());
    const int up = d->upIndex();
    const int axis = isLift ? up : std::abs(wanted[0]) >= std::abs(wanted[3 - up]) ? 0 : 3 - up;
    QVector3D shift;
    shift[axis] = isLift || wanted[axis] > 0.0F ? step : -step;
    applyTo(d->selected, *place + (isBackwards ? -shift : shift), true, true);
    return true;
}

bool PathEditor::resizeSelected(float by)
{
    const auto index = static_cast<std::size_t>(d->selected.index);
    const bool isDisc = d->selected.kind == PathPart::Kind::Obstacle && index < d->shape.obstacles.size() &&
                        d->shape.obstacles[index].isDisc();
    if (!isDisc)
        return false;
    PathObstacle obstacle = d->shape.obstacles[index];
    obstacle.radius = std::max(smallestRadius(), obstacle.radius + by);
    emit obstacleEdited(d->selected.index, obstacle, true);
    return true;
}

bool PathEditor::deleteSelected()
{
    const PathPart part = d->selected;
    const auto index = static_cast<std::size_t>(part.index);
    if (!d->placeOf(part))
        return false;
    if (part.kind == PathPart::Kind::Point || part.kind == PathPart::Kind::Lift) {
        const std::size_t anchor = anchorOf(d->shape.kind, index);
        emit pointsEdited(removedAnchor(d->shape.kind, d->shape.points, anchor), PathEdit::Delete, true);
        if (!d->shape.points.empty())
            setSelected({PathPart::Kind::Point,
                         static_cast<int>(anchorIndex(d->shape.kind, anchor > 0 ? anchor - 1 : 0)), 0});
    } else if (part.kind == PathPart::Kind::StretchStart || part.kind == PathPart::Kind::StretchEnd) {
        emit stretchDeletionRequested(part.index);
    } else if (part.kind == PathPart::Kind::ObstacleCorner && d->shape.obstacles[index].corners.size() > 3) {
        PathObstacle obstacle = d->shape.obstacles[index];
        obstacle.corners.erase(obstacle.corners.begin() + part.corner);
        emit obstacleEdited(part.index, obstacle, true);
    } else {
        emit obstacleDeletionRequested(part.index);
    }
    return true;
}

} // namespace quadrille::widgets
