// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/smoothing.h"
#include "model/core/units.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// Standing, then going one step of the list a value.
std::vector<double> kink()
{
    std::vector<double> values(21, 0.0);
    for (std::size_t i = 10; i < values.size(); ++i)
        values[i] = static_cast<double>(i) - 10;
    return values;
}

double sharpest(const std::vector<double>& values)
{
    double largest = 0;
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
        largest = std::max(largest, std::abs(values[i + 1] - 2 * values[i] + values[i - 1]));
    return largest;
}

TEST(Smoothing, NothingIsChangedWithoutADeviation)
{
    EXPECT_EQ(evened(kink(), 0), kink());
    const std::vector<double> two{1, 5};
    EXPECT_EQ(evened(two, 3), two);
    EXPECT_TRUE(evened(std::vector<double>(), 3).empty());
}

TEST(Smoothing, StraightLinesAndEndsStay)
{
    std::vector<Vec2d> line;
    for (int i = 0; i < 9; ++i)
        line.emplace_back(0.5 * i, 3 - i);
    // The Gaussian reaches beyond both ends, several times over.
    const std::vector<Vec2d> even = evened(line, 7);
    for (std::size_t i = 0; i < line.size(); ++i)
        EXPECT_LT((even[i] - line[i]).norm(), 1e-12) << i;
    EXPECT_EQ(evened(kink(), 4).front(), 0);
    EXPECT_EQ(evened(kink(), 4).back(), 10);
}

TEST(Smoothing, AKinkBecomesACurve)
{
    const std::vector<double> even = evened(kink(), 2);
    // Of the Gaussian's weights the largest is what is left of the kink.
    EXPECT_NEAR(sharpest(even), 0.2, 0.002);
    EXPECT_TRUE(std::is_sorted(even.begin(), even.end()));
    // Far from it, nothing is changed.
    EXPECT_NEAR(even[2], 0, 1e-12);
    EXPECT_NEAR(even[18], 8, 1e-12);
}

} // namespace
