// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/patheditor.h"

#include "widgets/theme/theme.h"
#include "widgets/viewport/patheditorprivate.h"
#include "widgets/viewport/pixeldistances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double pointReach = 12.0; // pixels
constexpr double edgeReach = 8.0;
constexpr double liftDistance = 26.0; // pixels beside its point

} // namespace

PathEditor::PathEditor(Viewport& viewport, QObject* parent)
    : HandleTool(parent), d(std::make_unique<Private>(*this, viewport))
{
    d->sampler = [](PathKind, const std::vector<QVector3D>& points) { return points; };
    connect(&Theme::instance(), &Theme::changed, this, &PathEditor::refreshMarks);
}

PathEditor::~PathEditor() = default;

void PathEditor::setSampler(PathSampler sampler)
{
    d->sampler = std::move(sampler);
}

void PathEditor::setShape(const PathShape& shape)
{
    const PathShape& dragged = d->drag.before;
    const bool isOther = shape.points.size() != dragged.points.size() ||
                         shape.stretches.size() != dragged.stretches.size() ||
                         shape.obstacles.size() != dragged.obstacles.size();
    if (d->drag.kind == PathDrag::Kind::Part && isOther) // undone under the pointer
        d->drag = {};
    d->shape = shape;
    d->curve =
        SampledCurve(shape.points.empty() ? std::vector<QVector3D>() : d->sampler(shape.kind, shape.points));
    if (!shape.points.empty())
        d->firstPoint.reset();
    if (!d->placeOf(d->selected))
        setSelected({});
    d->hovered = {};
    refreshMarks();
}

const PathShape& PathEditor::shape() const
{
    return d->shape;
}

const SampledCurve& PathEditor::curve() const
{
    return d->curve;
}

void PathEditor::setActive(bool active)
{
    if (active == d->active)
        return;
    if (!active) {
        d->drag = {};
        setMode(Mode::Edit);
        setSelected({});
    }
    d->active = active;
    refreshMarks();
}

bool PathEditor::isActive() const
{
    return d->active;
}

void PathEditor::setMode(Mode mode)
{
    if (mode == d->mode)
        return;
    d->mode = mode;
    d->firstPoint.reset();
    d->corners.clear();
    d->pointer.reset();
    d->hovered = {};
    if (mode != Mode::Edit)
        setSelected({});
    emit cursorRequested(Private::cursorFor({}, mode));
    emit modeChanged(mode);
    emit repaintRequested();
}

PathEditor::Mode PathEditor::mode() const
{
    return d->mode;
}

void PathEditor::setSelected(const PathPart& part)
{
    if (part == d->selected)
        return;
    d->selected = part;
    emit selectionChanged(part);
    emit repaintRequested();
}

const PathPart& PathEditor::selected() const
{
    return d->selected;
}

void PathEditor::setUsualHeight(float height)
{
    d->usualHeight = height;
}

bool PathEditor::isDragging() const
{
    return d->drag.kind != PathDrag::Kind::None;
}

std::optional<QPointF> PathEditor::pixelOf(const PathPart& part) const
{
    const auto place = d->placeOf(part);
    auto pixel = place ? d->project(*place) : std::nullopt;
    if (pixel && part.kind == PathPart::Kind::Lift)
        *pixel += QPointF(liftDistance, 0.0);
    return pixel;
}

PathPart PathEditor::partAt(const QPointF& position) const
{
    PathPart found;
    double nearest = pointReach;
    for (const PathPart& part : d->parts()) {
        const auto pixel = pixelOf(part);
        if (!pixel)
            continue;
        // What is selected lies on top of the others, and points lie on top of ends of stretches.
        const double advantage = part == d->selected ? 4.0 : part.kind == PathPart::Kind::Point ? 2.0 : 0.0;
        const double distance = distanceBetween(*pixel, position);
        if (distance < pointReach && distance - advantage < nearest) {
            nearest = distance - advantage;
            found = part;
        }
    }
    if (found.kind != PathPart::Kind::None)
        return found;
    for (std::size_t i = 0; i < d->shape.obstacles.size(); ++i) {
        const PathObstacle& obstacle = d->shape.obstacles[i];
        if (!obstacle.isDisc())
            continue;
        const auto place = d->placeAt(position, d->viewport.groundHeight());
        if (place && std::abs((*place - obstacle.corners[0]).length() - obstacle.radius) <
                         static_cast<float>(edgeReach) * d->unitsPerPixel(*place))
            return {PathPart::Kind::ObstacleRadius, static_cast<int>(i), 0};
    }
    double distance = 0.0;
    if (d->lengthAt(position, &distance) && distance < edgeReach)
        return {PathPart::Kind::Curve, 0, 0};
    return {};
}

void PathEditor::viewChanged()
{
    d->pointer.reset();
}

QVector3D PathEditor::Private::up() const
{
    return upIndex() == 1 ? QVector3D(0, 1, 0) : QVector3D(0, 0, 1);
}

int PathEditor::Private::upIndex() const
{
    return owner.camera().upAxis == UpAxis::Y ? 1 : 2;
}

std::optional<QPointF> PathEditor::Private::project(const QVector3D& point) const
{
    QPointF pixel;
    if (!owner.camera().project(point, owner.viewSize(), &pixel))
        return std::nullopt;
    return pixel;
}

QVector3D PathEditor::Private::onGround(QVector3D point) const
{
    point[upIndex()] = viewport.groundHeight();
    return point;
}

std::optional<QVector3D> PathEditor::Private::placeAt(const QPointF& pixel, float height) const
{
    const Ray ray = owner.camera().rayThrough(pixel, owner.viewSize());
    const int up = upIndex();
    constexpr float farthest = 500.0F; // metres; beyond is the horizon
    const float distance = (height - ray.origin[up]) / ray.direction[up];
    if (!(distance > 0.0F) || distance > ruler().of(farthest))
        return std::nullopt;
    QVector3D place = ray.origin + distance * ray.direction;
    place[up] = height;
    return place;
}

float PathEditor::Private::heightAt(const QPointF& pixel, const QVector3D& foot) const
{
    const Ray ray = owner.camera().rayThrough(pixel, owner.viewSize());
    QVector3D normal = owner.camera().forward();
    normal[upIndex()] = 0.0F;
    const float facing = QVector3D::dotProduct(ray.direction, normal);
    if (std::abs(facing) < 0.02F) // seen from above
        return -static_cast<float>(pixel.y()) * unitsPerPixel(foot);
    const float distance = QVector3D::dotProduct(foot - ray.origin, normal) / facing;
    return (ray.origin + distance * ray.direction)[upIndex()];
}

float PathEditor::Private::unitsPerPixel(const QVector3D& near) const
{
    const Turntable& camera = owner.camera();
    const float depth = QVector3D::dotProduct(near - camera.position(), camera.forward());
    return camera.metresPerPixel(owner.viewSize()) * std::max(depth, 0.01F) / camera.distance;
}

QVector3D PathEditor::Private::constrained(const QVector3D& from, QVector3D place,
                                           Qt::KeyboardModifiers modifiers) const
{
    const int up = upIndex();
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        const int second = 3 - up;
        const QVector3D shift = place - from;
        const int kept = std::abs(shift[0]) >= std::abs(shift[second]) ? second : 0;
        place[kept] = from[kept];
    }
    if (modifiers.testFlag(Qt::ControlModifier)) {
        constexpr float tenPixels = 10.0F;
        const auto middle = static_cast<float>(ruler().middle());
        const float step =
            unitsPerPixel(place) * tenPixels < middle ? middle : static_cast<float>(ruler().coarse());
        for (int axis = 0; axis < 3; ++axis)
            if (axis != up && (place[axis] != from[axis] || !modifiers.testFlag(Qt::ShiftModifier)))
                place[axis] = std::round(place[axis] / step) * step;
    }
    return place;
}

std::vector<QVector3D> PathEditor::Private::drawnPoints() const
{
    return shape.points.empty() && firstPoint ? std::vector<QVector3D>{*firstPoint} : shape.points;
}

std::optional<QVector3D> PathEditor::Private::newPlace(const QPointF& pixel,
                                                       Qt::KeyboardModifiers modifiers) const
{
    const std::vector<QVector3D> points = drawnPoints();
    const bool lifts = mode == Mode::Draw && shape.inSpace;
    const float ground = viewport.groundHeight();
    const float height = !lifts ? ground : points.empty() ? ground + usualHeight : points.back()[upIndex()];
    const auto place = placeAt(pixel, height);
    if (!place)
        return std::nullopt;
    const bool isPolygon = mode == Mode::Polygon && !corners.empty();
    const bool hasLast = isPolygon || (mode == Mode::Draw && !points.empty());
    const QVector3D last = isPolygon ? corners.back() : hasLast ? points.back() : *place;
    if (!hasLast)
        modifiers.setFlag(Qt::ShiftModifier, false);
    return constrained(last, *place, modifiers);
}

std::optional<QVector3D> PathEditor::Private::placeOf(const PathPart& part) const
{
    const auto index = static_cast<std::size_t>(part.index);
    switch (part.kind) {
    case PathPart::Kind::Point:
    case PathPart::Kind::Lift:
        return index < shape.points.size() ? std::optional(shape.points[index]) : std::nullopt;
    case PathPart::Kind::StretchStart:
    case PathPart::Kind::StretchEnd:
        if (index >= shape.stretches.size() || curve.isEmpty())
            return std::nullopt;
        return curve.at(part.kind == PathPart::Kind::StretchStart ? shape.stretches[index].from
                                                                  : shape.stretches[index].to);
    case PathPart::Kind::Obstacle:
    case PathPart::Kind::ObstacleRadius:
    case PathPart::Kind::ObstacleCorner: {
        if (index >= shape.obstacles.size())
            return std::nullopt;
        const PathObstacle& obstacle = shape.obstacles[index];
        if (part.kind == PathPart::Kind::ObstacleCorner)
            return static_cast<std::size_t>(part.corner) < obstacle.corners.size()
                       ? std::optional(obstacle.corners[static_cast<std::size_t>(part.corner)])
                       : std::nullopt;
        if (part.kind == PathPart::Kind::ObstacleRadius)
            return obstacle.corners.front() + obstacle.radius * owner.camera().right();
        QVector3D sum;
        for (const QVector3D& corner : obstacle.corners)
            sum += corner;
        return sum / static_cast<float>(obstacle.corners.size());
    }
    case PathPart::Kind::Curve:
    case PathPart::Kind::None:
        break;
    }
    return std::nullopt;
}

std::optional<double> PathEditor::Private::lengthAt(const QPointF& pixel, double* distance) const
{
    std::optional<double> length;
    *distance = std::numeric_limits<double>::max();
    const auto& points = curve.points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto a = project(points[i]);
        const auto b = project(points[i + 1]);
        double t = 0.0;
        if (!a || !b)
            continue;
        const double found = distanceToSegment(pixel, *a, *b, &t);
        if (found < *distance) {
            *distance = found;
            length = curve.lengthAt(i) + t * (curve.lengthAt(i + 1) - curve.lengthAt(i));
        }
    }
    return length;
}

std::vector<PathPart> PathEditor::Private::parts() const
{
    using Kind = PathPart::Kind;
    std::vector<PathPart> all;
    all.reserve(shape.points.size() + 2 * shape.stretches.size() + shape.obstacles.size());
    for (int i = 0; i < static_cast<int>(shape.points.size()); ++i)
        all.push_back({Kind::Point, i, 0});
    if (shape.inSpace && selected.kind == Kind::Point)
        all.push_back({Kind::Lift, selected.index, 0});
    for (int i = 0; i < static_cast<int>(shape.stretches.size()); ++i) {
        all.push_back({Kind::StretchStart, i, 0});
        all.push_back({Kind::StretchEnd, i, 0});
    }
    for (int i = 0; i < static_cast<int>(shape.obstacles.size()); ++i) {
        all.push_back({Kind::Obstacle, i, 0});
        const PathObstacle& obstacle = shape.obstacles[static_cast<std::size_t>(i)];
        for (int corner = 0; !obstacle.isDisc() && corner < static_cast<int>(obstacle.corners.size());
             ++corner)
            all.push_back({Kind::ObstacleCorner, i, corner});
    }
    return all;
}

std::vector<QVector3D> PathEditor::Private::preview() const
{
    if (drag.kind == PathDrag::Kind::Pull) {
        std::vector<QVector3D> points = appendedPoint(shape.kind, drawnPoints(), drag.start);
        if (pointer && points.size() > 1)
            points[points.size() - 2] = 2.0F * drag.start - *pointer;
        return points;
    }
    const std::vector<QVector3D> points = drawnPoints();
    if (mode != Mode::Draw || !pointer || points.empty() || (points.back() - *pointer).length() < 1e-4F)
        return {};
    return appendedPoint(shape.kind, points, *pointer);
}

} // namespace quadrille::widgets
