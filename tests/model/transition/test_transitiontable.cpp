// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/transitiontable.h"
#include "transitiontables.h"
#include "warpreference.h"

#include <array>
#include <chrono>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <thread>

using namespace quadrille;

namespace {

FrameLayout layoutOf(std::vector<std::int64_t> counts)
{
    return FrameLayout(counts);
}

void expectReference(const Table<float>& distances, const FrameLayout& layout,
                     const TransitionSettings& settings)
{
    const TransitionTable table = transitionTable(distances, layout, settings);
    WarpReference reference(distances, layout, settings);
    int found = 0;
    for (NodeIndex i = 0; i < layout.frameCount(); ++i) {
        for (NodeIndex j = 0; j < layout.frameCount(); ++j) {
            const std::optional<WarpReference::Best> best = reference.find(i, j);
            const auto values = [&](const TransitionTable& t) {
                return std::array<double, 4>{static_cast<double>(t.cost(i, j)),
                                             static_cast<double>(t.length(i, j)),
                                             static_cast<double>(t.sourceWindow(i, j)),
                                             static_cast<double>(t.destinationWindow(i, j))};
            };
            std::array<double, 4> expected{static_cast<double>(TransitionTable::none), 0, 0, 0};
            if (best) {
                const bool mean = settings.cost == TransitionCost::Mean;
                const double cost = mean ? best->sum / best->length : best->sum;
                // Both sums are exact; only the result is rounded.
                expected = {static_cast<double>(static_cast<float>(cost)), static_cast<double>(best->length),
                            static_cast<double>(best->sourceWindow),
                            static_cast<double>(best->destinationWindow)};
                ++found;
            }
            ASSERT_EQ(values(table), expected) << "from " << i << " to " << j;
        }
    }
    EXPECT_GT(found, 0);
}

TransitionSettings windows(int shortest, int longest, int slope = 3,
                           TransitionCost cost = TransitionCost::Sum)
{
    TransitionSettings settings;
    settings.shortestWindow = shortest;
    settings.longestWindow = longest;
    settings.slope = slope;
    settings.cost = cost;
    return settings;
}

} // namespace

class TransitionTables : public testing::TestWithParam<std::tuple<int, TransitionCost>>
{
protected:
    TransitionSettings with(int shortest, int longest) const
    {
        return windows(shortest, longest, std::get<0>(GetParam()), std::get<1>(GetParam()));
    }
};

TEST_P(TransitionTables, EqualBruteForceOnNoise)
{
    expectReference(randomDistances(34, 1), layoutOf({34}), with(4, 11));
}

TEST_P(TransitionTables, EqualBruteForceOnWalks)
{
    expectReference(walkingDistances(40, 2, 9), layoutOf({18, 22}), with(3, 10));
}

TEST_P(TransitionTables, EqualBruteForceBetweenSequencesOfAllLengths)
{
    expectReference(randomDistances(41, 3), layoutOf({1, 9, 3, 4, 12, 2, 10}), with(4, 9));
}

TEST_P(TransitionTables, BreakTiesAsBruteForceDoes)
{
    for (const int levels : {1, 2, 3})
        expectReference(randomDistances(26, static_cast<unsigned>(levels), levels), layoutOf({15, 11}),
                        with(2, 8));
    expectReference(Table<float>::Zero(20, 20), layoutOf({20}), with(3, 7));
}

TEST_P(TransitionTables, AllowWindowsOfOneFrameAndOfOneLength)
{
    expectReference(randomDistances(14, 4), layoutOf({6, 8}), with(1, 5));
    expectReference(randomDistances(24, 5), layoutOf({24}), with(6, 6));
    expectReference(randomDistances(6, 6), layoutOf({6}), with(1, 1));
}

INSTANTIATE_TEST_SUITE_P(Slopes, TransitionTables,
                         testing::Combine(testing::Values(2, 3, 4, 5),
                                          testing::Values(TransitionCost::Sum, TransitionCost::Mean)),
                         [](const auto& instance) {
                             return (std::get<1>(instance.param) == TransitionCost::Sum ? "Sum" : "Mean") +
                                    std::to_string(std::get<0>(instance.param));
                         });
