// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/shortestpath.h"
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>

using namespace quadrille;

TEST(ShortestPath, CostsWhatBellmanFordFinds)
{
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        constexpr NodeIndex nodes = 20;
        const Digraph graph = randomDigraph(seed, nodes, 0.05 + 0.01 * seed, seed % 2 ? 4 : 0);
        const Table<double> weights = weightTable(graph);
        const Table<double> costs = shortestPathCosts(graph);
        for (NodeIndex i = 0; i < nodes; ++i) {
            const auto expected = bellmanFord(weights, i, i);
            for (NodeIndex j = 0; j < nodes; ++j) {
                const double cost = expected[static_cast<std::size_t>(j)];
                const auto path = shortestPath(graph, i, j);
                ASSERT_EQ(path.has_value(), cost < unreachable) << i << " to " << j;
                if (!path) {
                    EXPECT_EQ(costs(i, j), unreachable);
                    continue;
                }
                // The same few numbers added in another order.
                EXPECT_NEAR(path->cost, cost, 1e-12) << i << " to " << j;
                EXPECT_NEAR(costs(i, j), cost, 1e-12) << i << " to " << j;
            }
        }
    }
}

TEST(ShortestPath, IsAWalkAlongEdgesOfTheGraph)
{
    const Digraph graph = randomDigraph(5, 60, 0.05, 0);
    const auto path = shortestPath(graph, 3, 50);
    ASSERT_TRUE(path);
    NodeIndex at = 3;
    double cost = 0;
    for (const Edge& edge : path->edges) {
        EXPECT_EQ(edge.from, at);
        ASSERT_TRUE(graph.find(edge.from, edge.to));
        EXPECT_EQ(*graph.find(edge.from, edge.to), edge);
        at = edge.to;
        cost += edge.weight;
    }
    EXPECT_EQ(at, 50);
    EXPECT_DOUBLE_EQ(cost, path->cost);
}

TEST(ShortestPath, SolvedByHand)
{
    const Digraph graph(4, {{0, 1, 1}, {0, 2, 5}, {1, 2, 3}, {2, 0, 1}});
    const auto path = shortestPath(graph, 0, 2);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->edges, (std::vector<Edge>{{0, 1, 1}, {1, 2, 3}}));
    EXPECT_EQ(path->cost, 4);
    EXPECT_FALSE(shortestPath(graph, 0, 3));
    EXPECT_TRUE(shortestPath(graph, 3, 3)->edges.empty());
    EXPECT_EQ(shortestPath(graph, 3, 3)->cost, 0);
    EXPECT_EQ(shortestPathCosts(graph)(0, 0), 0);
}
