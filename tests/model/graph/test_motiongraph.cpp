// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/motiongraph.h"
#include "noedge.h"
#include "tests/model/graph/randomtransitions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace quadrille;

namespace {

bool areInOneBlock(const FrameLayout& layout, NodeIndex i, NodeIndex j, NodeIndex a, NodeIndex b)
{
    return layout.sequenceOf(i) == layout.sequenceOf(a) && layout.sequenceOf(j) == layout.sequenceOf(b);
}

/// The cost of (a, b) as a neighbour of (i, j), or the mean around it.
double valueOf(const TransitionCosts& costs, NodeIndex i, NodeIndex j, NodeIndex a, NodeIndex b, int reach)
{
    const NodeIndex frames = costs.layout().frameCount();
    if (a < 0 || b < 0 || a >= frames || b >= frames || !areInOneBlock(costs.layout(), i, j, a, b) ||
        !costs.hasTransition(a, b))
        return unreachable;
    if (reach == 0)
        return costs.cost()(a, b);
    double sum = 0;
    int count = 0;
    for (NodeIndex p = a - reach; p <= a + reach; ++p) {
        for (NodeIndex q = b - reach; q <= b + reach; ++q) {
            const double value = valueOf(costs, a, b, p, q, 0);
            if (value < unreachable) {
                sum += value;
                ++count;
            }
        }
    }
    return static_cast<float>(sum / count);
}

std::vector<FramePair> plainMinima(const TransitionCosts& costs, int reach)
{
    std::vector<FramePair> minima;
    const NodeIndex frames = costs.layout().frameCount();
    for (NodeIndex i = 0; i < frames; ++i) {
        for (NodeIndex j = 0; j < frames; ++j) {
            const double own = valueOf(costs, i, j, i, j, reach);
            bool isMinimum = own < unreachable;
            for (NodeIndex a = i - 1; a <= i + 1; ++a)
                for (NodeIndex b = j - 1; b <= j + 1; ++b)
                    isMinimum &= (a == i && b == j) || own < valueOf(costs, i, j, a, b, reach);
            if (isMinimum)
                minima.push_back({i, j});
        }
    }
    return minima;
}

class Minima : public ::testing::TestWithParam<RandomTransitions>
{
};

INSTANTIATE_TEST_SUITE_P(Random, Minima,
                         ::testing::Values(RandomTransitions{.seed = 1, .counts = {5, 1, 7}},
                                           RandomTransitions{.seed = 2, .counts = {20, 13}, .levels = 6},
                                           RandomTransitions{.seed = 3, .counts = {30}, .missing = 0},
                                           RandomTransitions{.seed = 4, .counts = {8, 8, 8}, .missing = 0.7},
                                           RandomTransitions{.seed = 5, .counts = {4, 4}, .missing = 1}));

} // namespace

TEST_P(Minima, AreThoseOfAPlainScan)
{
    const TransitionCosts costs = makeTransitions(GetParam());
    EXPECT_EQ(costMinima(costs), plainMinima(costs, 0));
    EXPECT_EQ(costMinima(costs, CostSmoothing::Mean3), plainMinima(costs, 1));
    EXPECT_EQ(costMinima(costs, CostSmoothing::Mean5), plainMinima(costs, 2));
}

TEST(CostMinima, OfATableSolvedByHand)
{
    const FrameLayout layout(std::array<std::int64_t, 2>{3, 3});
    Table<float> cost = Table<float>::Constant(6, 6, noEdge);
    // Source frames 0 … 2, destinations 3 … 5: a minimum in a corner, two alike that are none, one at an
    // edge.
    cost.block(0, 3, 3, 3) << 1, 5, 6, //
        4, 7, 2,                       //
        6, 5, 2;
    cost(5, 0) = 8; // alone among infinite cells
    const TransitionCosts costs(cost, Table<std::uint16_t>::Constant(6, 6, 1), 1, layout);
    EXPECT_EQ(costMinima(costs), (std::vector<FramePair>{{0, 3}, {5, 0}}));
}

TEST(CostMinima, DoNotDependOnTheNumberOfThreads)
{
    const TransitionCosts costs = makeTransitions({.counts = {60, 80}});
    const auto several = costMinima(costs, CostSmoothing::Mean5);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(costMinima(costs, CostSmoothing::Mean5), several);
}

TEST(CostMinima, StopWhenCancelled)
{
    CancelToken token;
    token.cancel();
    const TransitionCosts costs = makeTransitions({.counts = {60, 80}});
    EXPECT_THROW(costMinima(costs, CostSmoothing::None, Progress(token)), Error);
}

TEST(MotionGraph, HasOriginalEdgesAndMinima)
{
    const TransitionCosts costs = makeTransitions({.seed = 9, .counts = {6, 1, 8}, .missing = 0.3});
    const auto minima = costMinima(costs);
    const Digraph graph = motionGraph(costs, minima, 0.1);
    const FrameLayout& layout = costs.layout();
    ASSERT_FALSE(minima.empty());
    for (NodeIndex i = 0; i < layout.frameCount(); ++i) {
        for (NodeIndex j = 0; j < layout.frameCount(); ++j) {
            const Edge* const edge = graph.find(i, j);
            const bool isNext = j == i + 1 && layout.sequenceOf(i) == layout.sequenceOf(j);
            const bool isMinimum = std::find(minima.begin(), minima.end(), FramePair{i, j}) != minima.end();
            ASSERT_EQ(edge != nullptr, isNext || isMinimum) << i << " to " << j;
            if (!edge)
                continue;
            EXPECT_EQ(edge->kind, isNext ? EdgeKind::Original : EdgeKind::Transition);
            EXPECT_DOUBLE_EQ(edge->weight, isNext ? 0.1 : costs.weight(i, j, 0.1));
        }
    }
}

TEST(MotionGraph, PutsAnOriginalEdgeInThePlaceOfATransition)
{
    const TransitionCosts costs = makeTransitions({.counts = {4}});
    const std::vector<FramePair> minima{{1, 2}, {1, 3}, {3, 0}};
    const Digraph graph = motionGraph(costs, minima, 0.1);
    EXPECT_EQ(graph.edges().size(), 5U);
    EXPECT_EQ(graph.find(1, 2)->kind, EdgeKind::Original);
    EXPECT_TRUE(graph.find(1, 3)) << "although playing on may be cheaper";
}

TEST(MotionGraph, OfOneFrameHasNoEdges)
{
    const TransitionCosts costs = makeTransitions({.counts = {1}});
    EXPECT_EQ(motionGraph(costs, costMinima(costs), 0.1), Digraph(1, {}));
}

TEST(MotionGraph, RefusesAnAlphaBelowZero)
{
    const TransitionCosts costs = makeTransitions({.counts = {4}});
    EXPECT_THROW(motionGraph(costs, {}, -0.1), Error);
}
