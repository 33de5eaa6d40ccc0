// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/shortestpath.h"
#include "model/graph/statistics.h"
#include "tests/model/graph/randomtransitions.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;

TEST(PathCostSummary, CountsReachablePairsOnly)
{
    Table<double> costs = Table<double>::Constant(3, 3, unreachable);
    costs.matrix().diagonal().setZero();
    costs(0, 1) = 1;
    costs(1, 2) = 2;
    costs(0, 2) = 6;
    const PathCostSummary summary = summarizePathCosts(costs);
    EXPECT_EQ(summary.reachablePairs, 3);
    EXPECT_EQ(summary.unreachablePairs, 3);
    EXPECT_DOUBLE_EQ(summary.mean, 3);
    EXPECT_DOUBLE_EQ(summary.standardDeviation, std::sqrt(14.0 / 3));
}

TEST(PathCostSummary, OfNothingIsZero)
{
    EXPECT_EQ(summarizePathCosts(Table<double>(0, 0)), PathCostSummary());
    EXPECT_EQ(summarizePathCosts(Table<double>::Zero(1, 1)), PathCostSummary());
    const PathCostSummary apart = summarizePathCosts(Table<double>::Constant(2, 2, unreachable));
    EXPECT_EQ(apart.mean, 0);
    EXPECT_EQ(apart.unreachablePairs, 2);
}

TEST(GraphStatistics, DescribeAGraph)
{
    const Digraph graph(4, {{0, 1, 1, EdgeKind::Original}, {1, 0, 2}, {1, 2, 3}});
    const GraphStatistics statistics = graphStatistics(graph, shortestPathCosts(graph));
    EXPECT_EQ(statistics.nodes, 4);
    EXPECT_EQ(statistics.edges, 3);
    EXPECT_EQ(statistics.transitions, 2);
    EXPECT_DOUBLE_EQ(statistics.density, 0.25);
    EXPECT_EQ(statistics.pathCosts.reachablePairs, 4);
    EXPECT_DOUBLE_EQ(statistics.pathCosts.mean, (1 + 2 + 3 + 4) / 4.0);
    EXPECT_EQ(statistics.connectivity.components.size(), 3U);
    EXPECT_EQ(statistics.connectivity.unreachable, (std::vector<NodeIndex>{3}));
    EXPECT_EQ(statistics.connectivity.deadEnds, (std::vector<NodeIndex>{2, 3}));
}
