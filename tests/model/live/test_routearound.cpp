// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/random.h"
#include "model/live/routearound.h"
#include "model/synthesis/walks/pathcourse.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <numbers>

namespace quadrille {
namespace {

using ::testing::HasSubstr;

Obstacle disc(std::string name, const Vec2d& centre, double radius, double clearance)
{
    return {std::move(name), {centre}, radius, clearance};
}

Obstacle box(std::string name, const Vec2d& low, const Vec2d& high, double clearance)
{
    return {std::move(name), {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, 0, clearance};
}

double lengthOf(const std::vector<Vec2d>& route)
{
    double length = 0;
    for (std::size_t i = 1; i < route.size(); ++i)
        length += (route[i] - route[i - 1]).norm();
    return length;
}

/// By how much a route keeps clear at least, looked at every few millimetres.
double clearOf(const std::vector<Vec2d>& route, const std::vector<Obstacle>& obstacles)
{
    double least = 1e9;
    for (std::size_t i = 1; i < route.size(); ++i) {
        for (int k = 0; k <= 10; ++k) {
            const Vec2d point = route[i - 1] + k / 10.0 * (route[i] - route[i - 1]);
            for (const Obstacle& obstacle : obstacles)
                least = std::min(least, distanceFrom(obstacle, point) - obstacle.clearance);
        }
    }
    return least;
}

std::string refusal(const std::vector<Vec2d>& path, const std::vector<Obstacle>& obstacles)
{
    try {
        routeAround(path, obstacles);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        return error.what();
    }
    return "";
}

const std::vector<Vec2d> alongX{{0, 0}, {10, 0}};

} // namespace

TEST(RouteAround, KeepsAPathThatIsClear)
{
    const std::vector<Vec2d> corner{{0, 0}, {3, 0}, {3, 3}};
    const std::vector<Vec2d> route = routeAround(corner, std::vector{disc("far", {0, 3}, 1, 0.5)});
    EXPECT_NEAR(lengthOf(route), 6, 1e-9);
    EXPECT_EQ(std::ranges::count(route, corner[1]), 1);
    for (std::size_t i = 1; i < route.size(); ++i)
        EXPECT_LE((route[i] - route[i - 1]).norm(), 0.05 + 1e-9);
}

TEST(RouteAround, GoesRoundADiscTheShorterWay)
{
    for (const double side : {-1.0, 1.0}) {
        const std::vector<Obstacle> obstacles{disc("disc", {5, 0.2 * side}, 0.5, 0.3)};
        const std::vector<Vec2d> route = routeAround(alongX, obstacles, {.lead = 20, .margin = 0});
        EXPECT_GE(clearOf(route, obstacles), 0);
        const double nearest = (route[route.size() / 2] - Vec2d(5, 0.2 * side)).norm();
        EXPECT_NEAR(nearest, 0.8, 0.02);
        EXPECT_LT(side * route[route.size() / 2].y(), 0);
        // By hand: two tangents and the arc between them, from (0, ∓0.2) to (10, ∓0.2) seen from the centre.
        const double away = std::hypot(5, 0.2);
        const double tangent = std::sqrt(away * away - 0.64);
        const double arc = std::numbers::pi - 2 * std::atan2(0.2, 5) - 2 * std::acos(0.8 / away);
        EXPECT_NEAR(lengthOf(route), 2 * tangent + 0.8 * arc, 0.01);
        EXPECT_EQ(route.front(), alongX.front());
        EXPECT_EQ(route.back(), alongX.back());
    }
}

TEST(RouteAround, BendsWithoutCorners)
{
    const std::vector<Vec2d> route = routeAround(alongX, std::vector{box("box", {4, -0.5}, {6, 0.3}, 0)});
    // Where it leaves the path 1.2 m before the box, which it passes 0.45 m beside, by 0.36 in one place.
    double sharpest = 0;
    for (std::size_t i = 1; route[i].x() < 3.5; ++i) {
        const Vec2d in = route[i] - route[i - 1];
        const Vec2d out = route[i + 1] - route[i];
        sharpest = std::max(sharpest, std::acos(std::min(in.dot(out) / in.norm() / out.norm(), 1.0)));
    }
    EXPECT_LT(sharpest, 0.25);
}

TEST(RouteAround, LeavesNoMoreOfThePathThanItNeeds)
{
    const std::vector<Obstacle> obstacles{disc("disc", {5, 0}, 0.3, 0.2)};
    for (const Vec2d& point : routeAround(alongX, obstacles)) {
        if (point.x() < 2.5 || point.x() > 7.5) {
            EXPECT_EQ(point.y(), 0);
        }
    }
}

TEST(RouteAround, ComesBackToThePathBetweenObstacles)
{
    const std::vector<Vec2d> path{{0, 0}, {12, 0}};
    const auto sidesOf = [&](const std::vector<Obstacle>& obstacles) {
        std::string sides;
        const std::vector<Vec2d> route = routeAround(path, obstacles);
        for (const Obstacle& each : obstacles) {
            const double x = each.outline.front().x();
            const auto beside = std::ranges::min_element(
                route, {}, [&](const Vec2d& point) { return std::abs(point.x() - x); });
            EXPECT_LT(std::abs(beside->y()), 0.8);
            sides += beside->y() < 0 ? 'r' : 'l';
        }
        return sides;
    };
    const auto cones = [](double from, double apart) {
        return std::vector{disc("a", {from, 0.1}, 0.2, 0.3), disc("b", {from + apart, -0.1}, 0.2, 0.3),
                           disc("c", {from + 2 * apart, 0.1}, 0.2, 0.3)};
    };
    EXPECT_EQ(sidesOf(cones(3, 3)), "rlr");
    EXPECT_EQ(sidesOf(cones(3, 2)), "rrr"); // too near to each other to come back
}

TEST(RouteAround, GoesAroundPolygonsWhicheverWayTheyTurn)
{
    Obstacle angle{"angle", {{4, -2}, {6, -2}, {6, 1}, {5.8, 1}, {5.8, -1.8}, {4, -1.8}}, 0, 0.2};
    for (int turned = 0; turned < 2; ++turned) {
        const std::vector<Obstacle> obstacles{angle, box("box", {2, -0.4}, {2.6, 0.5}, 0.2)};
        const std::vector<Vec2d> route = routeAround(alongX, obstacles);
        EXPECT_GE(clearOf(route, obstacles), 0.1);
        EXPECT_LT(lengthOf(route), 11.5);
        std::ranges::reverse(angle.outline);
    }
}

TEST(RouteAround, GoesAroundWhatOverlaps)
{
    const std::vector<Obstacle> obstacles{disc("a", {5, 0}, 0.5, 0.2), disc("b", {5.4, 0.6}, 0.5, 0.2),
                                          box("c", {4.5, -3}, {5.5, -0.2}, 0.2)};
    const std::vector<Vec2d> route = routeAround(alongX, obstacles);
    EXPECT_GE(clearOf(route, obstacles), 0.1);
    EXPECT_GT(std::ranges::max(route, {}, [](const Vec2d& p) { return p.y(); }).y(), 1.2);
}

TEST(RouteAround, TakesAGapThatIsTooNarrowForTheMargin)
{
    const std::vector<Obstacle> obstacles{box("low", {4, -9}, {5, -0.3}, 0.25),
                                          box("high", {4, 0.3}, {5, 9}, 0.25)};
    const std::vector<Vec2d> route = routeAround(alongX, obstacles, {.margin = 0.2});
    EXPECT_GE(clearOf(route, obstacles), 0);
    EXPECT_NEAR(lengthOf(route), 10, 0.1);
}

TEST(RouteAround, StartsNearAnObstacleThatItKeepsItsClearanceFrom)
{
    const std::vector<Obstacle> obstacles{disc("near", {0.504, 0}, 0.2, 0.3)};
    EXPECT_GE(clearOf(routeAround(alongX, obstacles), obstacles), 0);
}

TEST(RouteAround, RefusesWhatCannotBeDone)
{
    EXPECT_THAT(refusal(alongX, {disc("far", {5, 5}, 1, 0), disc("bin", {0.4, 0}, 0.2, 0.3)}),
                HasSubstr("“bin” stands at the start"));
    EXPECT_THAT(refusal(alongX, {disc("bin", {10, 0.4}, 0.2, 0.3)}), HasSubstr("“bin” stands at the end"));
    std::vector<Obstacle> ring;
    for (int i = 0; i < 12; ++i) {
        const double angle = 2 * std::numbers::pi * i / 12;
        ring.push_back(disc("post " + std::to_string(i), Vec2d(10 + 2 * std::cos(angle), 2 * std::sin(angle)),
                            0.3, 0.3));
    }
    EXPECT_THAT(refusal(alongX, ring), HasSubstr("“post 6” cannot be passed"));
    ring.erase(ring.begin() + 3);
    EXPECT_GE(clearOf(routeAround(alongX, ring), ring), 0);
    EXPECT_THAT(refusal(alongX, {{"two", {{4, 4}, {5, 5}}, 0, 0}}), HasSubstr("“two” is neither"));
    EXPECT_THAT(refusal({}, {}), HasSubstr("no points"));
}

TEST(RouteAround, StaysWhereAPathDoes)
{
    EXPECT_EQ(routeAround(std::vector<Vec2d>{{1, 2}, {1, 2}}, std::vector<Obstacle>{}),
              (std::vector<Vec2d>{{1, 2}}));
}

TEST(RouteAround, KeepsClearOfRandomObstacles)
{
    int refused = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        std::vector<Obstacle> obstacles;
        for (int i = 0; i < 12; ++i) {
            const Vec2d centre(random.between(1.5, 8.5), random.between(-2, 2));
            const double size = random.between(0.1, 0.5);
            if (i % 2 == 0)
                obstacles.push_back(disc("disc", centre, size, random.between(0, 0.4)));
            else
                obstacles.push_back(
                    box("box", centre - Vec2d(size, 0.1), centre + Vec2d(size, 0.1), random.between(0, 0.4)));
        }
        try {
            EXPECT_GE(clearOf(routeAround(alongX, obstacles), obstacles), 0) << seed;
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_EQ(refused, 0); // obstacles end 3 m beside the path
}

} // namespace quadrille
