// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/alternatives.h"
#include "model/graph/gaps.h"
#include "model/graph/motiongraph.h"
#include "noedge.h"
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// Two sequences of four frames.
struct TwoTakes
{
    TwoTakes()
    {
        cost.setConstant(noEdge);
        length.setZero();
        distances.setConstant(9);
    }
    void add(NodeIndex from, NodeIndex to, float value)
    {
        cost(from, to) = value;
        length(from, to) = 2;
    }
    TransitionCosts costs() const { return {cost, length, 1.0, layout}; }

    FrameLayout layout{std::vector<std::int64_t>{4, 4}};
    Table<float> cost{8, 8};
    Table<std::uint16_t> length{8, 8};
    Table<float> distances{8, 8};
};

} // namespace

TEST(Gaps, NamesWhatWouldCloseThem)
{
    TwoTakes takes;
    takes.add(2, 0, 0.25F); // in the graph: the first take comes back to itself
    takes.add(5, 1, 0.75F); // lacking, and dearer than the next
    takes.add(6, 1, 0.5F);
    takes.distances(1, 4) = 3;
    takes.distances(3, 1) = 2;
    takes.distances(7, 0) = 1;
    const TransitionCosts costs = takes.costs();
    const std::vector<FramePair> kept{{2, 0}};
    const Digraph graph = motionGraph(costs, kept, 0.01);
    const auto gaps = findGaps(graph, connectivity(graph), costs, takes.distances, 0.01);
    ASSERT_EQ(gaps.size(), 3U);
    // No transition leads into the second take: only a new take can.
    EXPECT_EQ(gaps[0], (GraphGap{.kind = GraphGap::Kind::Unreachable,
                                 .first = 4,
                                 .last = 7,
                                 .transition = {},
                                 .weight = 0,
                                 .take = FramePair{1, 4},
                                 .distance = 3}));
    EXPECT_EQ(gaps[1], (GraphGap{.kind = GraphGap::Kind::DeadEnd,
                                 .first = 3,
                                 .last = 3,
                                 .transition = {},
                                 .weight = 0,
                                 .take = FramePair{3, 1},
                                 .distance = 2}));
    EXPECT_EQ(gaps[2], (GraphGap{.kind = GraphGap::Kind::DeadEnd,
                                 .first = 4,
                                 .last = 7,
                                 .transition = FramePair{6, 1},
                                 .weight = 0.5 + 0.01 * 2,
                                 .take = FramePair{7, 0},
                                 .distance = 1}));
}

TEST(Gaps, AreClosedByWhatLeadsBackWhereNothingDoes)
{
    TwoTakes takes;
    takes.add(1, 3, 0.125F); // leads on, not back
    takes.add(3, 0, 0.5F);
    takes.add(2, 5, 0.25F);
    const TransitionCosts costs = takes.costs();
    const Digraph graph = motionGraph(costs, {}, 0);
    const auto gaps = findGaps(graph, connectivity(graph), costs, takes.distances, 0);
    ASSERT_EQ(gaps.size(), 4U);
    EXPECT_EQ(gaps[2].kind, GraphGap::Kind::DeadEnd);
    EXPECT_EQ(gaps[2].transition, (FramePair{2, 5}));
    EXPECT_EQ(gaps[1].transition, (FramePair{2, 5})); // into the second take
    EXPECT_EQ(gaps[3].transition, std::nullopt);
}

TEST(Gaps, AreNoneInAGraphThatComesBackEverywhere)
{
    TwoTakes takes;
    takes.add(3, 4, 0.5F);
    takes.add(7, 0, 0.5F);
    const TransitionCosts costs = takes.costs();
    const std::vector<FramePair> all{{3, 4}, {7, 0}};
    const Digraph graph = motionGraph(costs, all, 0.01);
    EXPECT_TRUE(findGaps(graph, connectivity(graph), costs, takes.distances, 0.01).empty());
}

TEST(Alternatives, AreTheCheapestThatDiffer)
{
    TwoTakes takes;
    takes.add(1, 6, 0.25F);  // the one that is there
    takes.add(1, 7, 0.125F); // like it
    takes.add(2, 4, 0.5F);
    takes.add(1, 4, 0.375F); // like the one above, and cheaper
    takes.add(3, 0, 0.75F);
    takes.add(0, 3, 0.3F); // dearer than playing on
    takes.add(6, 0, 0.0F); // leaves the other sequence
    const TransitionCosts costs = takes.costs();
    const auto near = alternatives(costs, 0.01, {1, 6}, {.reach = 2, .apart = 2, .most = 10});
    EXPECT_EQ(near, (std::vector<FramePair>{{1, 4}, {3, 0}}));
    EXPECT_EQ(alternatives(costs, 0.01, {1, 6}, {.reach = 1, .apart = 2, .most = 10}),
              (std::vector<FramePair>{{1, 4}}));
    EXPECT_EQ(alternatives(costs, 0.01, {1, 6}, {.reach = 2, .apart = 2, .most = 1}),
              (std::vector<FramePair>{{1, 4}}));
}

TEST(Alternatives, ComeInTheOrderOfTheirWeights)
{
    const TransitionCosts costs = makeTransitions({.seed = 4, .counts = {30, 40}, .missing = 0.1});
    const auto found = alternatives(costs, 0.05, {10, 50});
    ASSERT_EQ(found.size(), 10U);
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
        EXPECT_LE(costs.weight(found[i].source, found[i].destination, 0.05),
                  costs.weight(found[i + 1].source, found[i + 1].destination, 0.05));
}
