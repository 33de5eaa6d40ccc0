// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/findwalk.h"
#include "model/synthesis/walks/steeredplan.h"
#include "tests/model/synthesis/walkworld.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace quadrille;
using quadrille::test::WalkWorld;

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A quarter of a circle to the left and one to the right, each of a radius of 2 m: 28.6° a metre.
PathConstraint bends()
{
    PathConstraint path;
    constexpr double radius = 2;
    for (double angle = 0; angle <= std::numbers::pi / 2; angle += 0.01)
        path.points.emplace_back(radius * std::sin(angle), radius * (1 - std::cos(angle)), 1);
    for (double angle = std::numbers::pi / 2; angle >= 0; angle -= 0.01)
        path.points.emplace_back(2 * radius - radius * std::sin(angle), 1 + radius + radius * std::cos(angle),
                                 1);
    return path;
}

ClipPlan planOf(const WalkWorld& world, const WalkSolution& solution)
{
    std::vector<Transition> transitions;
    for (std::size_t t = 0; t < solution.walk.transitionCount(); ++t)
        transitions.push_back(world.transition(solution.walk.transition(t)));
    return planClip(world.roots, solution.walk, transitions, {.start = solution.start});
}

double meanDeviation(const ClipPlan& plan, const PathCourse& course)
{
    double sum = 0;
    double walked = 0;
    Vec3d before = course.pointOf(plan.frames.front().centre);
    for (const PlannedFrame& frame : plan.frames) {
        const Vec3d point = course.pointOf(frame.centre);
        walked += (point - before).norm();
        before = point;
        sum += (point - course.at(walked)).norm();
    }
    return sum / static_cast<double>(plan.frameCount());
}

} // namespace

TEST(PathSteering, TurnsToWhereThePathIsALittleFartherOn)
{
    const PathConstraint path{.points = {{0, 0, 0}, {10, 0, 0}}};
    const PathCourse course(path, UpAxis::Z);
    const PathSteering steering(course, {.perMetre = 1, .perFrame = 0.02});
    // 0.8 m ahead of (1, 0.8) lies (1.8, 0): an eighth of a turn to the right, half of it in a quarter metre.
    const double off = -std::numbers::pi / 4;
    const PathSteering free(course, {.perMetre = 100, .perFrame = 100});
    EXPECT_NEAR(free.turnOf({{1, 0.8}, 0, 1, 0.25, 10}), off / 2, 1e-12);
    EXPECT_NEAR(free.turnOf({{1, 0.8}, 0, 1, 0.5, 10}), off, 1e-12);
    EXPECT_NEAR(free.turnOf({{1, 0.8}, 0, 1, 2, 10}), off, 1e-12) << "never farther than to it";
    EXPECT_NEAR(free.turnOf({{1, -0.8}, 2 * std::numbers::pi, 1, 0.5, 10}), -off, 1e-12);
    EXPECT_NEAR(steering.turnOf({{1, 0.8}, 0, 1, 0.1, 10}), -0.1, 1e-12) << "a metre's limit";
    EXPECT_NEAR(steering.turnOf({{1, 0.8}, 0, 1, 0.1, 2}), -0.04, 1e-12) << "a frame's limit";
    EXPECT_EQ(steering.turnOf({{1, 0}, 0, 1, 0.1, 2}), 0) << "it goes there already";
    EXPECT_EQ(steering.turnOf({{1, 0.8}, 0, 1, 0, 2}), 0) << "who stands does not turn";
    EXPECT_EQ(PathSteering(course, {}).turnOf({{1, 0.8}, 0, 1, 0.1, 2}), 0);
    EXPECT_FALSE(PathSteering(course, {.perMetre = 1}).doesTurn());
}

TEST(PathSteering, TakesAStraightTakeAroundBends)
{
    // Only the third take goes straight on, and nothing leads from one to another.
    const WalkWorld world({.seed = 1, .counts = {20, 20, 200}, .missing = 1, .shortest = 4});
    WalkConstraints constraints{.path = bends(), .start = world.sequence(2)};
    const WalkSolution captured = findWalk(world.material(), constraints, {.budget = 2000});
    EXPECT_GT(captured.meanDeviation, 0.5);
    const WalkSolution steered =
        findWalk(world.material(), constraints,
                 {.budget = 2000, .steering = {.perMetre = 0.6, .perFrame = unbounded}});
    EXPECT_LT(steered.meanDeviation, 0.1);
    const WalkSolution little = findWalk(world.material(), constraints,
                                         {.budget = 2000, .steering = {.perMetre = 0.6, .perFrame = 0.01}});
    EXPECT_GT(little.meanDeviation, steered.meanDeviation);
}

TEST(PathSteering, PlansWhatTheSearchFound)
{
    WalkWorld world({.seed = 4, .counts = {30, 45, 35}, .missing = 0.5, .shortest = 4});
    for (const double metresPerUnit : {1.0, 0.01}) {
        const SteeringLimits limits{.perMetre = 0.5, .perFrame = 0.02};
        WalkMaterial material = world.material();
        material.motion.metresPerUnit = metresPerUnit;
        const WalkSolution solution =
            findWalk(material, {.path = bends()}, {.budget = 5000, .steering = limits});
        ASSERT_GT(solution.walk.transitionCount(), 0U);
        const PathCourse course(bends(), UpAxis::Z, metresPerUnit);
        const ClipPlan plain = planOf(world, solution);
        const ClipPlan steered = steeredPlan(plain, world.roots, world.costs.layout(), course, limits);
        EXPECT_NEAR(meanDeviation(steered, course), solution.meanDeviation, 1e-5);
        EXPECT_GT(std::abs(meanDeviation(plain, course) - solution.meanDeviation), 0.01);
        for (std::size_t f = 1; f < plain.frames.size(); ++f) {
            const auto turned = [&](std::size_t frame) {
                return steered.frames[frame].placeSource.turn - plain.frames[frame].placeSource.turn;
            };
            const double step =
                (course.pointOf(steered.frames[f].centre) - course.pointOf(steered.frames[f - 1].centre))
                    .norm();
            EXPECT_LE(std::abs(turned(f) - turned(f - 1)), limits.perMetre * step + 1e-9) << f;
            const double captured =
                (course.pointOf(plain.frames[f].centre) - course.pointOf(plain.frames[f - 1].centre)).norm();
            EXPECT_NEAR(step, captured, 1e-9) << f << ": steps are as long as before";
        }
        // A world of the same size in other units, for the second time round.
        for (Vec3d& centre : world.roots.centres)
            centre *= 100;
    }
}

TEST(PathSteering, LeavesAPlanAloneWithoutLimits)
{
    const WalkWorld world({.seed = 4, .counts = {30, 45, 35}, .missing = 0.5, .shortest = 4});
    const WalkSolution solution = findWalk(world.material(), {.path = bends()}, {.budget = 5000});
    const PathCourse course(bends(), UpAxis::Z);
    const ClipPlan plain = planOf(world, solution);
    const ClipPlan same = steeredPlan(plain, world.roots, world.costs.layout(), course, {});
    EXPECT_NEAR(meanDeviation(same, course), solution.meanDeviation, 1e-5);
    for (std::size_t f = 0; f < plain.frames.size(); ++f)
        EXPECT_EQ(same.frames[f].placeDestination, plain.frames[f].placeDestination);
    // A path of which a walk that is given has none or one of the points.
    for (const std::vector<Vec3d>& points : {std::vector<Vec3d>(), {{1, 1, 0}}, {{1, 1, 0}, {1, 1, 0}}}) {
        const PathCourse none({.points = points}, UpAxis::Z);
        const ClipPlan left = steeredPlan(plain, world.roots, world.costs.layout(), none,
                                          {.perMetre = 0.5, .perFrame = unbounded});
        EXPECT_EQ(left.frames.back().placeSource, plain.frames.back().placeSource) << points.size();
    }
}
