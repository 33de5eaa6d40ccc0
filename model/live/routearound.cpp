// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/live/routearound.h"

#include "model/core/badargument.h"
#include "model/live/keptclear.h"
#include "model/synthesis/walks/pathcourse.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

using Points = std::vector<Vec2d>;

/// The end of a straight line and points before it; not its beginning.
void addLine(const Vec2d& to, double spacing, Points& points)
{
    const Vec2d from = points.back();
    const double length = (to - from).norm();
    const int count = static_cast<int>(std::ceil(length / spacing));
    for (int i = 1; i <= count; ++i)
        points.emplace_back(from + (to - from) * (static_cast<double>(i) / count));
}

double lengthOfWay(const Points& points)
{
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return length;
}

bool areClear(std::span<const KeptClear> kept, const Vec2d& a, const Vec2d& b)
{
    return std::ranges::all_of(kept, [&](const KeptClear& each) { return each.isClear(a, b); });
}

/// The shortest way from the first to the second of the places, without the first; none: empty.
Points shortestWay(const Points& places, std::span<const KeptClear> kept)
{
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const Vec2d& goal = places[1];
    std::vector<double> lengths(places.size(), unknown);
    std::vector<std::size_t> before(places.size(), 0);
    std::vector<bool> isDone(places.size(), false);
    lengths[0] = 0;
    while (true) {
        std::size_t best = places.size();
        double least = unknown;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double length = lengths[i] + (goal - places[i]).norm();
            if (!isDone[i] && length < least) {
                least = length;
                best = i;
            }
        }
        if (best == places.size())
            return {};
        if (best == 1)
            break;
        isDone[best] = true;
        for (std::size_t i = 1; i < places.size(); ++i) {
            const double length = lengths[best] + (places[i] - places[best]).norm();
            if (isDone[i] || length >= lengths[i] || !areClear(kept, places[best], places[i]))
                continue;
            lengths[i] = length;
            before[i] = best;
        }
    }
    Points way;
    for (std::size_t i = 1; i != 0; i = before[i])
        way.push_back(places[i]);
    std::ranges::reverse(way);
    return way;
}

/// Points of a path that are too close to something, with a lead before and behind them.
struct RouteStretch
{
    std::size_t first = 0; ///< points that are kept
    std::size_t last = 0;
    const Obstacle* cause = nullptr;
};

/// Each has half of what is between two at most; where that would be less than half a lead, they are one.
std::vector<RouteStretch> stretchesOf(const Points& path, std::span<const KeptClear> kept, double lead)
{
    std::vector<double> lengths{0};
    for (std::size_t i = 1; i < path.size(); ++i)
        lengths.push_back(lengths.back() + (path[i] - path[i - 1]).norm());
    std::vector<RouteStretch> stretches;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const auto cause = std::ranges::find_if(
            kept, [&](const KeptClear& each) { return !each.isClear(path[i], path[i + 1]); });
        if (cause == kept.end())
            continue;
        if (!stretches.empty() && lengths[i] - lengths[stretches.back().last] < lead)
            stretches.back().last = i + 1;
        else
            stretches.push_back({i, i + 1, cause->obstacle});
    }
    const auto pointAt = [&](double length) {
        const auto at = std::ranges::lower_bound(lengths, length) - lengths.begin();
        return std::min(static_cast<std::size_t>(at), path.size() - 1);
    };
    double free = 0; // where the one before leaves the path free from
    for (std::size_t s = 0; s < stretches.size(); ++s) {
        const double begin = lengths[stretches[s].first];
        const double end = lengths[stretches[s].last];
        stretches[s].first = pointAt(std::max(begin - lead, free));
        free = end + lead;
        if (s + 1 < stretches.size())
            free = std::min(free, (end + lengths[stretches[s + 1].first]) / 2);
        stretches[s].last = pointAt(free);
    }
    return stretches;
}

/// Rounds off, as far as obstacles let it. \param isBent  of points that may move.
void roundOff(Points& route, const std::vector<bool>& isBent, std::span<const KeptClear> kept)
{
    constexpr int rounds = 100;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 1; i + 1 < route.size(); ++i) {
            if (!isBent[i])
                continue;
            const Vec2d middle = (route[i - 1] + route[i + 1]) / 2;
            if (areClear(kept, route[i - 1], middle) && areClear(kept, middle, route[i + 1]))
                route[i] = middle;
        }
    }
}

struct BentRoute
{
    Points points;
    const Obstacle* impassable = nullptr;
};

BentRoute bentAround(const Points& path, std::span<const KeptClear> kept, const RouteSettings& settings)
{
    Points corners;
    for (const KeptClear& each : kept)
        each.addCorners(corners);
    std::erase_if(corners, [&](const Vec2d& corner) {
        return !std::ranges::all_of(kept, [&](const KeptClear& each) { return each.isClear(corner); });
    });
    Points route{path.front()};
    std::vector<bool> isBent{false};
    // The path beside what is bent is in the clear, and may turn into it softly.
    const auto soft = static_cast<std::size_t>(settings.lead / settings.spacing / 3);
    std::size_t next = 1;
    std::size_t bentEnd = 0;
    const auto keepUpTo = [&](std::size_t last) {
        for (; next <= last; ++next) {
            isBent.push_back(bentEnd > 0 && route.size() < bentEnd + soft);
            route.push_back(path[next]);
        }
    };
    for (const RouteStretch& stretch : stretchesOf(path, kept, settings.lead)) {
        keepUpTo(stretch.first);
        Points places{path[stretch.first], path[stretch.last]};
        places.insert(places.end(), corners.begin(), corners.end());
        const Points way = shortestWay(places, kept);
        if (way.empty())
            return {{}, stretch.cause};
        const std::size_t begin = route.size() - std::min(soft, route.size());
        std::fill(isBent.begin() + static_cast<std::ptrdiff_t>(begin), isBent.end(), true);
        for (const Vec2d& corner : way)
            addLine(corner, settings.spacing, route);
        isBent.resize(route.size(), true);
        bentEnd = route.size();
        next = stretch.last + 1;
    }
    keepUpTo(path.size() - 1);
    roundOff(route, isBent, kept);
    return {route, nullptr};
}

[[noreturn]] void refuseObstacle(const Obstacle& obstacle, const std::string& what)
{
    refuse("The obstacle “" + obstacle.name + "” " + what,
           "Move it, or the path, or let it keep less distance.");
}

void checkObstaclesOf(const Points& path, std::span<const Obstacle> obstacles)
{
    for (const Obstacle& obstacle : obstacles) {
        const bool isPolygon = obstacle.outline.size() >= 3 && obstacle.radius == 0;
        const bool isDisc = obstacle.outline.size() == 1 && obstacle.radius >= 0;
        const bool isFinite =
            std::ranges::all_of(obstacle.outline, [](const Vec2d& p) { return p.allFinite(); });
        if (!(isPolygon || isDisc) || !isFinite || !(obstacle.clearance >= 0))
            refuse("The obstacle “" + obstacle.name + "” is neither a disc nor a polygon",
                   "Give it a centre and a radius, or three corners or more.");
        const KeptClear kept(obstacle, obstacle.clearance);
        if (!kept.isClear(path.front()))
            refuseObstacle(obstacle, "stands at the start");
        if (!kept.isClear(path.back()))
            refuseObstacle(obstacle, "stands at the end");
    }
}

} // namespace

std::vector<Vec2d> routeAround(std::span<const Vec2d> path, std::span<const Obstacle> obstacles,
                               const RouteSettings& settings)
{
    if (path.empty() || !std::ranges::all_of(path, [](const Vec2d& point) { return point.allFinite(); }))
        refuse("The path has no points", "Draw it.");
    Points points{path.front()};
    for (const Vec2d& point : path)
        addLine(point, settings.spacing, points);
    checkObstaclesOf(points, obstacles);
    // With less of the margin it goes through what is narrow, where the way is shorter by more than this.
    constexpr double worth = 1; // metres
    const Obstacle* impassable = nullptr;
    Points best;
    for (const double share : {1.0, 0.4, 0.05}) {
        std::vector<KeptClear> kept;
        for (const Obstacle& obstacle : obstacles) {
            const double room =
                std::min(distanceFrom(obstacle, points.front()), distanceFrom(obstacle, points.back()));
            const double margin = std::min(share * settings.margin, 0.9 * (room - obstacle.clearance));
            kept.emplace_back(obstacle, obstacle.clearance + margin);
        }
        BentRoute route = bentAround(points, kept, settings);
        if (route.impassable != nullptr)
            impassable = route.impassable;
        else if (best.empty() || lengthOfWay(route.points) < lengthOfWay(best) - worth)
            best = std::move(route.points);
    }
    if (!best.empty())
        return best;
    refuseObstacle(*impassable, "cannot be passed");
}

} // namespace quadrille
