// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/pathlayout.h"

#include "widgets/tools/pixeldistances.h"

#include <cmath>
#include <limits>

namespace quadrille::widgets {

using Part = PathPart::Kind;

PathPart PathPart::owner() const
{
    return kind == Part::Lift             ? PathPart{Part::Point, index, 0}
           : kind == Part::ObstacleRadius ? PathPart{Part::Obstacle, index, 0}
                                          : *this;
}

Qt::CursorShape cursorFor(const PathPart& part)
{
    switch (part.kind) {
    case Part::Point:
    case Part::Obstacle:
    case Part::ObstacleCorner:
        return Qt::SizeAllCursor;
    case Part::Lift:
        return Qt::SizeVerCursor;
    case Part::StretchStart:
    case Part::StretchEnd:
    case Part::ObstacleRadius:
        return Qt::SizeHorCursor;
    case Part::Curve:
        return Qt::PointingHandCursor;
    case Part::None:
        break;
    }
    return Qt::ArrowCursor;
}

QVector3D middleOf(const PathObstacle& obstacle)
{
    QVector3D sum;
    for (const QVector3D& corner : obstacle.corners)
        sum += corner;
    return sum / static_cast<float>(obstacle.corners.size());
}

std::vector<PathPart> PathLayout::parts() const
{
    std::vector<PathPart> all;
    all.reserve(shape().points.size() + 2 * shape().stretches.size() + shape().obstacles.size());
    for (int i = 0; i < static_cast<int>(shape().points.size()); ++i)
        all.push_back({Part::Point, i, 0});
    if (shape().inSpace && selected().kind == Part::Point)
        all.push_back({Part::Lift, selected().index, 0});
    for (int i = 0; i < static_cast<int>(shape().stretches.size()); ++i) {
        all.push_back({Part::StretchStart, i, 0});
        all.push_back({Part::StretchEnd, i, 0});
    }
    for (int i = 0; i < static_cast<int>(shape().obstacles.size()); ++i) {
        all.push_back({Part::Obstacle, i, 0});
        const PathObstacle& obstacle = shape().obstacles[static_cast<std::size_t>(i)];
        for (int corner = 0; !obstacle.isDisc() && corner < static_cast<int>(obstacle.corners.size());
             ++corner)
            all.push_back({Part::ObstacleCorner, i, corner});
    }
    return all;
}

std::optional<QVector3D> PathLayout::placeOf(const PathPart& part) const
{
    switch (part.kind) {
    case Part::Point:
    case Part::Lift:
        return part.at() < shape().points.size() ? std::optional(shape().points[part.at()]) : std::nullopt;
    case Part::StretchStart:
    case Part::StretchEnd: {
        if (part.at() >= shape().stretches.size() || curve().isEmpty())
            return std::nullopt;
        const PathStretch& stretch = shape().stretches[part.at()];
        return curve().at(part.kind == Part::StretchStart ? stretch.from : stretch.to);
    }
    case Part::Obstacle:
    case Part::ObstacleRadius:
    case Part::ObstacleCorner:
        return placeOnObstacle(part);
    case Part::Curve:
    case Part::None:
        break;
    }
    return std::nullopt;
}

std::optional<QVector3D> PathLayout::placeOnObstacle(const PathPart& part) const
{
    if (part.at() >= shape().obstacles.size())
        return std::nullopt;
    const PathObstacle& obstacle = shape().obstacles[part.at()];
    if (part.kind == Part::ObstacleRadius)
        return obstacle.corners.front() + obstacle.radius * m_view.camera.right();
    if (part.kind == Part::Obstacle)
        return middleOf(obstacle);
    const auto corner = static_cast<std::size_t>(part.corner);
    return corner < obstacle.corners.size() ? std::optional(obstacle.corners[corner]) : std::nullopt;
}

std::optional<QPointF> PathLayout::pixelOf(const PathPart& part) const
{
    constexpr double besidePoint = 26.0;
    const auto place = placeOf(part);
    auto pixel = place ? m_view.project(*place) : std::nullopt;
    if (pixel && part.kind == Part::Lift)
        *pixel += QPointF(besidePoint, 0.0);
    return pixel;
}

PathPart PathLayout::partAt(const QPointF& position) const
{
    constexpr double pointReach = 12.0;
    constexpr double edgeReach = 8.0;
    PathPart found;
    double nearest = pointReach;
    for (const PathPart& part : parts()) {
        const auto pixel = pixelOf(part);
        if (!pixel)
            continue;
        // What is selected lies on top of the others, and points lie on top of ends of stretches.
        const double advantage = part == selected() ? 4.0 : part.kind == Part::Point ? 2.0 : 0.0;
        const double distance = distanceBetween(*pixel, position);
        if (distance < pointReach && distance - advantage < nearest) {
            nearest = distance - advantage;
            found = part;
        }
    }
    if (found.kind != Part::None)
        return found;
    if (const auto place = m_view.placeAt(position, m_view.ground))
        for (std::size_t i = 0; i < shape().obstacles.size(); ++i) {
            const PathObstacle& obstacle = shape().obstacles[i];
            if (obstacle.isDisc() && std::abs((*place - obstacle.corners[0]).length() - obstacle.radius) <
                                         static_cast<float>(edgeReach) * m_view.unitsPerPixel(*place))
                return {Part::ObstacleRadius, static_cast<int>(i), 0};
        }
    double distance = 0.0;
    if (lengthAt(position, &distance) && distance < edgeReach)
        return {Part::Curve, 0, 0};
    return {};
}

std::optional<double> PathLayout::lengthAt(const QPointF& pixel, double* distance) const
{
    std::optional<double> length;
    double nearest = std::numeric_limits<double>::max();
    const auto& points = curve().points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto a = m_view.project(points[i]);
        const auto b = m_view.project(points[i + 1]);
        double t = 0.0;
        if (!a || !b)
            continue;
        const double found = distanceToSegment(pixel, *a, *b, &t);
        if (found < nearest) {
            nearest = found;
            length = curve().lengthAt(i) + t * (curve().lengthAt(i + 1) - curve().lengthAt(i));
        }
    }
    if (distance != nullptr)
        *distance = nearest;
    return length;
}

} // namespace quadrille::widgets
