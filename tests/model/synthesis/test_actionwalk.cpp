// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/synthesis/walks/findwalk.h"
#include "tests/model/codeof.h"
#include "tests/model/synthesis/walkreference.h"
#include "tests/model/synthesis/walkworld.h"

#include <functional>
#include <gtest/gtest.h>

using namespace quadrille;
using quadrille::test::everyWalk;
using quadrille::test::WalkWorld;

namespace {

using test::codeOf;

constexpr double alpha = WalkWorld::alpha;

WalkSolution find(const WalkWorld& world, const WalkConstraints& constraints,
                  const SearchSettings& settings = {})
{
    return findWalk(world.material(), constraints, settings);
}

/// Every walk as the frames that it comes to, its moves between them.
struct PlainWalk
{
    std::vector<NodeIndex> nodes;
    std::vector<bool> isOriginal; ///< of the move to each node; the first has none
    std::vector<std::int32_t> times;
    double cost = 0;
};

/// The least that performing actions one after the other adds to a walk: frames left out, errors of
/// durations.
double plainActions(const WalkWorld& world, const PlainWalk& walk, const std::vector<Action>& actions,
                    std::size_t action, std::size_t from, double beta)
{
    if (action == actions.size())
        return 0;
    const Action& wanted = actions[action];
    double best = unreachable;
    for (const WalkSpan& span : wanted.frames.spans) {
        for (std::size_t a = from; a < walk.nodes.size(); ++a) {
            for (std::size_t b = a; b < walk.nodes.size(); ++b) {
                const bool isInside = walk.nodes[b] >= span.first && walk.nodes[b] <= span.last;
                if (!isInside || (b > a && !wanted.duration && !walk.isOriginal[b]))
                    break;
                double extra = alpha * (walk.nodes[a] - span.first + span.last - walk.nodes[b]);
                if (wanted.duration)
                    extra = beta * std::abs(walk.times[b] - walk.times[a] + 1 - *wanted.duration);
                else if (walk.nodes[b] - walk.nodes[a] + 1 < wanted.leastShare * span.frameCount() - 1e-9)
                    continue;
                best = std::min(best, extra + plainActions(world, walk, actions, action + 1, b + 1, beta));
            }
        }
    }
    return best;
}

double exhaustive(const WalkWorld& world, const std::vector<Action>& actions, double beta,
                  std::int32_t longest)
{
    const WalkGraph graph(world.graph, world.costs, alpha, {});
    double best = unreachable;
    for (NodeIndex start = 0; start < graph.nodeCount(); ++start) {
        everyWalk(graph, start, longest, [&](const WalkRoute& route, std::int32_t, double cost) {
            if (cost >= best)
                return;
            PlainWalk walk{.nodes = {start}, .isOriginal = {false}, .times = {0}};
            for (const MoveIndex index : route.moves) {
                const WalkMove& move = graph.move(index);
                walk.nodes.push_back(move.to);
                walk.isOriginal.push_back(move.kind == EdgeKind::Original);
                walk.times.push_back(walk.times.back() + move.elapsed);
            }
            best = std::min(best, cost + plainActions(world, walk, actions, 0, 0, beta));
        });
    }
    return best;
}

} // namespace

TEST(ActionWalk, IsTheCheapestOfAllWalksThatPerformInOrder)
{
    for (std::uint32_t seed = 0; seed < 15; ++seed) {
        const WalkWorld world({.seed = seed, .counts = {4, 4, 3}, .missing = 0.8, .shortest = 2});
        const std::vector<std::vector<Action>> cases{
            {{.frames = world.sequence(1), .leastShare = 0.5}},
            {{.frames = world.sequence(1), .leastShare = 0.7}, {.frames = world.sequence(0)}},
            {{.frames = world.sequence(2), .leastShare = 0.3}, {.frames = world.sequence(1), .duration = 3}},
        };
        for (const std::vector<Action>& actions : cases) {
            const double expected = exhaustive(world, actions, 0.02, 9);
            try {
                const WalkSolution solution = find(world, {.actions = actions}, {.beta = 0.02});
                EXPECT_TRUE(solution.optimal);
                EXPECT_NEAR(solution.bound, solution.totalCost, 1e-12);
                try {
                    const WalkSolution hasty = find(world, {.actions = actions}, {.beta = 0.02, .budget = 6});
                    EXPECT_LE(hasty.bound, solution.totalCost + 1e-12) << seed;
                } catch (const Error& error) {
                    EXPECT_EQ(error.code(), ErrorCode::WalkNotFound) << seed;
                }
                if (solution.frameCount <= 10)
                    EXPECT_NEAR(solution.totalCost, expected, 1e-12) << seed;
                else
                    EXPECT_LE(solution.totalCost, expected + 1e-12) << seed;
            } catch (const Error& error) {
                EXPECT_EQ(expected, unreachable) << seed << ": " << error.what();
            }
        }
    }
}

TEST(ActionWalk, RepeatsAndGoesOn)
{
    const WalkWorld world({.seed = 3, .counts = {20, 20, 20}, .missing = 0.3, .shortest = 4});
    const WalkConstraints constraints{
        .actions = {{.frames = world.sequence(0, "walk"), .duration = 50},
                    {.frames = world.sequence(1, "kick"), .repetitions = 3, .leastShare = 0.6},
                    {.frames = world.sequence(2, "sit"), .leastShare = 0.6}}};
    const WalkSolution solution = find(world, constraints);
    EXPECT_TRUE(solution.optimal);
    int kicks = 0;
    for (const WalkSpan& span : solution.walk.spans)
        kicks += world.costs.layout().sequenceOf(span.first) == 1 && span.frameCount() >= 12 ? 1 : 0;
    EXPECT_EQ(kicks, 3);
    ASSERT_EQ(solution.actions.size(), 3U);
    EXPECT_NEAR(static_cast<double>(solution.actions[0].count()), 50, 1);
    EXPECT_GT(solution.actions[1].first, solution.actions[0].last);
    EXPECT_GT(solution.actions[2].first, solution.actions[1].last);
    EXPECT_EQ(solution.actions[2].last.value, solution.frameCount - 1) << "nothing more is asked";
    EXPECT_NEAR(solution.totalCost, solution.cost.edges + solution.cost.timing, 1e-12);
    std::vector<WalkSolution> found;
    findWalk(world.material(), constraints, {}, {}, [&](const WalkSolution& s) { found.push_back(s); });
    EXPECT_EQ(found.back().walk, solution.walk);
}

TEST(ActionWalk, CombinesWithKeysAndTheStart)
{
    const WalkWorld world({.seed = 5, .counts = {20, 20, 20}, .missing = 0.3, .shortest = 4});
    const NodeIndex pose = world.costs.layout().firstOf(2) + 9;
    const WalkConstraints constraints{.keys = {{pose, 15}, {pose, 70}},
                                      .actions = {{.frames = world.sequence(1, "kick"), .leastShare = 0.6}},
                                      .start = FrameSet{"here", {{3, 5}}}};
    const WalkSolution solution = find(world, constraints, {.beta = 1});
    EXPECT_TRUE(solution.optimal);
    EXPECT_GE(solution.walk.spans.front().first, 3);
    EXPECT_LE(solution.walk.spans.front().first, 5);
    ASSERT_EQ(solution.keys.size(), 2U);
    EXPECT_EQ(solution.keys[0].obtained, 15);
    EXPECT_EQ(solution.keys[1].obtained, 70);
    EXPECT_GE(solution.actions[0].count(), 12);
}

TEST(ActionWalk, KeepsJunctionsAsDecided)
{
    const WalkWorld world({.seed = 5, .counts = {20, 20, 20}, .missing = 0.3, .shortest = 4});
    WalkConstraints constraints{.actions = {{.frames = world.sequence(0)}, {.frames = world.sequence(2)}}};
    const WalkSolution first = find(world, constraints);
    ASSERT_EQ(first.walk.transitionCount(), 1U);
    const FramePair junction = first.walk.transition(0);
    constraints.junctions.banned = {junction};
    const WalkSolution second = find(world, constraints);
    for (std::size_t t = 0; t < second.walk.transitionCount(); ++t)
        EXPECT_NE(second.walk.transition(t), junction);
    EXPECT_GE(second.totalCost, first.totalCost);
    // A detour that nobody would take, and a span that must stay whole.
    FramePair detour;
    for (NodeIndex i = 4; i < 12; ++i) {
        if (world.costs.hasTransition(i, 30))
            detour = {i, 30};
    }
    constraints.junctions = {.required = {detour}, .spans = {{32, 36}}};
    const WalkSolution third = find(world, constraints);
    bool hasDetour = false;
    for (std::size_t t = 0; t < third.walk.transitionCount(); ++t)
        hasDetour = hasDetour || third.walk.transition(t) == detour;
    EXPECT_TRUE(hasDetour);
    EXPECT_TRUE(std::any_of(third.walk.spans.begin(), third.walk.spans.end(),
                            [](const WalkSpan& span) { return span.first <= 32 && span.last >= 36; }));
    EXPECT_TRUE(third.optimal);
    EXPECT_GT(third.totalCost, first.totalCost);
}

TEST(ActionWalk, SaysHowMuchOfAnActionCanBePlayed)
{
    // Transitions come to frame 3 of the second sequence and leave it at frame 7.
    const std::vector<std::int64_t> counts{10, 10};
    Table<float> cost = Table<float>::Constant(20, 20, std::numeric_limits<float>::infinity());
    Table<std::uint16_t> length = Table<std::uint16_t>::Zero(20, 20);
    for (const auto& [from, to] : {std::pair{4, 13}, std::pair{17, 2}}) {
        cost(from, to) = 1;
        length(from, to) = 4;
    }
    const TransitionCosts costs(cost, length, 1, FrameLayout(counts));
    const Digraph graph = essentialGraph(costs, alpha).graph;
    const WalkMaterial material{.graph = graph, .costs = costs, .alpha = alpha, .motion = {}};
    WalkConstraints constraints{
        .actions = {{.frames = {"kick", {{10, 19}}}, .leastShare = 0.8}, {.frames = {"sit", {{0, 9}}}}},
        .start = FrameSet{"here", {{0, 0}}}};
    try {
        findWalk(material, constraints, {});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::WalkActionImpossible);
        EXPECT_EQ(error.context().values[0].second, "kick");
        EXPECT_EQ(error.context().values[2].second, "50");
    }
    constraints.actions[0].leastShare = 0.5;
    const WalkSolution solution = findWalk(material, constraints, {});
    EXPECT_EQ(solution.walk.spans[1], (WalkSpan{13, 17}));
}

/// Two takes of ten frames with some transitions, all of four frames.
TransitionCosts twoTakes(const std::vector<std::tuple<int, int, float>>& transitions)
{
    const std::vector<std::int64_t> counts{10, 10};
    Table<float> cost = Table<float>::Constant(20, 20, std::numeric_limits<float>::infinity());
    Table<std::uint16_t> length = Table<std::uint16_t>::Zero(20, 20);
    for (const auto& [from, to, value] : transitions) {
        cost(from, to) = value;
        length(from, to) = 4;
    }
    return {cost, length, 1, FrameLayout(counts)};
}

TEST(ActionWalk, PlaysActionsWholeWhereLeavingOutIsDear)
{
    const TransitionCosts costs = twoTakes({{4, 10, 0.2F}, {4, 14, 0.17F}, {17, 2, 1.0F}});
    const Digraph graph = essentialGraph(costs, alpha).graph;
    const WalkMaterial material{.graph = graph, .costs = costs, .alpha = alpha, .motion = {}};
    const WalkConstraints constraints{.actions = {{.frames = {"kick", {{10, 19}}}}},
                                      .start = FrameSet{"here", {{0, 0}}}};
    EXPECT_EQ(findWalk(material, constraints, {}).walk.spans[1].first, 14);
    const WalkSolution whole = findWalk(material, constraints, {.leftOutWeight = 5});
    EXPECT_EQ(whole.walk.spans[1], (WalkSpan{10, 19}));
    EXPECT_TRUE(whole.optimal);
}

TEST(ActionWalk, SaysWhatIsImpossibleTogether)
{
    const TransitionCosts costs = twoTakes({{4, 13, 1.0F}, {17, 2, 1.0F}});
    const Digraph graph = essentialGraph(costs, alpha).graph;
    const WalkMaterial material{.graph = graph, .costs = costs, .alpha = alpha, .motion = {}};
    // Frame 8 is eight frames from the start.
    WalkConstraints constraints{.keys = {{.frame = 8, .time = 3, .tolerance = 0}},
                                .actions = {{.frames = {"kick", {{10, 19}}}}},
                                .start = FrameSet{"here", {{0, 0}}}};
    EXPECT_EQ(codeOf([&] { findWalk(material, constraints, {}); }), ErrorCode::WalkImpossible);
    EXPECT_EQ(codeOf([&] { findWalk(material, constraints, {.budget = 1}); }), ErrorCode::WalkNotFound);
    constraints.keys.front().tolerance.reset();
    EXPECT_NO_THROW(findWalk(material, constraints, {}));
}

TEST(CheckConstraints, RefusesWhatCannotBe)
{
    const WalkWorld world({.seed = 5, .counts = {20, 20}, .missing = 0.3, .shortest = 4});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const PathConstraint path{.points = {{0, 0, 0}, {1, 0, 0}}};
    const auto with = [&](const std::function<void(PathConstraint&)>& change) {
        WalkConstraints constraints{.path = path};
        change(*constraints.path);
        return constraints;
    };
    const Obstacle pillar{.name = "pillar", .outline = {{0.1, 0}}, .radius = 0.2};
    const std::vector<std::pair<WalkConstraints, ErrorCode>> cases{
        {{}, ErrorCode::BadArgument},
        {{.keys = {{50, 0}}}, ErrorCode::BadArgument},
        {{.keys = {{3, nan}}}, ErrorCode::BadArgument},
        {{.keys = {{3, -1}}}, ErrorCode::BadArgument},
        {{.keys = {{3, 9}, {4, 9}}}, ErrorCode::WalkKeyOrder},
        {{.actions = {{.frames = {"dance", {}}}}}, ErrorCode::WalkFramesMissing},
        {{.actions = {{.frames = {"dance", {{18, 22}}}}}}, ErrorCode::BadArgument},
        {{.actions = {{.frames = world.sequence(0), .repetitions = 0}}}, ErrorCode::BadArgument},
        {{.actions = {{.frames = world.sequence(0), .leastShare = nan}}}, ErrorCode::BadArgument},
        {{.keys = {{3, 9}}, .start = FrameSet{"nobody", {}}}, ErrorCode::WalkFramesMissing},
        {with([&](PathConstraint& p) {
             p.points = {{0, 0, 0}, {0, 0, 5}};
         }),
         ErrorCode::WalkPathShort},
        {with([&](PathConstraint& p) { p.points.clear(); }), ErrorCode::WalkPathShort},
        {with([&](PathConstraint& p) { p.points[1].x() = nan; }), ErrorCode::BadArgument},
        {with([&](PathConstraint& p) { p.spans = {{.from = 0.5, .to = 1.2}}; }), ErrorCode::WalkSpanOutside},
        {with([&](PathConstraint& p) { p.spans = {{.from = 0.5, .to = 0.2}}; }), ErrorCode::BadArgument},
        {with([&](PathConstraint& p) {
             p.spans = {{.from = 0.1, .to = 0.5, .duration = 9}, {.from = 0.4, .to = 0.7, .duration = 9}};
         }),
         ErrorCode::BadArgument},
        {with([&](PathConstraint& p) {
             p.spans = {{.to = 0.5, .demanded = FrameSet{"fly", {}}}};
         }),
         ErrorCode::WalkFramesMissing},
        {with([&](PathConstraint& p) { p.obstacles = {pillar}; }), ErrorCode::WalkObstacleAtStart},
        {with([&](PathConstraint& p) {
             p.obstacles = {{.name = "line", .outline = {{5, 0}, {6, 0}}}};
         }),
         ErrorCode::BadArgument},
    };
    for (std::size_t i = 0; i < cases.size(); ++i)
        EXPECT_EQ(codeOf([&] { find(world, cases[i].first, {.budget = 10}); }), cases[i].second) << i;
    for (const SearchSettings& settings :
         {SearchSettings{.beta = nan}, SearchSettings{.mu = -1}, SearchSettings{.budget = 0}})
        EXPECT_EQ(codeOf([&] { find(world, {.path = path}, settings); }), ErrorCode::BadArgument);
    try {
        find(world, with([&](PathConstraint& p) { p.obstacles = {pillar}; }));
    } catch (const Error& error) {
        EXPECT_NEAR(std::stod(error.context().values[1].second), 0.3, 0.011) << "free from there on";
    }
}
