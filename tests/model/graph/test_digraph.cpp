// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

const std::vector<Edge> someEdges{
    {0, 1, 0.1, EdgeKind::Original}, {0, 3, 2}, {2, 0, 5}, {2, 3, 0.1, EdgeKind::Original}, {3, 0, 2}};

} // namespace

TEST(Digraph, GivesTheEdgesOfEachNode)
{
    const Digraph graph(5, someEdges);
    EXPECT_EQ(graph.nodeCount(), 5);
    EXPECT_EQ(graph.edgesFrom(0).size(), 2U);
    EXPECT_EQ(graph.edgesFrom(1).size(), 0U);
    ASSERT_EQ(graph.edgesFrom(2).size(), 2U);
    EXPECT_EQ(graph.edgesFrom(2)[1], someEdges[3]);
    EXPECT_EQ(graph.edgesFrom(4).size(), 0U);
    EXPECT_EQ(graph.count(EdgeKind::Original), 2);
    EXPECT_EQ(graph.count(EdgeKind::Transition), 3);
    EXPECT_DOUBLE_EQ(graph.density(), 5.0 / 20);
}

TEST(Digraph, FindsAnEdgeByItsEnds)
{
    const Digraph graph(5, someEdges);
    ASSERT_TRUE(graph.find(2, 0));
    EXPECT_EQ(*graph.find(2, 0), someEdges[2]);
    EXPECT_FALSE(graph.find(0, 2));
    EXPECT_FALSE(graph.find(4, 0));
}

TEST(Digraph, MayHaveNoNodesOrOne)
{
    EXPECT_EQ(Digraph().nodeCount(), 0);
    EXPECT_EQ(Digraph().density(), 0);
    EXPECT_EQ(Digraph(1, {}).density(), 0);
    EXPECT_EQ(Digraph(1, {}).edgesFrom(0).size(), 0U);
    EXPECT_EQ(weightTable(Digraph()).size(), 0);
}

TEST(Digraph, BecomesATableOfWeights)
{
    const Table<double> weights = weightTable(Digraph(4, {someEdges.begin(), someEdges.end()}));
    EXPECT_EQ(weights(0, 3), 2);
    EXPECT_EQ(weights(2, 0), 5);
    EXPECT_EQ(weights(0, 0), unreachable);
    EXPECT_EQ((weights < unreachable).count(), 5);
}

TEST(Thinned, LosesItsHeaviestTransitionsFirst)
{
    const Digraph graph(5, someEdges);
    EXPECT_EQ(thinned(graph, 5), graph);
    EXPECT_EQ(thinned(graph, 9), graph);
    const Digraph four = thinned(graph, 4);
    EXPECT_FALSE(four.find(2, 0));
    EXPECT_EQ(four.edges().size(), 4U);
    const Digraph three = thinned(graph, 3);
    EXPECT_TRUE(three.find(0, 3)) << "of two alike the later one goes";
    EXPECT_FALSE(three.find(3, 0));
    EXPECT_EQ(thinned(graph, 0), Digraph(5, {someEdges[0], someEdges[3]})) << "original edges stay";
}
