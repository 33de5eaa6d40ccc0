// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathoutlook.h"
#include "tests/model/synthesis/walkworld.h"

#include <gtest/gtest.h>
#include <optional>

namespace quadrille {

using quadrille::test::WalkWorld;

namespace {

constexpr double mu = 0.1;
constexpr double step = 0.07; ///< metres in a frame of the third take of a WalkWorld, which goes straight on

PathConstraint straight(double length)
{
    return {.points = {{0, 0, 1}, {length, 0, 1}}};
}

/// Half way straight on, then along an arc to the left.
PathConstraint bending(double length)
{
    PathConstraint path{.points = {{0, 0, 1}, {length / 2, 0, 1}}};
    const double radius = 1.75; // that of the fourth take of a WalkWorld is 0.75
    for (double walked = 0.05; walked <= length / 2; walked += 0.05)
        path.points.emplace_back(length / 2 + radius * std::sin(walked / radius),
                                 radius * (1 - std::cos(walked / radius)), 1);
    return path;
}

/// The outlook along a path of a character, and all that it refers to.
struct Seen
{
    WalkGraph graph;
    PathCourse course;
    PathCosts costs;
    WalkMotion motion;
    MoveMotions motions;
    PathOutlook outlook;

    Seen(const WalkWorld& world, const PathConstraint& path, const Junctions& junctions = {},
         const SteeringLimits& steering = {})
        : graph(world.graph, world.costs, WalkWorld::alpha, junctions)
        , course(path, UpAxis::Z)
        , costs(course, path.spans, graph.nodeCount(), 0.1, {}, steering)
        , motion(world.material().motion)
        , motions(graph, motion, course)
        , outlook(graph, course, costs, motions, mu, 0)
    {
    }

    /// \param side  metres to the left of the beginning.
    double costFrom(NodeIndex node, double side = 0, double turn = 0) const
    {
        const GroundMotion start = motions.placedOnStart(node);
        const Vec2d point = start(Vec2d(motions.point(node).head<2>()));
        const GroundMotion turned = GroundMotion::taking(point, point + Vec2d(0, side), turn);
        return outlook.cost(node, 0, turned * start);
    }
};

} // namespace

TEST(PathOutlook, AddsUpWhatATakeCostsThatGoesStraightOn)
{
    const WalkWorld world({.seed = 1, .counts = {20, 20, 200}, .missing = 1, .shortest = 4});
    const Seen seen(world, straight(6));
    const NodeIndex first = world.costs.layout().firstOf(2);
    const double frames = 6 / step;
    const double edges = mu * WalkWorld::alpha * frames;
    // The last stretch goes on to a frame of the grid behind the end.
    const double overrun = mu * WalkWorld::alpha * 8;
    EXPECT_NEAR(seen.costFrom(first), edges, overrun);
    const double side = 0.216; // one of the grid: 0.6 · (3/5)²
    for (const double sign : {-1.0, 1.0})
        EXPECT_NEAR(seen.costFrom(first, sign * side), edges + frames * side * side,
                    0.05 * frames * side * side);
    EXPECT_LT(seen.costFrom(first, 0.1), seen.costFrom(first, 0.3));
    EXPECT_LT(seen.costFrom(first), seen.costFrom(first, 0, 0.2));
    EXPECT_NEAR(seen.costFrom(first, 0, 0.2), seen.costFrom(first, 0, -0.2), 1e-3) << "a mirror image";
}

TEST(PathOutlook, CostsNothingBehindTheEnd)
{
    const WalkWorld world({.seed = 1, .counts = {20, 20, 200}, .missing = 1, .shortest = 4});
    const Seen seen(world, straight(3));
    const NodeIndex first = world.costs.layout().firstOf(2);
    const GroundMotion placement = seen.motions.placedOnStart(first);
    EXPECT_NEAR(seen.outlook.cost(first + 44, 44 * step, placement), 0, 1e-12);
}

TEST(PathOutlook, KnowsWhatLeadsIntoABend)
{
    const WalkWorld world({.seed = 4, .counts = {20, 20, 120, 120}, .missing = 0.3, .shortest = 4});
    Junctions without;
    const FrameLayout& layout = world.costs.layout();
    for (const Edge& edge : world.graph.edges()) {
        if (edge.kind == EdgeKind::Transition && layout.sequenceOf(edge.to) == 3)
            without.banned.push_back({edge.from, edge.to});
    }
    ASSERT_FALSE(without.banned.empty());
    const NodeIndex first = layout.firstOf(2);
    const PathConstraint path = bending(5);
    const double with = Seen(world, path).costFrom(first);
    EXPECT_LT(with, 0.5 * Seen(world, path, without).costFrom(first));
    // Where nothing bends the take that does is no help.
    const double forth = Seen(world, straight(5)).costFrom(first);
    EXPECT_NEAR(forth, Seen(world, straight(5), without).costFrom(first), 0.1 * forth);
}

TEST(PathOutlook, KnowsHowFarAWalkIsSteered)
{
    // Only a take that goes straight on, and a path that bends by 0.57 radians a metre.
    const WalkWorld world({.seed = 1, .counts = {20, 20, 200}, .missing = 1, .shortest = 4});
    const NodeIndex first = world.costs.layout().firstOf(2);
    const auto costWith = [&](double perMetre) {
        return Seen(world, bending(5), {}, {.perMetre = perMetre, .perFrame = 1}).costFrom(first);
    };
    EXPECT_LT(costWith(0.7), 0.2 * costWith(0));
    EXPECT_LT(costWith(0.3), costWith(0));
    EXPECT_NEAR(costWith(0), Seen(world, bending(5)).costFrom(first), 1e-9);
    const double straightOn = Seen(world, straight(5)).costFrom(first);
    EXPECT_NEAR(Seen(world, straight(5), {}, {.perMetre = 0.7, .perFrame = 1}).costFrom(first), straightOn,
                0.1 * straightOn);
}

TEST(PathOutlook, SeesWhatIsInTheWay)
{
    const WalkWorld world({.seed = 1, .counts = {20, 20, 200}, .missing = 1, .shortest = 4});
    const NodeIndex first = world.costs.layout().firstOf(2);
    PathConstraint path = straight(6);
    path.obstacles = {{.name = "wall", .outline = {{3, -5}, {3.5, -5}, {3.5, 5}, {3, 5}}}};
    EXPECT_GT(Seen(world, path).costFrom(first), 1e4);
    path.obstacles = {{.name = "beside", .outline = {{3, 3}, {3.5, 3}, {3.5, 5}, {3, 5}}}};
    EXPECT_NEAR(Seen(world, path).costFrom(first), Seen(world, straight(6)).costFrom(first), 1e-6);
}

} // namespace quadrille
