// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/finishing/turnkernel.h"
#include "tests/model/synthesis/draggedfeet.h"

#include <cmath>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <vector>

using namespace quadrille;
using test::Walker;

TEST(FootDrift, IsHowFarTheClipDragsAFoot)
{
    double largest = 0;
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        const Walker walker(seed);
        const Table<float> drifts = walker.drifts();
        for (NodeIndex i = 0; i <= 25; i += 3) {
            for (NodeIndex j = 54; j < 86; j += 2) {
                // Turns are single precision.
                EXPECT_NEAR(drifts(i, j), walker.expected(i, j), 1e-5) << seed << ": " << i << " → " << j;
                largest = std::max(largest, static_cast<double>(drifts(i, j)));
            }
        }
    }
    EXPECT_GT(largest, 0.05);
}

TEST(FootDrift, IsNothingWhereBothTakesGoOnAlike)
{
    constexpr int length = 15;
    Walker walker(1, length);
    // The same step in both takes; blends of the same part of it show it as it is, others drag the foot.
    RootPoses& roots = walker.roots;
    roots.stances.standing.assign(roots.stances.standing.size(), 1);
    roots.turns = SharedTable<float>(Table<float>::Zero(roots.turns->rows(), roots.turns->cols()));
    for (Vec3d& place : roots.stances.places)
        place = Vec3d(1, 2, 0);
    for (int sequence = 0; sequence < 2; ++sequence)
        for (NodeIndex f = 0; f < walker.layout.countOf(sequence); ++f)
            roots.centres[static_cast<std::size_t>(walker.layout.firstOf(sequence) + f)] = {0.05 * f, 1, 1};
    const Table<float> drifts = walker.drifts();
    for (NodeIndex i = 0; i + length <= 40; ++i) {
        EXPECT_LT(drifts(i, 40 + i + length - 1), 1e-6F) << i;
        EXPECT_GT(drifts(i, 40 + i + length + 4), 0.01F) << i;
    }
    EXPECT_EQ(drifts(0, 1), 0) << "no transition";
    walker.roots.stances = {};
    EXPECT_EQ(walker.drifts().maxCoeff(), 0) << "nothing is known of feet";
}

TEST(FootDrift, IsTheSameOfSingleTransitions)
{
    const Walker walker(3);
    const Table<float> drifts = walker.drifts();
    const auto driftOf = [&](const RootPoses& roots, const FramePair& pair) {
        return FootDrifts(roots, walker.layout, Walker::fps).of(walker.transitions.at(pair), pair);
    };
    for (NodeIndex i = 0; i < 40; i += 5)
        for (NodeIndex j = 0; j < 86; j += 3)
            EXPECT_EQ(driftOf(walker.roots, {i, j}), drifts(i, j)) << i << " → " << j;
    RootPoses withoutFeet = walker.roots;
    withoutFeet.stances = {};
    EXPECT_EQ(driftOf(withoutFeet, {0, 60}), 0);
}

TEST(FootDrift, IsTheSameOnAnyNumberOfThreads)
{
    const Walker walker(2);
    const Table<float> parallel = walker.drifts();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE((walker.drifts() == parallel).all());
}

TEST(FootDrift, KnowsSinesAndCosines)
{
    std::vector<double> angles;
    for (int i = -4000; i <= 4000; ++i)
        angles.push_back(0.07 * i);
    std::vector<TurnParts> turns(angles.size());
    turnsOf(angles, turns);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        // As the header promises.
        EXPECT_NEAR(turns[i].cosine, std::cos(angles[i]), 1e-10) << angles[i];
        EXPECT_NEAR(turns[i].sine, std::sin(angles[i]), 1e-10) << angles[i];
    }
}

TEST(FootDrift, StopsWhenCancelled)
{
    CancelToken token;
    token.cancel();
    const Walker walker(1);
    EXPECT_THROW(footDrifts(walker.roots, walker.layout, walker.transitions, Walker::fps, Progress(token)),
                 Error);
}

TEST(FootDrift, CostsAsMuchAsFeetThatDiffer)
{
    Table<float> cost = Table<float>::Constant(2, 2, 0.5F);
    cost(0, 0) = TransitionTable::none;
    const Table<float> drifts = Table<float>::Constant(2, 2, static_cast<float>(dragOfOneFoot));
    const Table<std::uint16_t> lengths = Table<std::uint16_t>::Constant(2, 2, 10);
    Table<float> mean = cost;
    addDrifts(mean, drifts, lengths, false, {.contacts = 2});
    EXPECT_FLOAT_EQ(mean(0, 1), 0.5F + 2);
    EXPECT_EQ(mean(0, 0), TransitionTable::none);
    addDrifts(cost, drifts, lengths, true, {.contacts = 2});
    EXPECT_FLOAT_EQ(cost(0, 1), 0.5F + 10 * 2);
    addDrifts(mean, drifts, lengths, false, {.velocity = 1});
    EXPECT_FLOAT_EQ(mean(0, 1), 0.5F + 2) << "no weight";
}
