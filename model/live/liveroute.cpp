// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/liveroute.h"

#include "model/core/badargument.h"
#include "model/core/segment.h"
#include "model/synthesis/walks/pathcourse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quadrille {

namespace {

constexpr int pointsOfCircle = 24;
constexpr double lead = 1;     ///< metres before and behind an obstacle in which ways around it begin and end
constexpr double slack = 1e-6; ///< metres, so that what lies about an obstacle does not touch it

bool cross(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d)
{
    const auto side = [](const Vec2d& p, const Vec2d& q, const Vec2d& r) {
        return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
    };
    return (side(a, b, c) > 0) != (side(a, b, d) > 0) && (side(c, d, a) > 0) != (side(c, d, b) > 0);
}

/// How near a straight way comes to an obstacle; 0 where it goes through.
double distanceOfWay(const Obstacle& obstacle, const Vec2d& from, const Vec2d& to)
{
    const std::vector<Vec2d>& corners = obstacle.outline;
    if (corners.size() < 3)
        return std::max(0.0, distanceFromSegment(from, to, corners.front()) - obstacle.radius);
    double nearest = std::min(distanceFrom(obstacle, from), distanceFrom(obstacle, to));
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        if (cross(from, to, corners[j], corners[i]))
            return 0;
        nearest = std::min(nearest, distanceFromSegment(from, to, corners[i]));
    }
    return nearest;
}

class WaysAround
{
public:
    WaysAround(std::span<const Obstacle> obstacles, double margin) : m_obstacles(obstacles), m_margin(margin)
    {
        for (const Obstacle& obstacle : obstacles)
            addPointsAbout(obstacle);
        std::erase_if(m_points, [this](const Vec2d& point) { return nearTo(point) != nullptr; });
    }

    /// The obstacle that a point is too near to; null without one.
    const Obstacle* nearTo(const Vec2d& point) const { return nearTo(point, point); }
    /// The same of a straight way.
    const Obstacle* nearTo(const Vec2d& from, const Vec2d& to) const
    {
        for (const Obstacle& obstacle : m_obstacles) {
            const double distance = distanceOfWay(obstacle, from, to);
            if (distance <= 0 || distance < distanceKept(obstacle))
                return &obstacle;
        }
        return nullptr;
    }
    /// The shortest way from one point to another, without the first; empty where there is none.
    std::vector<Vec2d> between(const Vec2d& from, const Vec2d& to) const;

private:
    double distanceKept(const Obstacle& obstacle) const { return obstacle.clearance + m_margin; }
    /// Points around the disc, or around each corner, so far away that ways between neighbours keep clear.
    void addPointsAbout(const Obstacle& obstacle)
    {
        const double radius =
            (obstacle.radius + distanceKept(obstacle)) / std::cos(std::numbers::pi / pointsOfCircle) + slack;
        for (const Vec2d& centre : obstacle.outline) {
            for (int i = 0; i < pointsOfCircle; ++i) {
                const double angle = 2 * std::numbers::pi * i / pointsOfCircle;
                m_points.push_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
            }
        }
    }

    std::span<const Obstacle> m_obstacles;
    double m_margin;
    std::vector<Vec2d> m_points;
};

std::vector<Vec2d> WaysAround::between(const Vec2d& from, const Vec2d& to) const
{
    // Dijkstra over all points; ways are looked at when they are needed.
    std::vector<Vec2d> points = m_points;
    points.push_back(from);
    points.push_back(to);
    const std::size_t start = points.size() - 2;
    const std::size_t end = points.size() - 1;
    constexpr double unknown = std::numeric_limits<double>::infinity();
    std::vector<double> lengths(points.size(), unknown);
    std::vector<std::size_t> before(points.size(), start);
    std::vector<bool> isDone(points.size(), false);
    lengths[start] = 0;
    while (true) {
        std::size_t nearest = points.size();
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (!isDone[p] && lengths[p] < unknown &&
                (nearest == points.size() || lengths[p] < lengths[nearest]))
                nearest = p;
        }
        if (nearest == points.size())
            return {};
        if (nearest == end)
            break;
        isDone[nearest] = true;
        for (std::size_t p = 0; p < points.size(); ++p) {
            const double length = lengths[nearest] + (points[p] - points[nearest]).norm();
            if (isDone[p] || length >= lengths[p] || nearTo(points[nearest], points[p]) != nullptr)
                continue;
            lengths[p] = length;
            before[p] = nearest;
        }
    }
    std::vector<Vec2d> way;
    for (std::size_t p = end; p != start; p = before[p])
        way.push_back(points[p]);
    std::ranges::reverse(way);
    return way;
}

/// Takes the last points of a route away that lie within the lead.
void goBack(std::vector<Vec2d>& route)
{
    double length = 0;
    while (route.size() > 1) {
        length += (route.back() - route[route.size() - 2]).norm();
        if (length > lead)
            return;
        route.pop_back();
    }
}

[[noreturn]] void refuseObstacle(const Obstacle& obstacle, const std::string& what)
{
    refuse("The obstacle “" + obstacle.name + "” " + what,
           "Move it, or the path, or let it keep less distance.");
}

} // namespace

std::vector<Vec2d> routeAround(std::span<const Vec2d> path, std::span<const Obstacle> obstacles,
                               double margin)
{
    const WaysAround ways(obstacles, margin);
    if (const Obstacle* there = ways.nearTo(path.front()))
        refuseObstacle(*there, "stands at the start");
    if (const Obstacle* there = ways.nearTo(path.back()))
        refuseObstacle(*there, "stands at the end");
    std::vector<Vec2d> route{path.front()};
    const Obstacle* passed = nullptr;
    double beyond = 0; // how far behind it, metres
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec2d& point = path[i];
        if (passed == nullptr) {
            passed = ways.nearTo(route.back(), point);
            if (passed == nullptr) {
                route.push_back(point);
                continue;
            }
            goBack(route);
            beyond = 0;
        }
        if (const Obstacle* there = ways.nearTo(point)) {
            passed = there;
            beyond = 0;
            continue;
        }
        beyond += (point - path[i - 1]).norm();
        if (beyond < lead && i + 1 < path.size())
            continue;
        const std::vector<Vec2d> way = ways.between(route.back(), point);
        if (way.empty())
            refuseObstacle(*passed, "cannot be passed");
        route.insert(route.end(), way.begin(), way.end());
        passed = nullptr;
    }
    return route;
}

} // namespace quadrille
