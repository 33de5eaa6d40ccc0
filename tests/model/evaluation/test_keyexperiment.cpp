// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/keyexperiment.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <set>

using namespace quadrille;
using ::testing::ElementsAre;

TEST(KeyExperiment, FramesThatLeadToEachOtherArePutIntoThePool)
{
    // 0 → 1 ⇄ 2 ⇄ 3 → 4
    const Digraph graph(5, {{0, 1, 1, EdgeKind::Original},
                            {1, 2, 1, EdgeKind::Original},
                            {2, 1, 1, EdgeKind::Transition},
                            {2, 3, 1, EdgeKind::Original},
                            {3, 2, 1, EdgeKind::Transition},
                            {3, 4, 1, EdgeKind::Original}});
    const std::vector<WalkSpan> all{{0, 4}};
    EXPECT_THAT(connectedFrames(graph, all), ElementsAre(1, 2, 3));
    const std::vector<WalkSpan> some{{0, 1}, {3, 4}};
    EXPECT_THAT(connectedFrames(graph, some), ElementsAre(1, 3));
    EXPECT_TRUE(connectedFrames(Digraph(2, {{0, 1, 1, EdgeKind::Original}}), all).empty());
}

TEST(KeyExperiment, KeysAreDifferentFramesAtTimesThatAscend)
{
    const std::vector<NodeIndex> pool{3, 4, 5, 9, 11, 12, 20};
    const auto keys = drawKeys(pool, 5, 1000, 7);
    ASSERT_EQ(keys.size(), 5U);
    EXPECT_EQ(keys.front().time, 0);
    EXPECT_EQ(keys.back().time, 1000);
    std::set<NodeIndex> frames;
    for (const PoseKey& key : keys) {
        EXPECT_NE(std::find(pool.begin(), pool.end(), key.frame), pool.end());
        frames.insert(key.frame);
    }
    // Gaps differ by a factor of five at most.
    for (std::size_t k = 1; k < keys.size(); ++k)
        EXPECT_GT(keys[k].time - keys[k - 1].time, 1000 * 0.25 / (4 * 1.25) - 1);
    EXPECT_EQ(frames.size(), 5U);
    EXPECT_EQ(drawKeys(pool, 5, 1000, 7), keys);
    EXPECT_NE(drawKeys(pool, 5, 1000, 8), keys);
}

TEST(KeyExperiment, ASmallPoolGivesFewerKeys)
{
    EXPECT_EQ(drawKeys({1, 2}, 5, 100, 1).size(), 2U);
    EXPECT_EQ(drawKeys({1}, 5, 100, 1).front().time, 0);
    EXPECT_TRUE(drawKeys({}, 5, 100, 1).empty());
}
