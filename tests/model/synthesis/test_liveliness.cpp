// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/quality/liveliness.h"

#include <array>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// A calm sequence of 22 frames, a lively one of 12 and one of 2.
FrameLayout layout()
{
    return FrameLayout(std::array<std::int64_t, 3>{22, 12, 2});
}

std::vector<FrameMeasure> measures()
{
    std::vector<FrameMeasure> all(36);
    for (std::size_t f = 1; f < 21; ++f)
        all[f].acceleration = static_cast<double>(f);
    for (std::size_t f = 23; f < 33; ++f)
        all[f].acceleration = 100;
    return all;
}

} // namespace

TEST(Liveliness, IsThatOfBothSequences)
{
    const Table<double> liveliness = livelinessOf(measures(), layout());
    EXPECT_EQ(liveliness(0, 0), 19); // 19 of 20 values do not exceed it
    EXPECT_EQ(liveliness(1, 1), 100);
    EXPECT_EQ(liveliness(0, 1), 100);
    EXPECT_EQ(liveliness(1, 0), 100);
    EXPECT_EQ(liveliness(2, 0), 19);
    EXPECT_EQ(liveliness(2, 2), 0);
}

TEST(Liveliness, MakesTransitionsBetweenCalmTakesDearer)
{
    Table<float> cost = Table<float>::Constant(36, 36, 2);
    cost(3, 4) = std::numeric_limits<float>::infinity();
    const Table<float> scaled = costPerLiveliness(cost, layout(), livelinessOf(measures(), layout()));
    // Of 19, 100, 100, 19 and 100 the median is 100.
    EXPECT_FLOAT_EQ(scaled(0, 21), 200.0F / 19);
    EXPECT_FLOAT_EQ(scaled(0, 22), 2);
    EXPECT_FLOAT_EQ(scaled(35, 0), 200.0F / 19);
    EXPECT_FLOAT_EQ(scaled(35, 34), 2);
    EXPECT_EQ(scaled(3, 4), std::numeric_limits<float>::infinity());
}
