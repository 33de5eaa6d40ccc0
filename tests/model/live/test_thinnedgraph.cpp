// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "livefixture.h"
#include "model/live/thinnedgraph.h"

#include <gtest/gtest.h>

namespace quadrille {

TEST(ThinnedGraph, HasNoMoreVerticesThanAskedFor)
{
    const auto graph = test::swingingGraph(); // of 40
    EXPECT_EQ(thinnedGraph(*graph, 100)->vertexCount(), 40U);
    EXPECT_EQ(thinnedGraph(*graph, 20)->vertexCount(), 20U);
    const auto thinned = thinnedGraph(*graph, 15);
    EXPECT_EQ(thinned->vertexCount(), 14U); // every third
    for (std::size_t space = 0; space < graph->spaces.size(); ++space) {
        const SpaceTake& take = graph->spaces[space]->takes.front();
        const SpaceTake& few = thinned->spaces[space]->takes.front();
        ASSERT_EQ(few.poses.size(), take.steps.size() * 14);
        EXPECT_EQ(few.poses[14 * 3 + 5], take.poses[std::size_t{40} * 3 + 15]);
    }
}

TEST(ThinnedGraph, GoesNearlyTheSameWay)
{
    const auto graph = test::swingingGraph();
    LivePlayer player(graph, {}, {.space = test::walking, .parameters = {1.5}});
    LivePlayer thinned(thinnedGraph(*graph, 15), {}, {.space = test::walking, .parameters = {1.5}});
    for (int tick = 0; tick < 600; ++tick) {
        const bool turns = tick / 150 % 2 == 1;
        const LiveInput input{.space = turns ? test::turning : test::walking,
                              .parameters = {turns ? 40.0 : 1.5}};
        player.tick(input);
        thinned.tick(input);
    }
    EXPECT_EQ(thinned.state().decisions, 3);
    EXPECT_EQ(thinned.state().track.phase, player.state().track.phase);
    EXPECT_LT((thinned.root().shift - player.root().shift).norm(), 0.1);
    EXPECT_GT(player.root().shift.norm(), 3);
}

} // namespace quadrille
