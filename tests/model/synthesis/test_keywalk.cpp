// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/essentialgraph.h"
#include "model/synthesis/walks/findwalk.h"
#include "model/synthesis/walks/keywalk.h"
#include "tests/model/codeof.h"
#include "tests/model/graph/randomtransitions.h"
#include "tests/model/synthesis/walkreference.h"
#include "walkworld.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace quadrille {
using namespace test;

namespace {

using test::codeOf;

constexpr double alpha = 0.05;

WalkGraph randomWalks(std::uint32_t seed, std::vector<std::int64_t> counts = {4, 3}, double missing = 0.75)
{
    const TransitionCosts costs =
        makeTransitions({.seed = seed, .counts = std::move(counts), .missing = missing, .shortest = 2});
    return WalkGraph(essentialGraph(costs, alpha).graph, costs, alpha, {});
}

std::vector<NodeIndex> allNodes(const WalkGraph& graph)
{
    std::vector<NodeIndex> nodes(static_cast<std::size_t>(graph.nodeCount()));
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
}

std::int64_t elapsed(const WalkGraph& graph, const WalkRoute& route)
{
    std::int64_t sum = 0;
    NodeIndex node = route.start;
    for (const MoveIndex index : route.moves) {
        EXPECT_EQ(graph.move(index).from, node);
        node = graph.move(index).to;
        sum += graph.move(index).elapsed;
    }
    return sum;
}

TEST(KeyWalk, IsTheCheapestOfAllWalksBetweenEachPair)
{
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        const WalkGraph graph = randomWalks(seed);
        const std::vector<PoseKey> keys{{2, 3}, {5, 9}, {1, 13.5}};
        for (const double beta : {0.0, 0.02, alpha, 0.4}) {
            KeyWalk walk;
            try {
                walk = walkFromKeyToKey(graph, allNodes(graph), keys, beta, 100'000);
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::WalkKeyUnreachable);
                continue;
            }
            double expected = 0;
            double time = 0;
            for (std::size_t k = 0; k < keys.size(); ++k) {
                expected += exhaustiveLeg(graph, k == 0 ? allNodes(graph) : std::vector{keys[k - 1].frame},
                                          keys[k].frame, keys[k].time - time, k == 0, beta, 12);
                time = static_cast<double>(walk.times[k]);
            }
            EXPECT_NEAR(walk.edges + walk.timing, expected, 1e-12) << seed << ", " << beta;
            EXPECT_TRUE(walk.optimal);
            EXPECT_EQ(elapsed(graph, walk.route), walk.times.back());
        }
    }
}

TEST(KeyWalk, IsTheCheapestOverAllKeys)
{
    int better = 0;
    int tight = 0;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const WalkGraph graph = randomWalks(seed, {4, 3}, 0.8);
        const std::vector<PoseKey> keys{{2, 1}, {5, 5}, {1, 8.5}};
        for (const double beta : {0.02, alpha, 0.4}) {
            try {
                const KeyWalk pairs = walkFromKeyToKey(graph, {2}, keys, beta, 100'000);
                const KeyWalk all = walkOverAllKeys(graph, {2}, keys, beta, 100'000);
                const double expected = exhaustiveOverAllKeys(graph, {2}, keys, beta, 9);
                EXPECT_NEAR(all.edges + all.timing, expected, 1e-12) << seed << ", " << beta;
                EXPECT_TRUE(all.optimal);
                EXPECT_NEAR(all.bound, expected, 1e-12);
                EXPECT_LE(pairs.bound, expected + 1e-12) << "walks from key to key cost no less";
                tight += pairs.bound > 0.5 * expected ? 1 : 0;
                EXPECT_EQ(elapsed(graph, all.route), all.times.back());
                better += all.edges + all.timing < pairs.edges + pairs.timing - 1e-9 ? 1 : 0;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::WalkKeyUnreachable);
            }
        }
    }
    EXPECT_GT(better, 0) << "no case tells the two apart";
    EXPECT_GT(tight, 5) << "bounds are not far below";
}

TEST(KeyWalk, ReturnsToTheSamePose)
{
    const WalkGraph graph = randomWalks(3, {5, 5}, 0.3);
    const KeyWalk walk = walkFromKeyToKey(graph, {3}, {{3, 0}, {3, 6}}, alpha, 100'000);
    EXPECT_EQ(walk.times.front(), 0);
    EXPECT_GT(walk.times.back(), 0);
    EXPECT_NEAR(walk.edges + walk.timing, exhaustiveLeg(graph, {3}, 3, 6, false, alpha, 9), 1e-12);
}

TEST(KeyWalk, KeepsToTolerancesOrSaysWhenItCould)
{
    const WalkGraph graph = randomWalks(5, {6, 6}, 0.6);
    bool isKept = false;
    bool isRefused = false;
    for (int time = 1; time < 12; ++time) {
        const std::vector<PoseKey> keys{{2, 0}, {8, static_cast<double>(time), 0.5}};
        try {
            const KeyWalk walk = walkFromKeyToKey(graph, {2}, keys, alpha, 100'000);
            EXPECT_EQ(walk.times.back(), time);
            isKept = true;
        } catch (const Error& error) {
            ASSERT_EQ(error.code(), ErrorCode::WalkKeyUntimely);
            EXPECT_EQ(error.context().values[0].second, "2");
            const double nearest = std::stod(error.context().values[3].second);
            EXPECT_GT(std::abs(nearest - time), 0.5);
            // It can be met at that time.
            EXPECT_NO_THROW(walkFromKeyToKey(graph, {2}, {{2, 0}, {8, nearest, 0.5}}, alpha, 100'000));
            isRefused = true;
        }
    }
    EXPECT_TRUE(isKept);
    EXPECT_TRUE(isRefused);
}

TEST(KeyWalk, SaysWhichFrameCanBeReachedInstead)
{
    // No transition enters the second sequence before its third frame.
    const std::vector<std::int64_t> counts{5, 5};
    Table<float> cost = Table<float>::Constant(10, 10, std::numeric_limits<float>::infinity());
    Table<std::uint16_t> length = Table<std::uint16_t>::Zero(10, 10);
    cost(1, 7) = 1;
    length(1, 7) = 3;
    const TransitionCosts costs(cost, length, 1, FrameLayout(counts));
    const WalkGraph graph(essentialGraph(costs, alpha).graph, costs, alpha, {});
    try {
        walkFromKeyToKey(graph, {0}, {{0, 0}, {6, 4}}, alpha, 1000);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::WalkKeyUnreachable);
        EXPECT_EQ(error.context().values[2].second, "7");
    }
    const auto back = [&] { walkFromKeyToKey(graph, {0}, {{0, 0}, {0, 4}}, alpha, 1000); };
    EXPECT_EQ(codeOf(back), ErrorCode::WalkKeyUnreachable) << "no walk comes back to its beginning";
}

TEST(KeyWalk, FindsSomethingWithoutABudget)
{
    const WalkGraph graph = randomWalks(7, {30, 30}, 0.3);
    const std::vector<PoseKey> keys{{9, 0}, {50, 40}, {12, 90}};
    const KeyWalk quick = walkFromKeyToKey(graph, allNodes(graph), keys, alpha, 1);
    const KeyWalk best = walkFromKeyToKey(graph, allNodes(graph), keys, alpha, 1'000'000);
    EXPECT_FALSE(quick.optimal);
    EXPECT_EQ(quick.times.size(), 3U);
    EXPECT_GT(quick.bound, 0);
    EXPECT_LE(quick.bound, best.edges + best.timing);
    const KeyWalk quickOverAll = walkOverAllKeys(graph, allNodes(graph), keys, alpha, 1);
    const KeyWalk bestOverAll = walkOverAllKeys(graph, allNodes(graph), keys, alpha, 1'000'000);
    EXPECT_FALSE(quickOverAll.optimal);
    EXPECT_GT(quickOverAll.bound, 0);
    EXPECT_LE(quickOverAll.bound, bestOverAll.edges + bestOverAll.timing + 1e-12);
    EXPECT_TRUE(best.optimal);
    EXPECT_LE(best.expansions, 1'000'000);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(
        codeOf([&] { walkFromKeyToKey(graph, allNodes(graph), keys, alpha, 1'000'000, Progress(token)); }),
        ErrorCode::Cancelled);
}

TEST(WalkGraph, LeavesOutBannedTransitionsAndHasRequiredOnes)
{
    const TransitionCosts costs = makeTransitions({.counts = {6, 6}, .missing = 0.2, .shortest = 2});
    const Digraph digraph = essentialGraph(costs, alpha).graph;
    FramePair inGraph;
    FramePair outside;
    for (NodeIndex i = 0; i < 12; ++i) {
        for (NodeIndex j = 0; j < 12; ++j) {
            const Edge* edge = digraph.find(i, j);
            if (edge && edge->kind == EdgeKind::Transition)
                inGraph = {i, j};
            else if (!edge && costs.hasTransition(i, j))
                outside = {i, j};
        }
    }
    const WalkGraph graph(digraph, costs, alpha, {.banned = {inGraph}, .required = {outside}});
    const auto count = [&](const FramePair& pair) {
        return std::count_if(graph.moves().begin(), graph.moves().end(), [&](const WalkMove& move) {
            return move.from == pair.source && move.to == pair.destination &&
                   (move.required == 0) == (pair == outside);
        });
    };
    EXPECT_EQ(count(inGraph), 0);
    EXPECT_EQ(count(outside), 1);
    EXPECT_EQ(graph.moves().size(), digraph.edges().size());
    const auto both = [&] { WalkGraph(digraph, costs, alpha, {.banned = {outside}, .required = {outside}}); };
    EXPECT_EQ(codeOf(both), ErrorCode::BadArgument);
    const auto unknown = [&] { WalkGraph(digraph, costs, alpha, {.required = {{3, 99}}}); };
    EXPECT_EQ(codeOf(unknown), ErrorCode::BadArgument);
    const auto negative = [&] { WalkGraph(digraph, costs, -1, {}); };
    EXPECT_EQ(codeOf(negative), ErrorCode::BadArgument);
}

/// Captured frames that runs of a walk lack before its transitions, and before its end what the way into the
/// last take allows.
int shortfallOf(const WalkGraph& graph, const Walk& walk, int leastRun)
{
    const NodeIndex end = walk.spans.back().last;
    int lastRun = 0;
    for (const WalkMove& move : graph.moves()) {
        if (move.kind == EdgeKind::Transition && move.to <= end &&
            graph.layout().sequenceOf(move.to) == graph.layout().sequenceOf(end))
            lastRun = std::max(lastRun, end - move.to + 1);
    }
    int shortfall = std::max(0, std::min(lastRun, leastRun) - walk.spans.back().frameCount());
    for (std::size_t i = 0; i + 1 < walk.spans.size(); ++i)
        shortfall += std::max(0, leastRun - walk.spans[i].frameCount());
    return shortfall;
}

TEST(KeyWalk, WeighsStayingInATakeAgainstBeingOnTime)
{
    constexpr int leastRun = 3;
    constexpr double beta = 0.05;
    constexpr std::int32_t longest = 24; // output frames; longer walks are too late to be the cheapest
    int hasty = 0;
    int calmer = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const WalkWorld world({.seed = seed, .counts = {9, 8, 9}, .missing = 0.6, .shortest = 4});
        const WalkMaterial material = world.material();
        const PoseKey first{.frame = 1, .time = 0};
        const PoseKey last{.frame = seed % 2 == 0 ? 20 : 22, .time = 10};
        const WalkConstraints constraints{.keys = {first, last}, .start = FrameSet{"first", {{1, 1}}}};
        const WalkGraph graph(world.graph, world.costs, WalkWorld::alpha, {});
        const WalkSolution free = findWalk(material, constraints, {.beta = beta});
        const WalkSolution calm = findWalk(material, constraints, {.beta = beta, .leastRun = leastRun});
        double least = unreachable;
        test::everyWalk(graph, first.frame, longest,
                        [&](const WalkRoute& route, std::int32_t elapsed, double cost) {
                            const Walk walk = graph.walk(route);
                            if (walk.spans.back().last == last.frame)
                                least = std::min(least, cost + beta * (std::abs(elapsed - last.time) +
                                                                       shortfallOf(graph, walk, leastRun)));
                        });
        EXPECT_NEAR(calm.totalCost, least, 1e-9) << seed;
        EXPECT_EQ(calm.walk.spans.back().last, last.frame) << "it ends at the last key";
        const int before = shortfallOf(graph, free.walk, leastRun);
        hasty += before > 0;
        calmer += shortfallOf(graph, calm.walk, leastRun) < before;
    }
    EXPECT_GT(hasty, 10) << "or this shows nothing";
    EXPECT_GT(calmer, 3);
}

TEST(KeyWalk, EndsAtTheLastKeyWithATransitionThatIsRequired)
{
    // The ways from there into the last take leave no room for a whole run before the key.
    const WalkWorld world({.seed = 2, .counts = {9, 8, 9}, .missing = 0.6, .shortest = 4});
    const WalkMaterial material = world.material();
    const WalkGraph graph(world.graph, world.costs, WalkWorld::alpha, {});
    const NodeIndex last = 22;
    int walks = 0;
    for (const WalkMove& move : graph.moves()) {
        if (move.kind != EdgeKind::Transition || move.from > 8 || move.to < 9 || move.to > 16)
            continue;
        WalkConstraints constraints{.keys = {{.frame = 0, .time = 0}, {.frame = last, .time = 12}}};
        constraints.junctions.required = {{move.from, move.to}};
        const Walk walk = findWalk(material, constraints, {.leastRun = 6}).walk;
        EXPECT_EQ(walk.spans.back().last, last);
        ++walks;
    }
    EXPECT_GT(walks, 0);
}

} // namespace
} // namespace quadrille
