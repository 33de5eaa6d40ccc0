// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/cycles.h"
#include "tests/model/codeof.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

/// Distances of poses on a circle, and on a second, smaller one that turns twice as fast.
Table<float> circleDistances(int rows, int columns, const std::function<double(int)>& rowPhase,
                             const std::function<double(int)>& columnPhase)
{
    const auto point = [](double phase) {
        return std::array{std::cos(phase), std::sin(phase), 0.4 * std::cos(2 * phase + 1)};
    };
    Table<float> distances(rows, columns);
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const auto a = point(rowPhase(r));
            const auto b = point(columnPhase(c));
            distances(r, c) = static_cast<float>(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
        }
    }
    return distances;
}

std::function<double(int)> turning(double period, double start = 0)
{
    return [=](int f) { return 2 * std::numbers::pi * (f / period + start); };
}

TEST(Cycles, PeriodIsFoundWhereItIsSeenAgainForAFifth)
{
    const auto periodOf = [](int frames, double period) {
        return findPeriod(circleDistances(frames, frames, turning(period), turning(period)), 0.3);
    };
    EXPECT_EQ(periodOf(50, 20), 20);
    EXPECT_EQ(periodOf(70, 20), 20); // not 40
    EXPECT_EQ(periodOf(40, 16.4), 16);
    EXPECT_EQ(periodOf(24, 20), 20);
    EXPECT_EQ(periodOf(23, 20), std::nullopt);
    EXPECT_EQ(periodOf(20, 20), std::nullopt);
}

TEST(Cycles, MotionThatGoesOutAndBackHasNone)
{
    const auto outAndBack = [](int f) { return 1.5 * std::sin(std::numbers::pi * f / 39); };
    EXPECT_EQ(findPeriod(circleDistances(40, 40, outAndBack, outAndBack), 0.3), std::nullopt);
    const auto still = [](int) { return 0.0; };
    EXPECT_EQ(findPeriod(circleDistances(40, 40, still, still), 0.3), std::nullopt);
}

TEST(Cycles, RestBeforeAndAfterIsNoRepetition)
{
    // Once around, as a jump is, from rest to rest: seen again is only the rest, in which somebody sways.
    const auto once = [](int f) {
        const double sway = 0.05 * std::sin(1.7 * f * f);
        return 2 * std::numbers::pi * std::clamp((f - 10) / 30.0, 0.0, 1.0) + sway;
    };
    const Table<float> own = circleDistances(50, 50, once, once);
    EXPECT_EQ(findPeriod(own, 0.3), std::nullopt);
}

TEST(Cycles, WindowBeginsInThePhaseOfTheReference)
{
    // A cycle of 24 frames from a third of a turn on; the take is at a tenth at its first frame.
    const Table<float> costs = circleDistances(24, 60, turning(24, 1. / 3), turning(30, 0.1));
    EXPECT_EQ(cycleWindow(costs, 30), (FrameRange{FrameIndex(7), FrameIndex(36)}));
}

TEST(Cycles, StartIsChosenSoThatAllTakesHoldACycle)
{
    // Takes with hardly more than a cycle, from 0.30 and from 0.35 of a turn on.
    const Table<float> a = circleDistances(60, 26, turning(25), turning(24, 0.30));
    const Table<float> b = circleDistances(60, 31, turning(25), turning(29, 0.35));
    const std::vector<CycleTake> takes = {{&a, 24}, {&b, 29}};
    const std::int64_t start = chooseCycleStart(takes, 25, 60);
    const double phase = std::fmod(static_cast<double>(start) / 25, 1);
    EXPECT_NEAR(phase, 0.36, 0.05);
    EXPECT_EQ(chooseCycleStart({}, 25, 60), 0);
}

TEST(Cycles, LongTakesAreSearchedInSteps)
{
    const Table<float> costs = circleDistances(900, 800, turning(200), turning(160, 0.3));
    const std::vector<CycleTake> takes = {{&costs, 160}};
    const std::int64_t start = chooseCycleStart(takes, 200, 900);
    const FrameRange window = cycleWindow(costs.middleRows(start, 200), 160);
    const double difference =
        static_cast<double>(start) / 200 - (static_cast<double>(window.first.value) / 160 + 0.3);
    EXPECT_NEAR(difference - std::round(difference), 0, 0.01);
    CancelToken token;
    token.cancel();
    EXPECT_EQ(test::codeOf([&] { chooseCycleStart(takes, 200, 900, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST(Cycles, OneIsFoundInATakeThatBeginsAndStops)
{
    // Stands for 20 frames, turns once and a half in 45, stands.
    const auto phase = [](int f) { return 2 * std::numbers::pi * std::clamp((f - 20) / 30.0, 0.0, 1.5); };
    const Table<float> own = circleDistances(80, 80, phase, phase);
    const Table<float> costs = circleDistances(24, 80, turning(24, 0.25), phase);
    ASSERT_EQ(findPeriod(own, 0.3), std::nullopt);
    const auto found = cycleWithin(costs, own, {}, 0.3, 0.3);
    ASSERT_TRUE(found);
    EXPECT_NEAR(static_cast<double>(found->first.value), 27.5, 1.5);
    EXPECT_NEAR(static_cast<double>(found->count()), 30, 1.5);
}

TEST(Cycles, NoneIsFoundInHalfACycleNorInOtherMotion)
{
    const auto half = [](int f) { return std::numbers::pi * f / 14.0; };
    EXPECT_FALSE(cycleWithin(circleDistances(24, 15, turning(24), half), circleDistances(15, 15, half, half),
                             {}, 0.3, 0.3));
    const auto sway = [](int f) { return 0.3 * std::sin(0.5 * f); };
    EXPECT_FALSE(cycleWithin(circleDistances(24, 60, turning(24), sway), circleDistances(60, 60, sway, sway),
                             {}, 0.3, 0.3));
    EXPECT_FALSE(cycleWithin(circleDistances(24, 4, turning(24), half), circleDistances(4, 4, half, half), {},
                             0.3, 0.3));
}

} // namespace
} // namespace quadrille
