// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/keptclear.h"

#include "model/core/segment.h"
#include "model/synthesis/walks/pathcourse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

double crossed(const Vec2d& a, const Vec2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool doCross(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d)
{
    const auto isLeft = [](const Vec2d& from, const Vec2d& to, const Vec2d& point) {
        return crossed(to - from, point - from) > 0;
    };
    return isLeft(a, b, c) != isLeft(a, b, d) && isLeft(c, d, a) != isLeft(c, d, b);
}

/// Points whose polygon is outside of an arc about a corner, from one direction counter-clockwise on.
void addArc(const Vec2d& corner, double radius, double from, double angle, std::vector<Vec2d>& points)
{
    constexpr double finest = std::numbers::pi / 12;
    const int count = std::max(1, static_cast<int>(std::ceil(angle / finest - 1e-9)));
    const double each = angle / count;
    // Rounding shall not bring the lines between them too close.
    const double distance = (radius + 1e-6) / std::cos(each / 2);
    for (int i = 0; i < count; ++i) {
        const double direction = from + (i + 0.5) * each;
        points.emplace_back(corner + distance * Vec2d(std::cos(direction), std::sin(direction)));
    }
}

} // namespace

KeptClear::KeptClear(const Obstacle& kept, double distance) : obstacle(&kept), keep(distance)
{
    for (const Vec2d& corner : kept.outline)
        centre += corner / static_cast<double>(kept.outline.size());
    radius = kept.radius;
    for (const Vec2d& corner : kept.outline)
        radius = std::max(radius, (corner - centre).norm());
}

bool KeptClear::isClear(const Vec2d& point) const
{
    if ((point - centre).norm() > radius + keep)
        return true;
    const double distance = distanceFrom(*obstacle, point);
    return distance > 0 && distance >= keep;
}

bool KeptClear::isClear(const Vec2d& a, const Vec2d& b) const
{
    const double away = distanceFromSegment(a, b, centre);
    if (away > radius + keep)
        return true;
    const std::vector<Vec2d>& corners = obstacle->outline;
    if (corners.size() < 3)
        return away > radius && away >= radius + keep;
    if (!isClear(a) || !isClear(b))
        return false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        if (distanceFromSegment(a, b, corners[i]) < keep || doCross(a, b, corners[j], corners[i]))
            return false;
    }
    return true;
}

void KeptClear::addCorners(std::vector<Vec2d>& corners) const
{
    const std::vector<Vec2d>& given = obstacle->outline;
    if (given.size() < 3) {
        addArc(centre, radius + keep, 0, 2 * std::numbers::pi, corners);
        return;
    }
    std::vector<Vec2d> outline;
    double area = 0;
    for (std::size_t i = 0, j = given.size() - 1; i < given.size(); j = i++) {
        area += crossed(given[j], given[i]);
        if (given[i] != given[j])
            outline.push_back(given[i]);
    }
    if (area < 0)
        std::reverse(outline.begin(), outline.end());
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2d in = outline[i] - outline[(i + count - 1) % count];
        const Vec2d out = outline[(i + 1) % count] - outline[i];
        const double angle = std::atan2(crossed(in, out), in.dot(out));
        if (angle > 0) // nothing bends around a corner that points inwards
            addArc(outline[i], keep, std::atan2(-in.x(), in.y()), angle, corners);
    }
}

} // namespace quadrille
