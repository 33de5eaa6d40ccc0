// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "livefixture.h"
#include "model/live/livepath.h"
#include "model/synthesis/walks/constraints.h"

#include <algorithm>

namespace quadrille::test {

inline Vec3d overGround(double x, double y)
{
    return Ground(UpAxis::Y).at(Vec2d(x, y), 0);
}

inline PathConstraint straightPath(std::vector<Obstacle> obstacles = {})
{
    PathConstraint path;
    path.points = {overGround(0, 0), overGround(10, 0)};
    path.obstacles = std::move(obstacles);
    return path;
}

inline PathConstraint wavyPath(std::uint64_t seed)
{
    Random random(seed);
    std::vector<Vec3d> through{overGround(0, 0)};
    for (int i = 1; i <= 5; ++i)
        through.push_back(overGround(2 * i, random.between(-1, 1)));
    PathConstraint path;
    path.points = sampleCurve(through, 0.05);
    return path;
}

/// \param side  1: to the left; −1: to the right.
inline PathConstraint arcPath(double radius, double angle, double side = 1)
{
    PathConstraint path;
    for (double a = 0; a < angle; a += 0.02)
        path.points.push_back(overGround(radius * std::sin(a), side * radius * (1 - std::cos(a))));
    return path;
}

/// Crosses itself where it is half done.
inline PathConstraint eightPath()
{
    PathConstraint path;
    for (double a = 0; a < 2 * std::numbers::pi; a += 0.02)
        path.points.push_back(overGround(3 * std::sin(a), 2 * std::sin(2 * a)));
    return path;
}

struct Followed
{
    std::vector<LiveInput> inputs;
    std::vector<LiveState> states; ///< the first before any input
    std::vector<Vec2d> centres;
    std::vector<double> deviations;
    double walked = 0;
    bool isDone = false;
    bool hasReachedEnd = false;

    double worst() const { return *std::ranges::max_element(deviations); }
    double most(double share) const
    {
        std::vector<double> sorted = deviations;
        std::ranges::sort(sorted);
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    }
    double nearestTo(const Obstacle& obstacle) const
    {
        double nearest = 1e9;
        for (const Vec2d& centre : centres)
            nearest = std::min(nearest, distanceFrom(obstacle, centre));
        return nearest;
    }
};

inline Followed followed(const std::shared_ptr<const LiveGraph>& graph, const PathConstraint& path,
                         const LivePathSettings& settings = {})
{
    LivePathFollower follower(graph, {}, path, settings);
    LivePlayer player(graph, {}, follower.start());
    Followed result;
    result.states.push_back(player.state());
    constexpr std::size_t most = 6000;
    while (result.inputs.size() < most) {
        const LiveInput input = follower.next(player.state());
        if (follower.isDone())
            break;
        result.centres.push_back(player.root().shift);
        result.deviations.push_back(follower.deviation());
        result.inputs.push_back(input);
        player.tick(input);
        result.states.push_back(player.state());
    }
    result.walked = follower.walked();
    result.isDone = follower.isDone();
    result.hasReachedEnd = follower.hasReachedEnd();
    return result;
}

} // namespace quadrille::test
