// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "followedpath.h"

#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {

TEST(LivePlan, BeginsInTheSpaceThatStaysOnIt)
{
    const auto graph = test::curvingGraph(100);
    EXPECT_EQ(LivePathFollower(graph, {}, test::straightPath()).start().space, test::walking);
    EXPECT_EQ(LivePathFollower(graph, {}, test::arcPath(1.2, 3)).start().space, test::turning);
}

TEST(LivePlan, SparesTransitionsBetweenPosesThatAreUnlike)
{
    const auto transitions = [](double apart) {
        LiveGraph graph = *test::curvingGraph(100);
        for (auto& row : graph.tables) {
            for (auto& table : row) {
                if (table == nullptr)
                    continue;
                SimilarityTable changed = *table;
                const auto distance =
                    static_cast<float>(apart / std::sqrt(static_cast<double>(graph.vertexCount())));
                std::ranges::fill(changed.distances, distance);
                std::ranges::fill(changed.leasts, distance);
                changed.greatest = distance;
                table = std::make_shared<const SimilarityTable>(std::move(changed));
            }
        }
        std::int64_t count = 0;
        for (std::uint64_t seed = 101; seed <= 110; ++seed)
            count += test::followed(std::make_shared<const LiveGraph>(graph), test::wavyPath(seed))
                         .states.back()
                         .decisions;
        return count;
    };
    const std::int64_t usual = transitions(0.1);
    EXPECT_EQ(transitions(0.01), usual) << "alike";
    EXPECT_GT(usual, 5);
    EXPECT_LE(transitions(0.6), usual / 2);
}

} // namespace quadrille
