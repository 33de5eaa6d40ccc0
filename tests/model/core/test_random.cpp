// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/random.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace quadrille;

// The first numbers of SplitMix64 with seed 0 (Steele, Lea & Flood 2014).
TEST(Random, isSplitMix64)
{
    Random random(0);
    EXPECT_EQ(random.next(), 0xE220A8397B1DCDAFULL);
    EXPECT_EQ(random.next(), 0x6E789E6AA1B965F4ULL);
}

// Standard errors of the moments of n normals: √(1/n), √(2/n), √(15/n), √(96/n); four of them are allowed.
TEST(Random, normalsHaveTheMomentsOfTheNormalDistribution)
{
    Random random(3);
    constexpr int count = 400000;
    double sums[4] = {};
    int beyondTwo = 0;
    for (int i = 0; i < count; ++i) {
        const double x = random.normal();
        double power = 1;
        for (double& sum : sums)
            sum += power *= x;
        beyondTwo += std::abs(x) > 2;
    }
    const double n = count;
    EXPECT_NEAR(sums[0] / n, 0, 4 * std::sqrt(1 / n));
    EXPECT_NEAR(sums[1] / n, 1, 4 * std::sqrt(2 / n));
    EXPECT_NEAR(sums[2] / n, 0, 4 * std::sqrt(15 / n));
    EXPECT_NEAR(sums[3] / n, 3, 4 * std::sqrt(96 / n));
    EXPECT_NEAR(beyondTwo / n, 0.0455, 4 * std::sqrt(0.0455 / n));
}

TEST(Random, normalsFollowFromTheSeedAndNeighboursDoNotGoTogether)
{
    Random a(5);
    Random b(5);
    double product = 0;
    double last = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double x = a.normal();
        ASSERT_EQ(x, b.normal());
        product += x * last;
        last = x;
    }
    EXPECT_NEAR(product / count, 0, 4 / std::sqrt(double{count}));
}

TEST(Random, streamsOfOneSeedDiffer)
{
    EXPECT_NE(streamSeed(1, 0), streamSeed(1, 1));
    EXPECT_NE(streamSeed(1, 0), streamSeed(2, 0));
    EXPECT_NE(streamSeed(1, 2), streamSeed(2, 1));
    EXPECT_EQ(streamSeed(1, 2), streamSeed(1, 2));
}
