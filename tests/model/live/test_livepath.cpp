// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "followedpath.h"
#include "model/core/error.h"
#include "tests/model/parametric/countallocations.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace quadrille {
namespace {

using test::arcPath;
using test::curvingGraph;
using test::eightPath;
using test::Followed;
using test::followed;
using test::jumping;
using test::overGround;
using test::straightPath;
using test::turning;
using test::walking;
using test::wavyPath;
using ::testing::HasSubstr;

/// One space, by speed and turning.
std::shared_ptr<const LiveGraph> steeredGraph()
{
    MotionSpace space = test::makeSpace(test::SwingingSpace{.name = "steered"});
    const SpaceTake take = space.takes.front();
    space.takes.clear();
    std::vector<SpacePoint> places;
    for (const double speed : {0.6, 1.8}) {
        for (const double turning : {-90.0, 90.0}) {
            places.push_back({speed, turning});
            space.takes.push_back(take);
            std::ranges::fill(space.takes.back().steps,
                              GroundMotion{turning * std::numbers::pi / 180 / test::swingingFps,
                                           Vec2d(speed / test::swingingFps, 0)});
        }
    }
    space.weights = WeightSpace(places, 2);
    space.parameters = {{"speed", SpaceMeasure::Speed, {}}, {"turning", SpaceMeasure::Turning, {}}};
    space.map =
        fitParameterMap(space.weights, space.parameters, [](const SpacePoint& place) { return place; });
    return std::make_shared<const LiveGraph>(
        makeLiveGraph({std::make_shared<const MotionSpace>(std::move(space))}, test::swingingFps));
}

std::shared_ptr<const LiveGraph> graphOf(const test::SwingingSpace& space)
{
    return std::make_shared<const LiveGraph>(
        makeLiveGraph({std::make_shared<const MotionSpace>(test::makeSpace(space))}, test::swingingFps));
}

std::string problemOf(const PathConstraint& path, const LivePathSettings& settings = {})
{
    try {
        followed(graphOf({.name = "walk"}), path, settings);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        return error.what();
    }
    return {};
}

} // namespace

TEST(LivePath, FollowsAStraightLine)
{
    const Followed result = followed(curvingGraph(100), straightPath());
    EXPECT_TRUE(result.hasReachedEnd);
    EXPECT_GE(result.walked, 10);
    EXPECT_LT(result.worst(), 0.02);
    // As fast as walking goes: 2 m a second, from the middle of its speeds on.
    EXPECT_LT(result.inputs.size(), 60 * 5.6);
}

TEST(LivePath, FollowsCirclesAndWaves)
{
    const auto graph = curvingGraph(100);
    for (const double side : {1.0, -1.0}) {
        const Followed round = followed(graph, arcPath(3, 6, side));
        EXPECT_TRUE(round.hasReachedEnd);
        EXPECT_LT(round.worst(), 0.1);
    }
    // On seeds 1 to 24 it was 0.07 and 0.09 at most.
    for (std::uint64_t seed = 101; seed <= 108; ++seed) {
        const Followed result = followed(graph, wavyPath(seed));
        EXPECT_TRUE(result.hasReachedEnd) << seed;
        EXPECT_LT(result.most(0.95), 0.12) << seed;
        EXPECT_LT(result.worst(), 0.18) << seed;
    }
}

TEST(LivePath, TurnsInTimeWhereItTurnsSlowly)
{
    const auto graph = curvingGraph(50); // curves of 1.2 m and more
    for (std::uint64_t seed = 101; seed <= 108; ++seed) {
        const Followed result = followed(graph, wavyPath(seed));
        EXPECT_TRUE(result.hasReachedEnd) << seed;
        EXPECT_LT(result.worst(), 0.3) << seed;
    }
}

TEST(LivePath, ComesBackWhereThePathTurnsFasterThanItCan)
{
    const auto graph = curvingGraph(25); // curves of 2.4 m and more
    for (std::uint64_t seed = 101; seed <= 108; ++seed)
        EXPECT_TRUE(followed(graph, wavyPath(seed)).hasReachedEnd) << seed;
}

TEST(LivePath, SwervesFromWhatIsBetweenItAndThePath)
{
    const auto graph = curvingGraph(100);
    const Obstacle disc{"disc", {{2, 0.8}}, 0.3, 0.25};
    for (const double beside : {0.7, 0.8, 0.9, 1.0}) {
        LivePathFollower follower(graph, {}, straightPath({disc}));
        LiveStart start = follower.start();
        start.root.shift = {0.6, beside};
        LivePlayer player(graph, {}, start);
        double nearest = 1e9;
        while (!follower.isDone()) {
            player.tick(follower.next(player.state()));
            nearest = std::min(nearest, distanceFrom(disc, player.root().shift));
        }
        EXPECT_TRUE(follower.hasReachedEnd());
        EXPECT_GE(nearest, disc.clearance) << beside;
    }
}

TEST(LivePath, GoesOnWhereAPathCrossesItself)
{
    // What is less than a metre on counts: not the end, which is at the crossing as well.
    const PathCourse route(eightPath(), UpAxis::Y);
    const double half = route.length() / 2;
    const Vec2d beyondEnd = route.at(route.length() + 0.1).head<2>();
    EXPECT_NEAR(placeOn(route, beyondEnd, half - 0.05).along, half, 0.2);
    const Followed result = followed(curvingGraph(100), eightPath());
    EXPECT_TRUE(result.hasReachedEnd);
    EXPECT_GT(result.inputs.size(), 60 * result.walked / 2);
    EXPECT_LT(result.worst(), 0.15);
}

TEST(LivePath, GoesAroundWhatIsInItsWay)
{
    const auto graph = curvingGraph(100);
    const Obstacle disc{"disc", {{4, 0.1}}, 0.5, 0.3};
    const Obstacle box{"box", {{6.5, -0.5}, {7.5, -0.5}, {7.5, 0.3}, {6.5, 0.3}}, 0, 0.3};
    for (const std::vector<Obstacle>& obstacles : {std::vector{disc}, std::vector{box}, {disc, box}}) {
        const Followed result = followed(graph, straightPath(obstacles));
        EXPECT_TRUE(result.hasReachedEnd);
        for (const Obstacle& obstacle : obstacles)
            EXPECT_GE(result.nearestTo(obstacle), obstacle.clearance) << obstacle.name;
    }
}

TEST(LivePath, EntersNoObstacleOfRandomCourses)
{
    const auto graph = curvingGraph(100);
    for (std::uint64_t seed = 201; seed <= 220; ++seed) {
        Random random(seed);
        std::vector<Obstacle> obstacles;
        for (int i = 0; i < 6; ++i) {
            const Vec2d centre(1.6 + 1.35 * i + random.between(0, 0.6), random.between(-0.9, 0.9));
            const double size = random.between(0.1, 0.35);
            if (random.unit() < 0.5)
                obstacles.push_back({"disc", {centre}, size, 0.2});
            else
                obstacles.push_back({"corner",
                                     {centre, centre + Vec2d(size, -size), centre + Vec2d(2 * size, size)},
                                     0,
                                     0.2});
        }
        PathConstraint path = wavyPath(seed + 50);
        std::erase_if(obstacles, [&](const Obstacle& obstacle) {
            return distanceFrom(obstacle, Ground(UpAxis::Y).of(path.points.back())) < 0.5;
        });
        path.obstacles = obstacles;
        const Followed result = followed(graph, path);
        EXPECT_TRUE(result.hasReachedEnd) << seed;
        for (const Obstacle& obstacle : obstacles)
            EXPECT_GT(result.nearestTo(obstacle), obstacle.clearance - 0.05) << seed;
    }
}

TEST(LivePath, SteersByTwoParameters)
{
    const Followed result = followed(steeredGraph(), wavyPath(102));
    EXPECT_TRUE(result.hasReachedEnd);
    EXPECT_LT(result.worst(), 0.15);
}

TEST(LivePath, WantsNothingThatDoesNotGoOnOrCannotBeGotTo)
{
    const auto graph = curvingGraph(100);
    for (const LiveInput& input : followed(graph, wavyPath(3)).inputs)
        ASSERT_NE(input.space, jumping);
    // Wanting another space would hold what it does, which is often best by now.
    LiveGraph apart{
        .fps = graph->fps, .spaces = {graph->spaces[turning], graph->spaces[walking]}, .tables = {}};
    apart.tables.resize(2, std::vector<std::shared_ptr<const SimilarityTable>>(2));
    const Followed result =
        followed(std::make_shared<const LiveGraph>(apart), wavyPath(3), {.transitionWeight = 0});
    for (const LiveInput& input : result.inputs)
        ASSERT_EQ(input.space, 0U);
}

TEST(LivePath, EndsWhereAGraphCannotTurn)
{
    const Followed result = followed(graphOf({.name = "walk"}), arcPath(2, 6));
    EXPECT_TRUE(result.isDone);
    EXPECT_FALSE(result.hasReachedEnd);
    EXPECT_GT(result.walked, 1);
    EXPECT_LT(result.inputs.size(), 60 * 20);
}

TEST(LivePath, FindsThePathFromBesideIt)
{
    const auto graph = curvingGraph(100);
    LivePathFollower follower(graph, {}, straightPath());
    LiveStart start = follower.start();
    start.root.shift.y() += 1;
    start.root.turn += 1;
    LivePlayer player(graph, {}, start);
    while (follower.walked() < 6 && !follower.isDone())
        player.tick(follower.next(player.state()));
    EXPECT_FALSE(follower.isDone());
    EXPECT_LT(follower.deviation(), 0.1);
}

TEST(LivePath, RefusesWhatCannotBeFollowed)
{
    EXPECT_THAT(problemOf(straightPath({{"bin", {{0.2, 0}}, 0.1, 0.3}})),
                HasSubstr("“bin” stands at the start"));
    EXPECT_THAT(problemOf(PathConstraint{}), HasSubstr("no length"));
    PathConstraint point;
    point.points = {overGround(2, 1), overGround(2, 1)};
    EXPECT_THAT(problemOf(point), HasSubstr("no length"));
    EXPECT_THAT(problemOf(straightPath(), {.planSeconds = 0}), HasSubstr("not positive"));
    EXPECT_THAT(problemOf(straightPath(), {.tolerance = 0}), HasSubstr("not positive"));
    EXPECT_THROW(followed(graphOf({.name = "jump", .frames = 40, .isCyclic = false}), straightPath()), Error);
}

TEST(LivePath, GoesOnFromWhereItWasGoneBackTo)
{
    const auto graph = curvingGraph(100);
    LivePathFollower follower(graph, {}, eightPath());
    LivePlayer player(graph, {}, follower.start());
    const auto inputsToTheEnd = [&] {
        std::vector<LiveInput> inputs;
        while (!follower.isDone()) {
            inputs.push_back(follower.next(player.state()));
            player.tick(inputs.back());
        }
        return inputs;
    };
    const std::vector<LiveInput> whole = inputsToTheEnd();
    ASSERT_TRUE(follower.hasReachedEnd());
    // From the start the same follows, to the bit.
    player.start(follower.start());
    follower.resume(player.state(), 0);
    EXPECT_EQ(inputsToTheEnd(), whole);
    // Where the path crosses itself it goes on from where it was walked, not from what is near.
    player.start(follower.start());
    follower.resume(player.state(), 0);
    const double half = follower.route().length() / 2;
    while (follower.walked() < half)
        player.tick(follower.next(player.state()));
    const LiveState there = player.state();
    const double walked = follower.walked();
    inputsToTheEnd();
    for (const double from : {walked, 0.0}) {
        player.restore(there);
        follower.resume(there, from);
        EXPECT_EQ(follower.walked(), from);
        EXPECT_FALSE(follower.isDone());
        follower.next(there);
        EXPECT_NEAR(follower.walked(), from, 0.1);
        inputsToTheEnd();
        EXPECT_TRUE(follower.hasReachedEnd());
    }
}

TEST(LivePath, WantsTheSameAgainAndIsReplayedByAPlayer)
{
    const auto graph = curvingGraph(100);
    PathConstraint path = wavyPath(5);
    path.obstacles = {{"disc", {{3, 0}}, 0.2, 0.2}};
    const Followed first = followed(graph, path);
    const Followed second = followed(graph, path);
    EXPECT_EQ(first.inputs, second.inputs);
    EXPECT_EQ(first.states, second.states);
    LivePlayer player(graph, {}, LivePathFollower(graph, {}, path).start());
    std::vector<LiveState> states;
    perform(player, first.inputs, [&](const LivePlayer& each) { states.push_back(each.state()); });
    EXPECT_EQ(states, first.states);
}

TEST(LivePath, AllocatesNothingOnItsWay)
{
    const auto graph = curvingGraph(100);
    LivePathFollower follower(graph, {}, wavyPath(6));
    LivePlayer player(graph, {}, follower.start());
    const std::size_t before = test::allocationCount();
    while (!follower.isDone())
        player.tick(follower.next(player.state()));
    EXPECT_EQ(test::allocationCount(), before);
    EXPECT_TRUE(follower.hasReachedEnd());
}

} // namespace quadrille
