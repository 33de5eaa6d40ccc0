// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/components.h"
#include "tests/model/graph/randomtransitions.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

using namespace quadrille;

namespace {

using Nodes = std::vector<NodeIndex>;

Digraph graphOf(NodeIndex nodes, const std::vector<std::pair<NodeIndex, NodeIndex>>& pairs)
{
    std::vector<Edge> edges;
    for (const auto& [from, to] : pairs)
        edges.push_back({from, to, 1});
    return {nodes, std::move(edges)};
}

} // namespace

TEST(Connectivity, AgreesWithPlainReachability)
{
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        constexpr NodeIndex nodes = 25;
        const Digraph graph = randomDigraph(seed, nodes, 0.02 + 0.002 * seed, 0);
        const Table<double> paths = plainPathCosts(weightTable(graph));
        const auto reaches = [&](NodeIndex i, NodeIndex j) { return paths(i, j) < unreachable; };
        const Connectivity result = connectivity(graph);
        Nodes componentOf(nodes, -1);
        for (std::size_t c = 0; c < result.components.size(); ++c) {
            EXPECT_TRUE(std::is_sorted(result.components[c].begin(), result.components[c].end()));
            for (const NodeIndex node : result.components[c])
                componentOf[static_cast<std::size_t>(node)] = static_cast<NodeIndex>(c);
        }
        for (NodeIndex i = 0; i < nodes; ++i)
            for (NodeIndex j = 0; j < nodes; ++j)
                EXPECT_EQ(componentOf[static_cast<std::size_t>(i)] ==
                              componentOf[static_cast<std::size_t>(j)],
                          reaches(i, j) && reaches(j, i))
                    << seed << ": " << i << ", " << j;
        Nodes isolated;
        Nodes ends;
        const Nodes& largest = result.components.front();
        for (NodeIndex i = 0; i < nodes; ++i) {
            if (largest.size() < 2 || !reaches(largest.front(), i))
                isolated.push_back(i);
            if (largest.size() < 2 || !reaches(i, largest.front()))
                ends.push_back(i);
        }
        EXPECT_EQ(result.unreachable, isolated) << seed;
        EXPECT_EQ(result.deadEnds, ends) << seed;
    }
}

TEST(Connectivity, NamesDeadEndsAndUnreachableFrames)
{
    // 0 → 1 ⇄ 2 → 3, 2 ⇄ 4, and 5 ⇄ 6 apart.
    const Connectivity result =
        connectivity(graphOf(7, {{0, 1}, {1, 2}, {2, 1}, {2, 3}, {2, 4}, {4, 2}, {5, 6}, {6, 5}}));
    EXPECT_EQ(result.components, (std::vector<Nodes>{{1, 2, 4}, {5, 6}, {0}, {3}}));
    EXPECT_EQ(result.unreachable, (Nodes{0, 5, 6}));
    EXPECT_EQ(result.deadEnds, (Nodes{3, 5, 6}));
}

TEST(Connectivity, OfASequenceAloneHasNoWayBack)
{
    const Connectivity result = connectivity(graphOf(3, {{0, 1}, {1, 2}}));
    EXPECT_EQ(result.components.size(), 3U);
    EXPECT_EQ(result.unreachable, (Nodes{0, 1, 2}));
    EXPECT_EQ(result.deadEnds, (Nodes{0, 1, 2}));
}

TEST(Connectivity, OfAnEmptyGraphIsEmpty)
{
    EXPECT_TRUE(connectivity(Digraph()).components.empty());
    EXPECT_EQ(connectivity(Digraph(1, {})).components, (std::vector<Nodes>{{0}}));
}

TEST(Connectivity, CopesWithLongWalks)
{
    constexpr NodeIndex nodes = 200'000;
    std::vector<Edge> edges;
    for (NodeIndex i = 0; i + 1 < nodes; ++i)
        edges.push_back({i, i + 1, 1});
    edges.push_back({nodes - 1, 0, 1});
    Nodes all(nodes);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(connectivity(Digraph(nodes, edges)).components, (std::vector<Nodes>{all}));
}
