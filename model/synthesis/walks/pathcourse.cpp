// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathcourse.h"

#include "model/core/segment.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

double distanceFrom(const Obstacle& obstacle, const Vec2d& point)
{
    const std::vector<Vec2d>& corners = obstacle.outline;
    if (corners.size() < 3)
        return std::max(0.0, (point - corners.front()).norm() - obstacle.radius);
    bool isInside = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2d& a = corners[i];
        const Vec2d& b = corners[j];
        nearest = std::min(nearest, distanceFromSegment(a, b, point));
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            isInside = !isInside;
    }
    return isInside ? 0 : nearest;
}

PathCourse::PathCourse(const PathConstraint& path, UpAxis up, double metresPerUnit)
    : m_ground(up), m_inSpace(path.inSpace), m_metresPerUnit(metresPerUnit), m_obstacles(path.obstacles)
{
    std::vector<Vec3d> points;
    std::vector<double> lengths;
    for (const Vec3d& given : path.points) {
        const Vec3d point = flattened(given);
        const double step = points.empty() ? 0 : (point - points.back()).norm();
        if (!points.empty() && step == 0)
            continue;
        lengths.push_back(points.empty() ? 0 : lengths.back() + step);
        points.push_back(point);
    }
    m_length = lengths.empty() ? 0 : lengths.back();
    m_points = points;
    if (points.size() < 2)
        return;
    m_direction = (points.back() - points[points.size() - 2]).normalized();
    constexpr double finest = 0.01;
    constexpr double mostPoints = 1e6;
    const auto count = static_cast<std::size_t>(std::ceil(std::min(m_length / finest, mostPoints)));
    m_spacing = m_length / static_cast<double>(count);
    m_points.clear();
    std::size_t segment = 1;
    for (std::size_t i = 0; i <= count; ++i) {
        const double s = std::min(m_spacing * static_cast<double>(i), m_length);
        while (segment + 1 < points.size() && lengths[segment] < s)
            ++segment;
        const double t = (s - lengths[segment - 1]) / (lengths[segment] - lengths[segment - 1]);
        m_points.emplace_back(points[segment - 1] +
                              std::min(t, 1.0) * (points[segment] - points[segment - 1]));
    }
}

Vec3d PathCourse::flattened(const Vec3d& point) const
{
    const Vec2d ground = m_ground.of(point);
    return {ground.x(), ground.y(), m_inSpace ? m_ground.heightOf(point) : 0};
}

Vec3d PathCourse::pointOf(const Vec3d& centre) const
{
    return flattened(centre * m_metresPerUnit);
}

Vec3d PathCourse::at(double arcLength) const
{
    const double position = arcLength / m_spacing;
    const auto index = static_cast<std::size_t>(position);
    if (index + 1 >= m_points.size())
        return m_points.back() + (arcLength - m_length) * m_direction;
    return m_points[index] +
           (position - static_cast<double>(index)) * (m_points[index + 1] - m_points[index]);
}

double PathCourse::directionFrom(double arcLength, double ahead) const
{
    const Vec3d way = at(arcLength + ahead) - at(arcLength);
    return std::atan2(way.y(), way.x());
}

int PathCourse::obstacleAt(const Vec2d& point) const
{
    for (std::size_t i = 0; i < m_obstacles.size(); ++i) {
        // Touching is too close without a clearance as well.
        const double distance = distanceFrom(m_obstacles[i], point);
        if (distance <= 0 || distance < m_obstacles[i].clearance)
            return static_cast<int>(i);
    }
    return -1;
}

} // namespace quadrille
