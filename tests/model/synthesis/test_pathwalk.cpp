// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/synthesis/clips/transitionmotion.h"
#include "model/synthesis/walks/findwalk.h"
#include "tests/model/codeof.h"
#include "tests/model/synthesis/pathreference.h"
#include "tests/model/synthesis/walkworld.h"

#include <gtest/gtest.h>
#include <numeric>

using namespace quadrille;
using quadrille::test::BranchAndBound;
using quadrille::test::WalkWorld;

namespace {

using test::codeOf;

PathConstraint curve(double length)
{
    return {.points = sampleCurve({{0, 0, 1}, {length / 2, 0.2, 1}, {length, 0, 1}}, 0.02)};
}

/// The centre of every output frame, from the definition of a walk.
std::vector<Vec3d> centresOf(const WalkWorld& world, const WalkSolution& solution)
{
    const Ground ground(UpAxis::Z);
    std::vector<Vec3d> centres;
    GroundMotion placement = solution.start;
    for (std::size_t s = 0; s < solution.walk.spans.size(); ++s) {
        const WalkSpan& span = solution.walk.spans[s];
        for (NodeIndex node = span.first + (s == 0 ? 0 : 1); node <= span.last; ++node)
            centres.push_back(placement(world.roots.centres[static_cast<std::size_t>(node)], ground));
        if (s == solution.walk.transitionCount())
            break;
        const TransitionMotion motion =
            transitionMotion(world.roots, world.transition(solution.walk.transition(s)));
        for (std::size_t t = 1; t < motion.steps.size(); ++t)
            centres.push_back(placement(motion.steps[t].centre, ground));
        placement = placement * motion.exit();
    }
    return centres;
}

/// The point of a polyline at an arc length, straight on beyond its end; both from above unless in space.
Vec3d pointAt(const PathConstraint& path, double walked)
{
    const auto flat = [&](const Vec3d& p) { return path.inSpace ? p : Vec3d(p.x(), p.y(), 0); };
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const Vec3d a = flat(path.points[i - 1]);
        const Vec3d b = flat(path.points[i]);
        const double step = (b - a).norm();
        if (walked <= step || i + 1 == path.points.size())
            return a + walked / step * (b - a);
        walked -= step;
    }
    return {};
}

struct Deviations
{
    double squares = 0;
    double charged = 0; ///< by PathCharging
    double mean = 0;
    double walked = 0;
};

Deviations plainDeviations(const WalkWorld& world, const WalkSolution& solution, const PathConstraint& path,
                           const PathCharging& charging = {})
{
    Deviations result;
    const std::vector<Vec3d> centres = centresOf(world, solution);
    for (std::size_t t = 0; t < centres.size(); ++t) {
        const auto flat = [&](const Vec3d& p) { return path.inSpace ? p : Vec3d(p.x(), p.y(), 0); };
        const double step = t > 0 ? (flat(centres[t]) - flat(centres[t - 1])).norm() : 0;
        result.walked += step;
        const double distance = (flat(centres[t]) - pointAt(path, result.walked)).norm();
        result.squares += distance * distance;
        const double off = std::max(0.0, distance - charging.deadZone);
        result.charged += off * off * charging.perMetre * step;
        result.mean += distance / static_cast<double>(centres.size());
    }
    return result;
}

WalkSolution findPathWalk(const WalkWorld& world, const WalkConstraints& constraints,
                          const SearchSettings& settings)
{
    return findWalk(world.material(), constraints, settings);
}

} // namespace

TEST(PathWalk, AccountsForEveryFrame)
{
    const WalkWorld world({.seed = 4, .counts = {20, 25, 15}, .missing = 0.5, .shortest = 4});
    for (const bool inSpace : {false, true}) {
        PathConstraint path = curve(1.5);
        path.inSpace = inSpace;
        const WalkSolution solution = findPathWalk(world, {.path = path}, {.budget = 5000});
        const Deviations plain = plainDeviations(world, solution, path);
        // Single precision of the steps of transitions.
        EXPECT_NEAR(solution.cost.deviation, plain.squares, 1e-5);
        EXPECT_NEAR(solution.meanDeviation, plain.mean, 1e-5);
        EXPECT_GE(plain.walked, solution.pathLength - 1e-5);
        EXPECT_EQ(static_cast<std::size_t>(solution.frameCount), centresOf(world, solution).size());
        EXPECT_NEAR(solution.totalCost, solution.cost.deviation + 0.1 * solution.cost.edges, 1e-12);
        const Vec3d begin = centresOf(world, solution).front();
        EXPECT_NEAR(begin.head<2>().norm(), 0, 1e-9) << "begins on the curve";
    }
}

TEST(PathWalk, IsAsGoodAsBranchAndBoundOnSmallCases)
{
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const WalkWorld world({.seed = seed, .counts = {9, 8, 9}, .missing = 0.6, .shortest = 4});
        const PathConstraint path = curve(0.9);
        const WalkGraph graph(world.graph, world.costs, WalkWorld::alpha, {});
        const ConstraintAutomaton automaton(graph, {.path = path}, 0.1, 0.1);
        const PathCourse course(path, UpAxis::Z);
        const PathCosts costs(course, {}, graph.nodeCount(), 0.1);
        const WalkMaterial material = world.material();
        MoveMotions motions(graph, material.motion, course);
        std::vector<NodeIndex> starts(static_cast<std::size_t>(graph.nodeCount()));
        std::iota(starts.begin(), starts.end(), 0);
        PathProblem problem{graph, automaton, course, costs, motions, starts, 0.1};
        BranchAndBound reference(problem, [] { return false; });
        const double expected = reference.exact();
        if (expected == unreachable)
            continue;
        const WalkSolution solution = findPathWalk(world, {.path = path}, {.budget = 60'000});
        EXPECT_GE(solution.totalCost, expected - 1e-9) << seed;
        // States that nearly agree are one, which may lose a little.
        EXPECT_LE(solution.totalCost, 1.01 * expected) << seed;
        const double greedy = reference.incrementalFromAll(20);
        EXPECT_GE(greedy, expected - 1e-9);
    }
}

TEST(PathWalk, StaysInATakeForAsLongAsIsAsked)
{
    const WalkWorld world({.seed = 4, .counts = {40, 50, 30}, .missing = 0.5, .shortest = 4});
    const PathConstraint path = curve(3);
    const auto shortestRun = [](const Walk& walk) {
        return std::ranges::min(walk.spans, {}, &WalkSpan::frameCount).frameCount();
    };
    const WalkSolution free = findPathWalk(world, {.path = path}, {.budget = 20'000});
    ASSERT_LT(shortestRun(free.walk), 8) << "or the next shows nothing";
    const WalkSolution calm = findPathWalk(world, {.path = path}, {.budget = 20'000, .leastRun = 8});
    EXPECT_GE(shortestRun(calm.walk), 8);
    EXPECT_GE(calm.totalCost, free.totalCost);
    // A transition that must be used may be nearer to another.
    ASSERT_GT(free.walk.transitionCount(), 0U);
    const FramePair required = free.walk.transition(0);
    const WalkSolution decided = findPathWalk(world, {.path = path, .junctions = {.required = {required}}},
                                              {.budget = 20'000, .leastRun = 8});
    bool isUsed = false;
    for (std::size_t t = 0; t < decided.walk.transitionCount(); ++t)
        isUsed = isUsed || decided.walk.transition(t) == required;
    EXPECT_TRUE(isUsed);
}

TEST(PathWalk, CountsDeviationByTheMetreBeyondItsDeadZone)
{
    const WalkWorld world({.seed = 4, .counts = {20, 25, 15}, .missing = 0.5, .shortest = 4});
    const PathConstraint path = curve(1.5);
    const SearchSettings settings{.budget = 5000, .charging = {.deadZone = 0.005, .perMetre = 25}};
    const WalkSolution solution = findPathWalk(world, {.path = path}, settings);
    const Deviations plain = plainDeviations(world, solution, path, settings.charging);
    EXPECT_GT(plain.charged, 0);
    EXPECT_NEAR(solution.cost.deviation, plain.charged, 1e-5);
    EXPECT_LT(plain.charged, plain.squares);
}

TEST(PathWalk, PrefersFramesOfLocomotion)
{
    const WalkWorld world({.seed = 4, .counts = {40, 40, 40}, .missing = 0.3, .shortest = 4});
    WalkMaterial material = world.material();
    const PathConstraint path = curve(2);
    SearchSettings settings{.budget = 20'000, .prefersLocomotion = true, .strayWeight = 1000};
    for (const NodeIndex wanted : {0, 1, 2}) {
        material.locomotion.assign(120, false);
        std::fill_n(material.locomotion.begin() + 40 * wanted, 40, true);
        const WalkSolution solution = findWalk(material, {.path = path}, settings);
        NodeIndex strays = 0;
        for (const WalkSpan& span : solution.walk.spans)
            strays += span.first / 40 == wanted ? 0 : span.frameCount() - 1;
        EXPECT_EQ(strays, 0) << wanted;
    }
}

TEST(PathWalk, DependsOnItsBudgetAlone)
{
    const WalkWorld world({.seed = 4, .counts = {20, 25, 15, 30}, .missing = 0.4, .shortest = 4});
    const WalkConstraints constraints{.path = curve(2.5)};
    const WalkSolution once = findPathWalk(world, constraints, {.budget = 3000});
    EXPECT_EQ(once, findPathWalk(world, constraints, {.budget = 3000}));
    EXPECT_LE(once.expansions, 3000);
    std::vector<WalkSolution> found;
    const WalkSolution best = findWalk(world.material(), constraints, {.budget = 40'000}, {},
                                       [&](const WalkSolution& solution) { found.push_back(solution); });
    // Walks that no exchange makes cheaper are not the cheapest: more is not better each time.
    EXPECT_LE(best.totalCost, 1.05 * once.totalCost);
    ASSERT_GE(found.size(), 2U) << "the first walk comes soon, and a better one later";
    for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_LT(found[i].totalCost, found[i - 1].totalCost);
    EXPECT_EQ(found.back().walk, best.walk);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { findWalk(world.material(), constraints, {}, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST(PathWalk, ShowsDemandedFramesAndKeepsTime)
{
    const WalkWorld world({.seed = 6, .counts = {40, 40, 40}, .missing = 0.3, .shortest = 4});
    PathConstraint path = curve(3);
    path.spans = {{.from = 1, .to = 1.8, .demanded = world.sequence(1, "jump")},
                  {.from = 2, .to = 2.6, .duration = 19}};
    const WalkSolution solution = findPathWalk(world, {.path = path}, {.beta = 1, .budget = 40'000});
    // Every frame in the span is of the sequence, or of a transition that begins or ends in it.
    const std::vector<Vec3d> centres = centresOf(world, solution);
    std::vector<FramePair> origins;
    for (std::size_t s = 0; s < solution.walk.spans.size(); ++s) {
        const WalkSpan& span = solution.walk.spans[s];
        for (NodeIndex node = span.first + (s == 0 ? 0 : 1); node <= span.last; ++node)
            origins.push_back({node, node});
        if (s < solution.walk.transitionCount()) {
            const Transition transition = world.transition(solution.walk.transition(s));
            origins.insert(origins.end(), transition.path.begin() + 1, transition.path.end());
        }
    }
    ASSERT_EQ(origins.size(), centres.size());
    const FrameRange jump = solution.spans[0];
    EXPECT_GT(jump.count(), 5);
    for (std::int64_t t = jump.first.value; t <= jump.last.value; ++t) {
        const FramePair& pair = origins[static_cast<std::size_t>(t)];
        EXPECT_TRUE(world.costs.layout().sequenceOf(pair.source) == 1 ||
                    world.costs.layout().sequenceOf(pair.destination) == 1)
            << t;
    }
    EXPECT_NEAR(static_cast<double>(solution.spans[1].count()), 19, 3);
    EXPECT_NEAR(solution.cost.timing, std::abs(static_cast<double>(solution.spans[1].count()) - 19), 1e-9);
    // Without the demand, none of it is shown there as a matter of course.
    path.spans.erase(path.spans.begin());
    const WalkSolution slower = findPathWalk(world, {.path = path}, {.beta = 1, .budget = 40'000});
    EXPECT_LE(slower.totalCost, solution.totalCost + 1e-9);
}

TEST(PathWalk, GoesAroundObstacles)
{
    const WalkWorld world({.seed = 6, .counts = {40, 40, 40, 40, 40}, .missing = 0.2, .shortest = 4});
    PathConstraint path = curve(3);
    const WalkSolution free = findPathWalk(world, {.path = path}, {.budget = 20'000});
    path.obstacles = {{.name = "pillar", .outline = {{1.5, 0.12}}, .radius = 0.05, .clearance = 0.1},
                      {.name = "wall", .outline = {{2.2, -2}, {2.3, -2}, {2.3, -0.05}}}};
    const WalkSolution around = findPathWalk(world, {.path = path}, {.budget = 20'000});
    const auto nearest = [&](const WalkSolution& solution, const Obstacle& obstacle) {
        double distance = unreachable;
        for (const Vec3d& centre : centresOf(world, solution))
            distance = std::min(distance, distanceFrom(obstacle, centre.head<2>()));
        return distance;
    };
    EXPECT_LT(nearest(free, path.obstacles[0]), 0.1) << "it would be in the way";
    EXPECT_GE(nearest(around, path.obstacles[0]), 0.1 - 1e-6);
    EXPECT_GT(nearest(around, path.obstacles[1]), 0);
}

TEST(PathWalk, MeetsKeysAndActionsOnTheWay)
{
    const WalkWorld world({.seed = 8, .counts = {40, 40, 40}, .missing = 0.3, .shortest = 4});
    const NodeIndex pose = world.costs.layout().firstOf(2) + 20;
    const WalkConstraints constraints{.keys = {{pose, 25}},
                                      .path = curve(3),
                                      .actions = {{.frames = world.sequence(1, "kick"), .leastShare = 0.6}}};
    const WalkSolution solution = findPathWalk(world, constraints, {.budget = 60'000});
    ASSERT_EQ(solution.keys.size(), 1U);
    EXPECT_NEAR(static_cast<double>(solution.keys[0].obtained), 25, 8);
    std::int64_t longest = 0;
    for (const WalkSpan& span : solution.walk.spans) {
        if (world.costs.layout().sequenceOf(span.first) == 1)
            longest = std::max(longest, std::int64_t{span.frameCount()});
    }
    EXPECT_GE(longest, 24) << "60 % of 40 frames, in one piece";
    EXPECT_GE(solution.actions[0].count(), 24);
    EXPECT_NEAR(solution.totalCost, solution.cost.total(0.1), 1e-12);
}

TEST(PathWalk, SaysWhatIsInTheWay)
{
    const WalkWorld world({.seed = 6, .counts = {40, 40}, .missing = 0.3, .shortest = 4});
    PathConstraint path = curve(2);
    // All around the beginning; a fence across the path alone would only make walks turn back.
    path.obstacles = {{.name = "fence", .outline = {{0.3, -1}, {1, -1}, {1, 1}, {0.3, 1}}},
                      {.name = "fence", .outline = {{-1, -1}, {-0.3, -1}, {-0.3, 1}, {-1, 1}}},
                      {.name = "fence", .outline = {{-1, 0.3}, {1, 0.3}, {1, 1}, {-1, 1}}},
                      {.name = "fence", .outline = {{-1, -1}, {1, -1}, {1, -0.3}, {-1, -0.3}}}};
    try {
        findPathWalk(world, {.path = path}, {.budget = 2000});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::WalkPathBlocked);
        EXPECT_EQ(error.context().values[0].second, "fence");
        EXPECT_GT(std::stod(error.context().values[1].second), 0.2);
    }
    // A single frame cannot fill half a metre.
    path.obstacles.clear();
    path.spans = {{.from = 1, .to = 1.5, .demanded = FrameSet{"blink", {{7, 7}}}}};
    try {
        findPathWalk(world, {.path = path}, {.budget = 2000});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::WalkDemandUnmet);
        EXPECT_EQ(error.context().values[0].second, "blink");
    }
}

TEST(PathWalk, SaysWhenEveryWayWasTried)
{
    // Without transitions.
    const WalkWorld world({.seed = 6, .counts = {40, 40}, .missing = 1, .shortest = 4});
    PathConstraint path = curve(1);
    path.obstacles = {{.name = "fence", .outline = {{0.3, -5}, {0.4, -5}, {0.4, 5}, {0.3, 5}}}};
    EXPECT_EQ(test::codeOf([&] { findPathWalk(world, {.path = path}, {}); }), ErrorCode::WalkPathImpassable);
    path.obstacles.clear();
    path.spans = {{.from = 0.5, .to = 0.8, .demanded = FrameSet{"blink", {{7, 7}}}}};
    EXPECT_EQ(test::codeOf([&] { findPathWalk(world, {.path = path}, {}); }),
              ErrorCode::WalkDemandImpossible);
}

TEST(PathWalk, NeitherBeginsNorEndsInTheAir)
{
    const WalkWorld world({.seed = 4, .counts = {20, 25, 15}, .missing = 0.5, .shortest = 4});
    WalkMaterial material = world.material();
    const WalkConstraints constraints{.path = curve(1.5)};
    const Walk free = findWalk(material, constraints, {.budget = 5000}).walk;
    material.inAir.assign(60, false);
    for (const NodeIndex node : {free.spans.front().first, free.spans.back().last})
        material.inAir[static_cast<std::size_t>(node)] = true;
    const Walk walk = findWalk(material, constraints, {.budget = 5000}).walk;
    EXPECT_FALSE(material.inAir[static_cast<std::size_t>(walk.spans.front().first)]);
    EXPECT_FALSE(material.inAir[static_cast<std::size_t>(walk.spans.back().last)]);
}
