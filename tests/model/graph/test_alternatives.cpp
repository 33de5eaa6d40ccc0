// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/alternatives.h"
#include "tests/model/graph/randomtransitions.h"

#include <gtest/gtest.h>

using namespace quadrille;

TEST(BestTransitions, AreTheCheapestThatAreApart)
{
    constexpr double alpha = 0.01;
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const TransitionCosts costs = makeTransitions({.seed = seed, .counts = {30, 25}, .missing = 0.3});
        const FrameLayout& layout = costs.layout();
        for (const auto& [from, to] : {std::pair(0, 1), std::pair(1, 0), std::pair(0, 0)}) {
            const AlternativeSettings settings{.apart = 3, .most = 5};
            const auto best = bestTransitions(costs, alpha, from, to, settings);
            ASSERT_EQ(best.size(), 5U);
            const auto weight = [&](const FramePair& pair) {
                return costs.weight(pair.source, pair.destination, alpha);
            };
            const auto isNear = [&](const FramePair& a, const FramePair& b) {
                return std::abs(a.source - b.source) < 3 && std::abs(a.destination - b.destination) < 3;
            };
            for (std::size_t k = 0; k < best.size(); ++k) {
                EXPECT_EQ(layout.sequenceOf(best[k].source), from);
                EXPECT_EQ(layout.sequenceOf(best[k].destination), to);
                for (std::size_t other = 0; other < k; ++other) {
                    EXPECT_LE(weight(best[other]), weight(best[k]));
                    EXPECT_FALSE(isNear(best[other], best[k]));
                }
            }
            // What is cheaper than the last one and not listed is near to one that is.
            for (NodeIndex i = layout.firstOf(from); i <= layout.lastOf(from); ++i) {
                for (NodeIndex j = layout.firstOf(to); j <= layout.lastOf(to); ++j) {
                    const FramePair pair{i, j};
                    const bool playsOn = from == to && j > i && weight(pair) > alpha * (j - i);
                    const bool isCheaper =
                        costs.hasTransition(i, j) && !playsOn && weight(pair) < weight(best.back());
                    EXPECT_TRUE(!isCheaper || std::ranges::any_of(best, [&](const FramePair& listed) {
                        return isNear(listed, pair);
                    }));
                }
            }
        }
    }
}
