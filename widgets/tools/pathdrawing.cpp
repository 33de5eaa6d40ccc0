// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathdrawing.h"

#include "widgets/tools/handletool.h"

#include <algorithm>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr float usualRadius = 0.4F; // metres

} // namespace

void PathDrawing::setMode(PathMode mode)
{
    m_mode = mode;
    m_firstPoint.reset();
    m_corners.clear();
    m_pointer.reset();
}

std::vector<QVector3D> PathDrawing::drawnPoints(const PathShape& shape) const
{
    return shape.points.empty() && m_firstPoint ? std::vector<QVector3D>{*m_firstPoint} : shape.points;
}

std::optional<QVector3D> PathDrawing::newPlace(const PathLayout& layout, const QPointF& pixel,
                                               Qt::KeyboardModifiers modifiers) const
{
    const GroundView& view = layout.view();
    const std::vector<QVector3D> points = drawnPoints(layout.shape());
    const bool lifts = m_mode == PathMode::Draw && layout.shape().inSpace;
    const float height = !lifts           ? view.ground
                         : points.empty() ? view.ground + m_usualHeight
                                          : points.back()[view.upIndex()];
    const auto place = view.placeAt(pixel, height);
    if (!place)
        return std::nullopt;
    const bool isPolygon = m_mode == PathMode::Polygon && !m_corners.empty();
    const bool hasLast = isPolygon || (m_mode == PathMode::Draw && !points.empty());
    const QVector3D last = isPolygon ? m_corners.back() : hasLast ? points.back() : *place;
    if (!hasLast)
        modifiers.setFlag(Qt::ShiftModifier, false);
    return view.constrained(last, *place, modifiers);
}

void PathDrawing::hover(const PathLayout& layout, const QPointF& pixel, Qt::KeyboardModifiers modifiers)
{
    m_pointer = newPlace(layout, pixel, modifiers);
}

bool PathDrawing::press(const PathLayout& layout, const QPointF& pixel, Qt::KeyboardModifiers modifiers)
{
    const auto place = newPlace(layout, pixel, modifiers);
    if (!place)
        return false;
    m_pointer = place;
    if (m_mode == PathMode::Polygon) {
        constexpr double closeEnough = 12.0; // pixels
        const auto first = m_corners.empty() ? std::nullopt : layout.view().project(m_corners.front());
        if (first && m_corners.size() > 2 && (*first - pixel).manhattanLength() < closeEnough)
            return true;
        m_corners.push_back(*place);
        return false;
    }
    m_gesture = m_mode == PathMode::Disc                  ? Gesture::Radius
                : layout.shape().kind == PathKind::Bezier ? Gesture::Pull
                                                          : Gesture::Stroke;
    m_moved = false;
    m_pressedAt = pixel;
    m_start = *place;
    m_stroke = {*place};
    return false;
}

void PathDrawing::move(const PathLayout& layout, const QPointF& pixel)
{
    m_moved = m_moved || HandleTool::isDrag(m_pressedAt, pixel);
    if (!m_moved)
        return;
    if (const auto place = layout.view().placeAt(pixel, m_start[layout.view().upIndex()])) {
        m_pointer = place;
        m_stroke.push_back(*place);
    }
}

PathDrawing::Outcome PathDrawing::release(const PathLayout& layout, bool commit)
{
    const std::vector<QVector3D> pulled = preview(layout.shape());
    const Gesture gesture = std::exchange(m_gesture, Gesture::None);
    if (!commit)
        return {};
    if (gesture == Gesture::Radius && m_mode != PathMode::Disc) // which was left meanwhile
        return {};
    if (gesture == Gesture::Radius)
        return {.points = {}, .obstacle = disc(layout.view().ruler), .isDone = true};
    if (!m_moved)
        return finishPoint(layout);
    if (gesture == Gesture::Pull)
        return pulled.size() > 1 ? Outcome{.points = pulled, .obstacle = {}} : added(layout, m_start);
    if (m_stroke.size() < 2)
        return {};
    constexpr float roughness = 6.0F; // pixels
    std::vector<QVector3D> points = drawnPoints(layout.shape());
    for (const QVector3D& point :
         simplifiedStroke(m_stroke, roughness * layout.view().unitsPerPixel(m_start)))
        points.push_back(point);
    return {.points = points, .edit = PathEdit::Draw, .obstacle = {}};
}

PathDrawing::Outcome PathDrawing::finishPoint(const PathLayout& layout)
{
    const PathShape& shape = layout.shape();
    const bool closes = layout.partAt(m_pressedAt) == PathPart{PathPart::Kind::Point, 0, 0} &&
                        anchorCount(shape.kind, shape.points.size()) > 2;
    Outcome outcome = added(layout, closes ? shape.points.front() : m_start);
    outcome.isDone = closes;
    return outcome;
}

PathObstacle PathDrawing::disc(const Ruler& ruler) const
{
    constexpr float smallest = 0.05F; // metres
    const float radius = m_pointer ? (*m_pointer - m_start).length() : 0.0F;
    return {.corners = {m_start},
            .radius = m_moved ? std::max(ruler.of(smallest), radius) : ruler.of(usualRadius),
            .problem = {}};
}

std::optional<PathObstacle> PathDrawing::polygon() const
{
    if (m_mode != PathMode::Polygon || m_corners.size() < 3)
        return std::nullopt;
    return PathObstacle{.corners = m_corners, .problem = {}};
}

PathDrawing::Outcome PathDrawing::added(const PathLayout& layout, const QVector3D& place)
{
    constexpr float same = 1e-4F; // metres
    const std::vector<QVector3D> points = drawnPoints(layout.shape());
    if (points.empty())
        m_firstPoint = place;
    else if ((points.back() - place).length() > layout.view().ruler.of(same))
        return {.points = appendedPoint(layout.shape().kind, points, place), .obstacle = {}};
    return {};
}

std::vector<QVector3D> PathDrawing::preview(const PathShape& shape) const
{
    std::vector<QVector3D> points = drawnPoints(shape);
    if (m_gesture == Gesture::Pull) {
        points = appendedPoint(shape.kind, points, m_start);
        if (m_pointer && points.size() > 1)
            points[points.size() - 2] = 2.0F * m_start - *m_pointer;
        return points;
    }
    if (m_mode != PathMode::Draw || !m_pointer || points.empty() ||
        (points.back() - *m_pointer).length() < 1e-4F)
        return {};
    return appendedPoint(shape.kind, points, *m_pointer);
}

PathObstacle usualObstacle(PathMode mode, const QVector3D& middle, const GroundView& view)
{
    const float radius = view.ruler.of(usualRadius);
    if (mode != PathMode::Polygon)
        return {.corners = {middle}, .radius = radius, .problem = {}};
    const QVector3D first = radius * QVector3D(1, 0, 0);
    const QVector3D second = radius * QVector3D::crossProduct(view.up(), QVector3D(1, 0, 0));
    return {.corners = {middle + first + second, middle - first + second, middle - first - second,
                        middle + first - second},
            .problem = {}};
}

} // namespace quadrille::widgets
