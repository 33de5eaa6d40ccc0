// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "livefixture.h"
#include "model/core/error.h"
#include "model/live/livepath.h"
#include "model/live/liveroute.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace quadrille {
namespace {

using ::testing::HasSubstr;

PathConstraint pathOver(const std::vector<Vec2d>& points)
{
    const Ground ground(UpAxis::Y);
    PathConstraint path;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        for (int part = 0; part < 50; ++part)
            path.points.push_back(ground.at(points[i] + part / 50.0 * (points[i + 1] - points[i]), 0));
    }
    path.points.push_back(ground.at(points.back(), 0));
    return path;
}

PathConstraint circle(double radius, double turns)
{
    std::vector<Vec2d> points;
    for (int i = 0; i <= 100; ++i) {
        const double angle = turns * 2 * std::numbers::pi * i / 100;
        points.emplace_back(std::abs(radius) * std::sin(angle), radius * (1 - std::cos(angle)));
    }
    return pathOver(points);
}

Obstacle disc(const Vec2d& centre, double radius, const std::string& name = "cone")
{
    return {.name = name, .outline = {centre}, .radius = radius, .clearance = 0.2};
}

struct Followed
{
    std::vector<Vec2d> points; ///< of each tick
    std::vector<LiveInput> inputs;
    std::vector<double> deviations;
    bool hasReachedEnd = false;
    LiveState last;
};

/// Walks that turn, with what straight walks are made of.
std::shared_ptr<const LiveGraph> turningGraph()
{
    std::vector<std::shared_ptr<const MotionSpace>> spaces;
    for (const test::SwingingSpace& made :
         {test::SwingingSpace{.name = "walk"},
          test::SwingingSpace{
              .name = "turn", .frames = 24, .measure = SpaceMeasure::Turning, .least = -80, .greatest = 80}})
        spaces.push_back(std::make_shared<const MotionSpace>(test::makeSpace(made)));
    return std::make_shared<const LiveGraph>(makeLiveGraph(std::move(spaces), test::swingingFps));
}

Followed follow(const std::shared_ptr<const LiveGraph>& graph, const PathConstraint& path)
{
    LivePathFollower follower(graph, {}, path);
    LivePlayer player(graph, {}, follower.start());
    Followed made;
    for (int tick = 0; tick < 6000 && !follower.isDone(); ++tick) {
        made.inputs.push_back(follower.next(player.state()));
        player.tick(made.inputs.back());
        made.points.push_back(player.root().shift);
        made.deviations.push_back(follower.deviation());
    }
    made.hasReachedEnd = follower.hasReachedEnd();
    made.last = player.state();
    return made;
}

double worst(const std::vector<double>& values)
{
    return *std::ranges::max_element(values);
}

std::string problemOf(const PathConstraint& path)
{
    try {
        const LivePathFollower follower(turningGraph(), {}, path);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

} // namespace

TEST(LiveRoute, IsThePathWhereNothingStands)
{
    const std::vector<Vec2d> path{{0, 0}, {1, 0}, {2, 1}};
    EXPECT_EQ(routeAround(path, {}, 0.1), path);
    const std::vector<Obstacle> far{disc({0, 5}, 1)};
    EXPECT_EQ(routeAround(path, far, 0.1), path);
}

TEST(LiveRoute, GoesAroundTheShorterWay)
{
    const std::vector<Vec2d> path{{0, 0}, {10, 0}};
    const std::vector<Obstacle> cone{disc({5, 0.3}, 0.5)};
    const std::vector<Vec2d> route = routeAround(path, cone, 0.1);
    ASSERT_GT(route.size(), 2U);
    double length = 0;
    for (std::size_t i = 1; i < route.size(); ++i) {
        length += (route[i] - route[i - 1]).norm();
        EXPECT_LE(route[i].y(), 1e-9); // below the disc
        for (int part = 0; part <= 20; ++part) {
            const Vec2d point = route[i - 1] + part / 20.0 * (route[i] - route[i - 1]);
            EXPECT_GE(distanceFrom(cone[0], point), 0.3 - 1e-9);
        }
    }
    // Tangents to a disc of radius .8 whose centre lies .3 beside the line, 5 m before both ends.
    const double reach = std::hypot(5, 0.3);
    const double tangent = std::sqrt(reach * reach - 0.64);
    const double angle = std::numbers::pi - 2 * std::acos(0.8 / reach) - 2 * std::atan(0.3 / 5);
    EXPECT_NEAR(length, 2 * tangent + 0.8 * angle, 0.01);
    EXPECT_GE(length, 2 * tangent + 0.8 * angle);
}

TEST(LiveRoute, RefusesWhatCannotBePassed)
{
    const std::vector<Vec2d> path{{0, 0}, {10, 0}};
    const auto problem = [&](const std::vector<Obstacle>& obstacles) -> std::string {
        try {
            routeAround(path, obstacles, 0.1);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_THAT(problem({disc({0.2, 0}, 0.1, "pillar")}), HasSubstr("“pillar” stands at the start"));
    EXPECT_THAT(problem({disc({9.9, 0}, 0.1, "door")}), HasSubstr("“door” stands at the end"));
    std::vector<Obstacle> ring;
    for (int i = 0; i < 16; ++i)
        ring.push_back(disc(2 * Vec2d(std::cos(i * std::numbers::pi / 8), std::sin(i * std::numbers::pi / 8)),
                            0.4, "fence"));
    EXPECT_THAT(problem(ring), HasSubstr("“fence” cannot be passed"));
    ring.erase(ring.begin() + 8, ring.begin() + 11);
    EXPECT_EQ(problem(ring), "");
}

TEST(LiveRoute, GoesAroundPolygons)
{
    const std::vector<Vec2d> path{{0, 0}, {4, 0}, {8, 0}};
    const Obstacle wall{.name = "wall", .outline = {{3, -2}, {3.2, -2}, {3.2, 3}, {3, 3}}, .clearance = 0.2};
    const std::vector<Vec2d> route = routeAround(path, std::vector{wall}, 0.1);
    const auto lowest = std::ranges::min_element(route, {}, [](const Vec2d& p) { return p.y(); });
    EXPECT_NEAR(lowest->y(), -2.3, 0.05);
    for (std::size_t i = 1; i < route.size(); ++i) {
        for (int part = 0; part <= 20; ++part)
            EXPECT_GE(distanceFrom(wall, route[i - 1] + part / 20.0 * (route[i] - route[i - 1])), 0.3 - 1e-9);
    }
}

TEST(LivePath, GoesStraightOn)
{
    const Followed made = follow(turningGraph(), pathOver({{1, 1}, {9, 7}}));
    EXPECT_TRUE(made.hasReachedEnd);
    EXPECT_LT(worst(made.deviations), 0.1);
    EXPECT_LT((made.points.back() - Vec2d(9, 7)).norm(), 0.3);
}

TEST(LivePath, FollowsCurvesEitherWay)
{
    for (const double turns : {0.6, -0.6}) {
        const Followed made = follow(turningGraph(), circle(turns > 0 ? 3 : -3, std::abs(turns)));
        EXPECT_TRUE(made.hasReachedEnd) << turns;
        EXPECT_LT(worst(made.deviations), 0.3) << turns;
    }
}

TEST(LivePath, GoesAroundConesWithoutTouchingThem)
{
    const auto graph = turningGraph();
    Random random(7);
    int reached = 0;
    for (int trial = 0; trial < 12; ++trial) {
        PathConstraint path = pathOver({{0, 0}, {6, 1}, {12, 0}});
        for (int cone = 0; cone < 3; ++cone)
            path.obstacles.push_back(
                disc({random.between(2 + 3 * cone, 4 + 3 * cone), random.between(-0.5, 1.2)}, 0.2));
        const Followed made = follow(graph, path);
        reached += made.hasReachedEnd ? 1 : 0;
        for (const Vec2d& point : made.points) {
            for (const Obstacle& cone : path.obstacles)
                ASSERT_GT(distanceFrom(cone, point), 0) << trial;
        }
    }
    EXPECT_GE(reached, 11);
}

TEST(LivePath, PlaysAgainWithoutTheFollower)
{
    const auto graph = turningGraph();
    const PathConstraint path = circle(2.5, 0.5);
    const Followed made = follow(graph, path);
    EXPECT_EQ(follow(graph, path).inputs, made.inputs);
    LivePlayer player(graph, {}, LivePathFollower(graph, {}, path).start());
    for (const LiveInput& input : made.inputs)
        player.tick(input);
    EXPECT_EQ(player.state(), made.last);
}

TEST(LivePath, GivesUpWhereItCannotTurn)
{
    std::vector<std::shared_ptr<const MotionSpace>> spaces;
    spaces.push_back(std::make_shared<const MotionSpace>(test::makeSpace({.name = "walk"})));
    const auto graph = std::make_shared<const LiveGraph>(makeLiveGraph(std::move(spaces), test::swingingFps));
    const Followed made = follow(graph, pathOver({{0, 0}, {5, 0}, {5, 6}}));
    EXPECT_FALSE(made.hasReachedEnd);
    EXPECT_LT(made.points.size(), 3000U);
}

TEST(LivePath, SaysWhatIsWrong)
{
    EXPECT_THAT(problemOf(pathOver({{1, 1}, {1, 1}})), HasSubstr("no length"));
    PathConstraint blocked = pathOver({{0, 0}, {5, 0}});
    blocked.obstacles = {disc({0, 0.1}, 0.3, "chair")};
    EXPECT_THAT(problemOf(blocked), HasSubstr("“chair” stands at the start"));
    const auto jumps = std::make_shared<const MotionSpace>(
        test::makeSpace({.name = "jump", .frames = 40, .isCyclic = false}));
    std::vector<std::shared_ptr<const MotionSpace>> spaces{jumps};
    const auto graph = std::make_shared<const LiveGraph>(makeLiveGraph(std::move(spaces), test::swingingFps));
    EXPECT_THROW(LivePathFollower(graph, {}, pathOver({{0, 0}, {5, 0}})), Error);
}

TEST(LivePath, ResumesWhereTheBodyIs)
{
    const auto graph = turningGraph();
    LivePathFollower follower(graph, {}, pathOver({{0, 0}, {10, 0}}));
    LivePlayer player(graph, {}, follower.start());
    for (int tick = 0; tick < 200; ++tick)
        player.tick(follower.next(player.state()));
    const LiveState there = player.state();
    const double walked = follower.walked();
    for (int tick = 0; tick < 60; ++tick)
        player.tick(follower.next(player.state()));
    EXPECT_GT(follower.walked(), walked + 0.3);
    follower.resume(there);
    EXPECT_NEAR(follower.walked(), walked, 0.05);
}

} // namespace quadrille
