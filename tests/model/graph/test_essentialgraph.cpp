// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/essentialgraph.h"
#include "noedge.h"
#include "tests/model/graph/randomtransitions.h"

#include <array>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace quadrille;

namespace {

constexpr double tie = 1e-7;

/// Sequences of two frames, with given transitions that weigh their cost alone (α is 0.01, L 1, so 0.01
/// more).
TransitionCosts pairsOfFrames(int sequences, const std::vector<Edge>& transitions)
{
    const std::vector<std::int64_t> counts(static_cast<std::size_t>(sequences), 2);
    Table<float> cost = Table<float>::Constant(sequences * 2, sequences * 2, noEdge);
    Table<std::uint16_t> length = Table<std::uint16_t>::Zero(sequences * 2, sequences * 2);
    for (const Edge& edge : transitions) {
        cost(edge.from, edge.to) = static_cast<float>(edge.weight);
        length(edge.from, edge.to) = 1;
    }
    return {cost, length, 1, FrameLayout(counts)};
}

void expectSameDistances(const Table<double>& given, const Table<double>& expected)
{
    // Each tie may add 1e-7 of a walk, and they may add up.
    constexpr double tolerance = 1e-6;
    ASSERT_EQ(given.rows(), expected.rows());
    for (Eigen::Index i = 0; i < given.rows(); ++i) {
        for (Eigen::Index j = 0; j < given.cols(); ++j) {
            if (expected(i, j) == unreachable) {
                EXPECT_EQ(given(i, j), unreachable) << i << " to " << j;
            } else {
                EXPECT_NEAR(given(i, j), expected(i, j), tolerance * (1 + expected(i, j)))
                    << i << " to " << j;
            }
        }
    }
}

bool isReplaceable(const Table<double>& weights, NodeIndex from, NodeIndex to)
{
    return bellmanFord(weights, from, to)[static_cast<std::size_t>(to)] <= weights(from, to) * (1 + tie);
}

/// Every edge is there exactly if no other walk is as cheap.
void expectEssential(const Digraph& graph, const Table<double>& complete)
{
    for (NodeIndex i = 0; i < graph.nodeCount(); ++i) {
        for (NodeIndex j = 0; j < graph.nodeCount(); ++j) {
            if (i == j)
                continue;
            const Edge* const edge = graph.find(i, j);
            const bool expected = complete(i, j) < unreachable && !isReplaceable(complete, i, j);
            ASSERT_EQ(edge != nullptr, expected) << i << " to " << j;
            if (edge) {
                EXPECT_EQ(edge->weight, complete(i, j));
            }
        }
    }
}

struct Case
{
    RandomTransitions random;
    double alpha;
};

class Essential : public ::testing::TestWithParam<Case>
{
};

// All weights of these are sums of powers of two, so that ties are exact.
INSTANTIATE_TEST_SUITE_P(
    Random, Essential,
    ::testing::Values(Case{{.seed = 1, .counts = {5, 1, 7}}, 0.01},
                      Case{{.seed = 2, .counts = {20, 20}, .missing = 0.5, .levels = 4}, 1.0 / 64},
                      Case{{.seed = 3, .counts = {40}, .missing = 0, .levels = 8, .shortest = 3}, 1.0 / 32},
                      Case{{.seed = 4, .counts = {9, 3, 12, 4}, .missing = 0.9}, 0.2},
                      Case{{.seed = 5, .counts = std::vector<std::int64_t>(30, 1), .levels = 16}, 1.0 / 16},
                      Case{{.seed = 6, .counts = {30, 40}, .missing = 0.1, .levels = 64}, 1.0 / 1024},
                      Case{{.seed = 7, .counts = {10, 10}, .missing = 1}, 0.01},
                      Case{{.seed = 8, .counts = {25, 25}, .missing = 0.05}, 1}));

} // namespace

TEST_P(Essential, HasTheEdgesThatNoOtherWalkReplaces)
{
    const TransitionCosts costs = makeTransitions(GetParam().random);
    const EssentialGraph essential = essentialGraph(costs, GetParam().alpha);
    const Table<double> complete = completeWeights(costs, GetParam().alpha);
    expectEssential(essential.graph, complete);
}

TEST_P(Essential, KeepsAllDistances)
{
    const TransitionCosts costs = makeTransitions(GetParam().random);
    const EssentialGraph essential = essentialGraph(costs, GetParam().alpha);
    const Table<double> expected = plainPathCosts(completeWeights(costs, GetParam().alpha));
    expectSameDistances(essential.pathCosts, expected);
    expectSameDistances(plainPathCosts(weightTable(essential.graph)), expected);
}

TEST_P(Essential, KeepsAllOriginalEdges)
{
    const TransitionCosts costs = makeTransitions(GetParam().random);
    const Digraph graph = essentialGraph(costs, GetParam().alpha).graph;
    EXPECT_EQ(graph.count(EdgeKind::Original), costs.layout().frameCount() - costs.layout().sequenceCount());
}

/// Without a price of duration, walks may go round in circles for nothing: many edges tie with each other.
TEST_P(Essential, KeepsDistancesWithNothingToSpareAtAlphaZero)
{
    RandomTransitions random = GetParam().random;
    random.levels = 3;
    const TransitionCosts costs = makeTransitions(random);
    const EssentialGraph essential = essentialGraph(costs, 0);
    const Table<double> complete = completeWeights(costs, 0);
    expectSameDistances(plainPathCosts(weightTable(essential.graph)), plainPathCosts(complete));
    expectSameDistances(essential.pathCosts, plainPathCosts(complete));
    const Table<double> weights = weightTable(essential.graph);
    for (const Edge& edge : essential.graph.edges()) {
        if (edge.kind == EdgeKind::Transition) {
            EXPECT_FALSE(isReplaceable(weights, edge.from, edge.to)) << edge.from << " to " << edge.to;
        }
    }
}

TEST_P(Essential, KeepsDistancesAtATinyAlpha)
{
    RandomTransitions random = GetParam().random;
    random.levels = 3;
    const TransitionCosts costs = makeTransitions(random);
    const EssentialGraph essential = essentialGraph(costs, 1e-9);
    expectSameDistances(plainPathCosts(weightTable(essential.graph)),
                        plainPathCosts(completeWeights(costs, 1e-9)));
}

TEST(EssentialGraph, OfThreeSequencesSolvedByHand)
{
    // Frames 0 1 | 2 3 | 4 5. Weights: D + 0.01.
    const TransitionCosts costs = pairsOfFrames(3, {{1, 2, 0.5},  // stays: the only way from 1 to 2
                                                    {1, 3, 0.6},  // goes: 1 → 2 → 3 weighs 0.52
                                                    {0, 3, 0.4},  // stays: 0 → 1 → 2 → 3 weighs 0.53
                                                    {3, 4, 0.3},  // stays
                                                    {0, 5, 0.75}, // goes: 0 → 3 → 4 → 5 weighs 0.73
                                                    {5, 0, 0.2}});
    const EssentialGraph essential = essentialGraph(costs, 0.01);
    const auto weight = [&](NodeIndex i, NodeIndex j) { return costs.weight(i, j, 0.01); };
    const std::vector<Edge> expected{{0, 1, 0.01, EdgeKind::Original},
                                     {0, 3, weight(0, 3)},
                                     {1, 2, weight(1, 2)},
                                     {2, 3, 0.01, EdgeKind::Original},
                                     {3, 4, weight(3, 4)},
                                     {4, 5, 0.01, EdgeKind::Original},
                                     {5, 0, weight(5, 0)}};
    EXPECT_EQ(essential.graph, Digraph(6, expected));
    EXPECT_NEAR(essential.pathCosts(0, 5), 0.41 + 0.31 + 0.01, 1e-7); // costs are in single precision
    EXPECT_NEAR(essential.pathCosts(1, 0), 0.51 + 0.01 + 0.31 + 0.01 + 0.21, 1e-7);
    EXPECT_EQ(essential.pathCosts(3, 3), 0);
}

TEST(EssentialGraph, PrefersTheLongerWalkOnATie)
{
    // 0 → 2 weighs 1 as 0 → 1 → 2 does, exactly, or nearly.
    const auto hasShortcut = [](float cost) {
        const FrameLayout layout(std::array<std::int64_t, 3>{2, 1, 1});
        Table<float> costs = Table<float>::Constant(4, 4, noEdge);
        costs(1, 2) = 0.25F;
        costs(0, 2) = cost;
        const Table<std::uint16_t> lengths = Table<std::uint16_t>::Constant(4, 4, 1);
        return essentialGraph({costs, lengths, 1, layout}, 0.5).graph.find(0, 2) != nullptr;
    };
    EXPECT_FALSE(hasShortcut(0.75F)) << "the same";
    EXPECT_FALSE(hasShortcut(0.75F - 6e-8F)) << "cheaper by less than 1e-7";
    EXPECT_TRUE(hasShortcut(0.75F - 2.4e-7F)) << "cheaper by more than 1e-7";
}

TEST(EssentialGraph, PrefersAnOriginalEdgeToATransition)
{
    const FrameLayout layout(std::array<std::int64_t, 1>{2});
    const Table<float> costs = Table<float>::Zero(2, 2);
    const Table<std::uint16_t> lengths = Table<std::uint16_t>::Constant(2, 2, 1);
    const Digraph graph = essentialGraph({costs, lengths, 0, layout}, 0.5).graph;
    ASSERT_EQ(graph.edges().size(), 2U);
    EXPECT_EQ(graph.edges()[0].kind, EdgeKind::Original);
    EXPECT_EQ(graph.edges()[1].kind, EdgeKind::Transition);
}

TEST(EssentialGraph, OfOneFrameHasNoEdges)
{
    const FrameLayout layout(std::array<std::int64_t, 1>{1});
    const EssentialGraph essential = essentialGraph(
        {Table<float>::Constant(1, 1, noEdge), Table<std::uint16_t>::Zero(1, 1), 0, layout}, 0.01);
    EXPECT_EQ(essential.graph, Digraph(1, {}));
    EXPECT_EQ(essential.pathCosts(0, 0), 0);
}

TEST(EssentialGraph, OfNoFramesIsEmpty)
{
    EXPECT_EQ(essentialGraph({{}, {}, 0, {}}, 0.01).graph, Digraph());
}

TEST(EssentialGraph, OfASequenceWithoutTransitionsIsTheSequence)
{
    const TransitionCosts costs = makeTransitions({.counts = {6}, .missing = 1});
    const EssentialGraph essential = essentialGraph(costs, 0.25);
    EXPECT_EQ(essential.graph.edges().size(), 5U);
    EXPECT_EQ(essential.pathCosts(1, 4), 0.75);
    EXPECT_EQ(essential.pathCosts(4, 1), unreachable);
}

/// The order of the sequences does not matter.
TEST(EssentialGraph, FollowsARenumberingOfSequences)
{
    const TransitionCosts costs = makeTransitions({.seed = 11, .counts = {6, 9}});
    const FrameLayout swapped(std::array<std::int64_t, 2>{9, 6});
    const auto moved = [](NodeIndex i) { return i < 6 ? i + 9 : i - 6; };
    Table<float> cost(15, 15);
    Table<std::uint16_t> length(15, 15);
    for (NodeIndex i = 0; i < 15; ++i) {
        for (NodeIndex j = 0; j < 15; ++j) {
            cost(moved(i), moved(j)) = costs.cost()(i, j);
            length(moved(i), moved(j)) = costs.length()(i, j);
        }
    }
    const Digraph graph = essentialGraph(costs, 0.03).graph;
    const Digraph other = essentialGraph({cost, length, 0.5, swapped}, 0.03).graph;
    ASSERT_EQ(graph.edges().size(), other.edges().size());
    for (const Edge& edge : graph.edges())
        EXPECT_TRUE(other.find(moved(edge.from), moved(edge.to))) << edge.from << " to " << edge.to;
}

TEST(EssentialGraph, DoesNotDependOnTheNumberOfThreads)
{
    const TransitionCosts costs = makeTransitions({.counts = {90, 60, 70}, .missing = 0.1});
    const EssentialGraph several = essentialGraph(costs, 0.02);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const EssentialGraph single = essentialGraph(costs, 0.02);
    EXPECT_EQ(single.graph, several.graph);
    EXPECT_TRUE((single.pathCosts == several.pathCosts).all());
}

TEST(EssentialGraph, StopsWhenCancelledAmongTies)
{
    const TransitionCosts costs = makeTransitions({.counts = {40, 40}, .missing = 0.1, .levels = 2});
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.95 && fraction < 1)
            token.cancel();
    });
    EXPECT_THROW(essentialGraph(costs, 0, progress), Error);
}
