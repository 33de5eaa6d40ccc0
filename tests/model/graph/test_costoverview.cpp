// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/costoverview.h"
#include "tests/model/graph/randomtransitions.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace quadrille;

namespace {

constexpr float none = std::numeric_limits<float>::infinity();

FrameLayout layoutOf(std::int64_t frames)
{
    return FrameLayout(std::array{frames});
}

} // namespace

TEST(CostOverview, HasTheLeastCostOfEachSquare)
{
    const TransitionCosts costs = makeTransitions({.seed = 7, .counts = {5, 1, 7, 24}, .missing = 0.8});
    for (const auto& [side, each] :
         {std::pair{100, 1}, {37, 1}, {36, 2}, {19, 2}, {18, 4}, {5, 8}, {1, 64}}) {
        const CostOverview overview = costOverview(costs.cost(), costs.layout(), side);
        EXPECT_EQ(overview.layout, costs.layout());
        ASSERT_EQ(overview.framesOfCell, each);
        const int cells = (37 + each - 1) / each;
        ASSERT_EQ(overview.least.rows(), cells);
        ASSERT_EQ(overview.least.cols(), cells);
        Table<float> least = Table<float>::Constant(cells, cells, none);
        for (int i = 0; i < 37; ++i) {
            for (int j = 0; j < 37; ++j)
                least(i / each, j / each) = std::min(least(i / each, j / each), costs.cost()(i, j));
        }
        EXPECT_TRUE((overview.least == least).all()) << side;
    }
}

TEST(CostOverview, OfNothingIsEmpty)
{
    const CostOverview without = costOverview(Table<float>(), FrameLayout());
    EXPECT_EQ(without.least.size(), 0);
    const CostOverview unreached =
        costOverview(Table<float>(Table<float>::Constant(3, 3, none)), layoutOf(3));
    EXPECT_TRUE((unreached.least == none).all());
    EXPECT_LT(unreached.range.minimum, unreached.range.maximum);
}

TEST(CostRange, LeavesATenthOfTheTransitionsOut)
{
    Table<float> cost(20, 10);
    for (Eigen::Index i = 0; i < cost.size(); ++i)
        cost.data()[i] = i % 2 == 0 ? static_cast<float>(i + 3) : none;
    std::shuffle(cost.data(), cost.data() + cost.size(), std::mt19937(3));
    // The hundred finite ones are 3, 5 … 201.
    const CostRange range = costRange(cost);
    EXPECT_EQ(range.minimum, 3);
    EXPECT_EQ(range.maximum, 3 + 2 * 89);
}
