// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/essentialedges.h"
#include "model/graph/essentialgraph.h"
#include "noedge.h"
#include "tests/model/graph/randomtransitions.h"

#include <array>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace quadrille;

namespace {

struct EdgeCase
{
    RandomTransitions random;
    double alpha;
};

class EssentialEdges : public ::testing::TestWithParam<EdgeCase>
{
};

// All weights of these are sums of powers of two, so that ties are exact. Several blocks of sources, blocks
// that end inside a sequence, single frames, frames without transitions, one take.
INSTANTIATE_TEST_SUITE_P(
    Random, EssentialEdges,
    ::testing::Values(
        EdgeCase{{.seed = 1, .counts = {5, 1, 7}}, 0.01},
        EdgeCase{{.seed = 2, .counts = {20, 20}, .missing = 0.5, .levels = 4}, 1.0 / 64},
        EdgeCase{{.seed = 3, .counts = {150}, .missing = 0, .levels = 8, .shortest = 3}, 1.0 / 32},
        EdgeCase{{.seed = 4, .counts = {9, 3, 12, 4}, .missing = 0.9}, 0.2},
        EdgeCase{{.seed = 5, .counts = std::vector<std::int64_t>(70, 1), .levels = 16}, 1.0 / 16},
        EdgeCase{{.seed = 6, .counts = {30, 40, 33}, .missing = 0.1, .levels = 64}, 1.0 / 1024},
        EdgeCase{{.seed = 7, .counts = {10, 10}, .missing = 1}, 0.01},
        EdgeCase{{.seed = 8, .counts = {90, 80}, .missing = 0.05}, 1},
        EdgeCase{{.seed = 9, .counts = {64, 61}, .missing = 0.97}, 0.001}));

} // namespace

TEST_P(EssentialEdges, AreThoseOfThePlainGraph)
{
    const TransitionCosts costs = makeTransitions(GetParam().random);
    EXPECT_EQ(essentialEdges(costs, GetParam().alpha), essentialGraph(costs, GetParam().alpha).graph);
}

/// Without a price of duration, walks may go round in circles for nothing: many edges tie with each other.
TEST_P(EssentialEdges, AreThoseOfThePlainGraphWhereManyTie)
{
    RandomTransitions random = GetParam().random;
    random.levels = 3;
    const TransitionCosts costs = makeTransitions(random);
    for (const double alpha : {0.0, 1e-9, 0.25})
        EXPECT_EQ(essentialEdges(costs, alpha), essentialGraph(costs, alpha).graph) << alpha;
}

TEST_P(EssentialEdges, ThatAreCertainComeFirst)
{
    const TransitionCosts costs = makeTransitions(GetParam().random);
    std::vector<Digraph> certain;
    const Digraph all = essentialEdges(costs, GetParam().alpha, {},
                                       [&](Digraph edges) { certain.push_back(std::move(edges)); });
    EXPECT_EQ(all, essentialEdges(costs, GetParam().alpha));
    ASSERT_EQ(certain.size(), 1U);
    EXPECT_EQ(certain[0].nodeCount(), all.nodeCount());
    EXPECT_EQ(certain[0].count(EdgeKind::Original), all.count(EdgeKind::Original));
    for (const Edge& edge : certain[0].edges()) {
        const Edge* const found = all.find(edge.from, edge.to);
        ASSERT_NE(found, nullptr) << edge.from << " to " << edge.to;
        EXPECT_EQ(*found, edge);
    }
    // Whatever is cheaper than any two transitions can be is certain.
    if (GetParam().random.missing < 0.9) {
        EXPECT_GT(certain[0].count(EdgeKind::Transition), 0);
    }
}

TEST(EssentialEdges, PreferTheLongerWalkOnATie)
{
    // 0 → 2 weighs 1 as 0 → 1 → 2 does, exactly, or nearly; 0 → 3 as 0 → 2 → 3.
    const FrameLayout layout(std::array<std::int64_t, 3>{2, 1, 1});
    for (const float cost : {0.75F, 0.75F - 6e-8F, 0.75F - 2.4e-7F}) {
        Table<float> costs = Table<float>::Constant(4, 4, noEdge);
        costs(1, 2) = 0.25F;
        costs(0, 2) = cost;
        costs(2, 3) = 0.25F;
        costs(0, 3) = 1.5F;
        const TransitionCosts transitions(costs, Table<std::uint16_t>::Constant(4, 4, 1), 1, layout);
        const Digraph graph = essentialEdges(transitions, 0.5);
        EXPECT_EQ(graph.find(0, 2) != nullptr, cost < 0.75F - 1e-7F) << cost;
        EXPECT_EQ(graph.find(0, 3), nullptr) << cost;
    }
}

TEST(EssentialEdges, OfFewFramesAreFew)
{
    EXPECT_EQ(essentialEdges({Table<float>(), Table<std::uint16_t>(), 0, FrameLayout()}, 0.01), Digraph());
    const FrameLayout one(std::array<std::int64_t, 1>{1});
    EXPECT_EQ(essentialEdges({Table<float>::Constant(1, 1, noEdge), Table<std::uint16_t>::Zero(1, 1), 0, one},
                             0.01),
              Digraph(1, {}));
}

TEST(EssentialEdges, DoNotDependOnTheNumberOfThreads)
{
    const TransitionCosts costs = makeTransitions({.counts = {90, 60, 70}, .missing = 0.1});
    const Digraph several = essentialEdges(costs, 0.02);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(essentialEdges(costs, 0.02), several);
}

TEST(EssentialEdges, StopWhenCancelled)
{
    const TransitionCosts costs = makeTransitions({.counts = {90, 60, 70}, .missing = 0.1});
    for (const double when : {0.01, 0.3, 0.8}) {
        CancelToken token;
        const Progress progress(token, [&](double fraction) {
            if (fraction >= when)
                token.cancel();
        });
        EXPECT_THROW(essentialEdges(costs, 0.02, progress), Error) << when;
    }
}

TEST(EssentialEdges, RefuseABadAlpha)
{
    const TransitionCosts costs = makeTransitions({.counts = {5, 5}});
    EXPECT_THROW(essentialEdges(costs, -1), Error);
}
