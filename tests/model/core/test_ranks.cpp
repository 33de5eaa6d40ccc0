// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/ranks.h"

#include <gtest/gtest.h>

using namespace quadrille;

TEST(Ranks, EqualValuesShareTheirPlaces)
{
    EXPECT_EQ(ranksOf(std::vector<double>{3, 1, 3, 2, 3}), (std::vector<double>{4, 1, 4, 2, 4}));
    EXPECT_TRUE(ranksOf({}).empty());
}

TEST(Ranks, QuantilesAreValues)
{
    const std::vector<double> values{5, 1, 4, 2, 3};
    EXPECT_EQ(quantile(values, 0), 1);
    EXPECT_EQ(quantile(values, 0.2), 1);
    EXPECT_EQ(quantile(values, 0.5), 3);
    EXPECT_EQ(quantile(values, 0.95), 5);
    EXPECT_EQ(quantile({}, 0.5), 0);
}

TEST(Ranks, CorrelationIsOneWhereOneRisesWithTheOther)
{
    const std::vector<double> a{1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(*rankCorrelation(a, std::vector<double>{0, 10, 11, 500}), 1);
    EXPECT_DOUBLE_EQ(*rankCorrelation(a, std::vector<double>{9, 8, 7, -1}), -1);
    // 1 − 6·Σd²/(n(n²−1)) = 1 − 6·2/60
    EXPECT_DOUBLE_EQ(*rankCorrelation(a, std::vector<double>{2, 1, 3, 4}), 0.8);
    EXPECT_FALSE(rankCorrelation(a, std::vector<double>{7, 7, 7, 7}));
    EXPECT_FALSE(rankCorrelation({}, {}));
}

TEST(Ranks, AreaCountsPairsInOrder)
{
    const std::vector<double> scores{1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(*areaUnderCurve(scores, {false, false, true, true}), 1);
    EXPECT_DOUBLE_EQ(*areaUnderCurve(scores, {true, false, true, false}), 0.25);
    EXPECT_DOUBLE_EQ(*areaUnderCurve(std::vector<double>{5, 5}, {true, false}), 0.5);
    EXPECT_FALSE(areaUnderCurve(scores, {true, true, true, true}));
    EXPECT_FALSE(areaUnderCurve(scores, {false, false, false, false}));
}
