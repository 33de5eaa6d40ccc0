// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/timewarp.h"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace quadrille {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

Table<float> table(std::initializer_list<std::initializer_list<float>> rows)
{
    Table<float> result(static_cast<Eigen::Index>(rows.size()),
                        static_cast<Eigen::Index>(rows.begin()->size()));
    Eigen::Index r = 0;
    for (const auto& row : rows) {
        Eigen::Index c = 0;
        for (const float value : row)
            result(r, c++) = value;
        ++r;
    }
    return result;
}

Table<float> randomTable(Eigen::Index rows, Eigen::Index columns, std::mt19937& random)
{
    std::uniform_int_distribution<int> values(0, 9);
    Table<float> result(rows, columns);
    for (float& value : result.reshaped())
        value = static_cast<float>(values(random));
    return result;
}

/// Tries all paths that keep the limit.
double leastCost(const Table<float>& costs, int longestRun)
{
    double least = std::numeric_limits<double>::infinity();
    const std::function<void(Eigen::Index, Eigen::Index, int, int, double)> go =
        [&](Eigen::Index r, Eigen::Index c, int down, int right, double sum) {
            sum += double{costs(r, c)};
            if (r == costs.rows() - 1 && c == costs.cols() - 1)
                least = std::min(least, sum);
            if (r + 1 < costs.rows() && c + 1 < costs.cols())
                go(r + 1, c + 1, 0, 0, sum);
            if (r + 1 < costs.rows() && (longestRun == 0 || down < longestRun))
                go(r + 1, c, down + 1, 0, sum);
            if (c + 1 < costs.cols() && (longestRun == 0 || right < longestRun))
                go(r, c + 1, 0, right + 1, sum);
        };
    go(0, 0, 0, 0, 0);
    return least;
}

double sumOf(const Table<float>& costs, const std::vector<WarpMatch>& path)
{
    double sum = 0;
    for (const WarpMatch& match : path)
        sum += double{costs(match.reference, match.take)};
    return sum;
}

TEST(TimeWarp, SolvesACaseThatWasWorkedOutByHand)
{
    const Table<float> costs = table({{0, 5, 5, 5}, {5, 1, 0, 5}, {5, 5, 5, 2}});
    const WarpPathResult result = warpWhole(costs);
    EXPECT_DOUBLE_EQ(result.cost, 3);
    EXPECT_THAT(result.path, ElementsAre(WarpMatch{0, 0}, WarpMatch{1, 1}, WarpMatch{1, 2}, WarpMatch{2, 3}));
}

TEST(TimeWarp, CostsWhatTheBestOfAllPathsCosts)
{
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        const Table<float> costs = randomTable(2 + round % 5, 2 + round % 4, random);
        for (const int run : {0, 1, 2, 3}) {
            const auto shorter = std::min(costs.rows(), costs.cols());
            const auto longer = std::max(costs.rows(), costs.cols());
            const int needed = static_cast<int>((longer + shorter - 1) / shorter) - 1;
            const WarpPathResult result = warpWhole(costs, {.longestRun = run});
            EXPECT_DOUBLE_EQ(result.cost, leastCost(costs, run == 0 ? 0 : std::max(run, needed)));
            EXPECT_DOUBLE_EQ(result.cost, sumOf(costs, result.path));
            EXPECT_EQ(result.path.front(), (WarpMatch{0, 0}));
            EXPECT_EQ(result.path.back(),
                      (WarpMatch{static_cast<int>(costs.rows()) - 1, static_cast<int>(costs.cols()) - 1}));
        }
    }
}

TEST(TimeWarp, FindsTheRunOfFramesThatMatchesBest)
{
    std::mt19937 random(11);
    for (int round = 0; round < 40; ++round) {
        const Table<float> costs = randomTable(2 + round % 3, 3 + round % 4, random);
        double least = std::numeric_limits<double>::infinity();
        for (Eigen::Index first = 0; first < costs.cols(); ++first) {
            for (Eigen::Index count = 1; first + count <= costs.cols(); ++count)
                least = std::min(least, leastCost(costs.middleCols(first, count), 2));
        }
        const auto result = warpWithin(costs, {.longestRun = 2});
        ASSERT_TRUE(result);
        EXPECT_DOUBLE_EQ(result->cost, least);
        EXPECT_DOUBLE_EQ(result->cost, sumOf(costs, result->path));
    }
}

TEST(TimeWarp, FindsNothingWhereTheTakeIsTooShort)
{
    EXPECT_FALSE(warpWithin(Table<float>::Ones(9, 2), {.longestRun = 3}));
    EXPECT_TRUE(warpWithin(Table<float>::Ones(8, 2), {.longestRun = 3}));
}

TEST(TimeWarp, SpansLengthsThatDifferByMoreThanTheLimit)
{
    const WarpPathResult result = warpWhole(Table<float>::Ones(3, 30), {.longestRun = 2});
    EXPECT_EQ(result.path.back(), (WarpMatch{2, 29}));
    const WarpPathResult one = warpWhole(Table<float>::Ones(1, 300), {.longestRun = 2});
    EXPECT_EQ(one.path.size(), 300U);
}

TEST(TimeWarp, TakesMeansWhereFramesAreMatchedSeveralTimes)
{
    // Reference frame 1 matches frames 1–3 of the take, its frames 2–4 match frame 4.
    const std::vector<WarpMatch> path = {{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 4}, {4, 4}, {5, 5}};
    const TakeWarp warp = warpOf(path, 0, FrameIndex(10));
    EXPECT_EQ(warp.frames, (FrameRange{FrameIndex(10), FrameIndex(15)}));
    EXPECT_THAT(warp.positions, ElementsAre(10, 12, 13, 14, 14.5, 15));
    EXPECT_THAT(warp.playback, ElementsAre(0, 0.5, 1, 2, 3, 5));
}

TEST(TimeWarp, KeepsItsEndsMatched)
{
    const std::vector<WarpMatch> path = {{0, 0}, {0, 1}, {0, 2}, {1, 3}, {2, 4}, {3, 4}};
    const TakeWarp warp = warpOf(path, 0);
    EXPECT_THAT(warp.positions, ElementsAre(0, 3, 3.5, 4));
    EXPECT_DOUBLE_EQ(warp.playback.front(), 0);
    EXPECT_DOUBLE_EQ(warp.playback.back(), 3);
}

TEST(TimeWarp, IsTheIdentityOnADiagonal)
{
    std::vector<WarpMatch> path;
    for (int f = 0; f < 9; ++f)
        path.push_back({f, f + 3});
    for (const double smoothing : {0.0, 1.5, 20.0}) {
        const TakeWarp warp = warpOf(path, smoothing);
        for (int f = 0; f < 9; ++f) {
            EXPECT_NEAR(warp.positions[static_cast<std::size_t>(f)], f + 3, 1e-12);
            EXPECT_NEAR(warp.playback[static_cast<std::size_t>(f)], f, 1e-12);
        }
    }
}

TEST(TimeWarp, SmoothingKeepsEndsAndOrder)
{
    std::mt19937 random(3);
    for (int round = 0; round < 30; ++round) {
        const WarpPathResult result = warpWhole(randomTable(12, 9 + round, random), {.longestRun = 3});
        const TakeWarp rough = warpOf(result.path, 0);
        const TakeWarp warp = warpOf(result.path, 0.5 + round);
        EXPECT_EQ(warp.positions.front(), rough.positions.front());
        EXPECT_EQ(warp.positions.back(), rough.positions.back());
        for (std::size_t f = 1; f < warp.positions.size(); ++f)
            EXPECT_GT(warp.positions[f], warp.positions[f - 1]);
    }
}

TEST(TimeWarp, PlaybackUndoesPositions)
{
    std::mt19937 random(5);
    const WarpPathResult result = warpWhole(randomTable(20, 27, random));
    const TakeWarp warp = warpOf(result.path, 1.5);
    ASSERT_EQ(warp.playback.size(), 27U);
    for (std::size_t k = 0; k < warp.playback.size(); ++k) {
        const auto before = static_cast<std::size_t>(std::min(warp.playback[k], 18.0));
        const double share = warp.playback[k] - static_cast<double>(before);
        EXPECT_NEAR((1 - share) * warp.positions[before] + share * warp.positions[before + 1],
                    static_cast<double>(k), 1e-9);
    }
}

TEST(TimeWarp, BlendsLengthAndTiming)
{
    const TakeWarp a = warpOf(warpWhole(Table<float>::Ones(5, 5)).path, 0, FrameIndex(7));
    const TakeWarp b = warpOf(warpWhole(Table<float>::Ones(5, 13)).path, 0);
    EXPECT_EQ(blendedWarp(a, b, 0), a);
    EXPECT_EQ(blendedWarp(a, b, 1), b);
    const TakeWarp half = blendedWarp(a, b, 0.5);
    EXPECT_EQ(half.frames, FrameRange::all(9));
    EXPECT_EQ(half.playback.size(), 9U);
    for (std::size_t f = 0; f < 5; ++f)
        EXPECT_NEAR(half.positions[f], (a.positions[f] - 7 + b.positions[f]) / 2, 1e-12);
    const TakeWarp nearA = blendedWarp(a, b, 1e-9);
    EXPECT_THAT(nearA.playback, Pointwise(DoubleNear(1e-6), a.playback));
}

TEST(TimeWarp, BlendsFourBilinearly)
{
    std::vector<TakeWarp> takes;
    for (const int frames : {5, 9, 13, 29})
        takes.push_back(warpOf(warpWhole(Table<float>::Ones(5, frames)).path, 0, FrameIndex(frames)));
    // A quarter of the way along, half of it across.
    const std::array shares{0.375, 0.125, 0.375, 0.125};
    std::vector<WarpShare> warps;
    for (std::size_t t = 0; t < takes.size(); ++t)
        warps.push_back({&takes[t], shares[t]});
    const TakeWarp blend = blendedWarp(warps);
    // 3/8 · 4 + 1/8 · 8 + 3/8 · 12 + 1/8 · 28 = 10.5 steps become 11, and all positions grow with them.
    EXPECT_EQ(blend.frames, FrameRange::all(12));
    ASSERT_EQ(blend.playback.size(), 12U);
    for (std::size_t f = 0; f < 5; ++f) {
        double position = 0;
        for (std::size_t t = 0; t < takes.size(); ++t)
            position += shares[t] * (takes[t].positions[f] - takes[t].positions[0]);
        EXPECT_NEAR(blend.positions[f], position * 11 / 10.5, 1e-12);
    }
    EXPECT_NEAR(blend.positions.back(), 11, 1e-12);
    // What has no share does not count.
    warps[0].share = 0.25;
    warps[1].share = 0.75;
    warps[2].share = warps[3].share = 0;
    EXPECT_EQ(blendedWarp(warps), blendedWarp(takes[0], takes[1], 0.75));
    warps[0].share = 0;
    warps[1].share = 1;
    EXPECT_EQ(blendedWarp(warps), takes[1]);
}

} // namespace
} // namespace quadrille
