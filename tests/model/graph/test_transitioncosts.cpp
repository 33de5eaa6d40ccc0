// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "noedge.h"
#include "tests/model/codeof.h"
#include "tests/model/graph/randomtransitions.h"

#include <array>
#include <gtest/gtest.h>

using namespace quadrille;

namespace {

using test::codeOf;

TransitionCosts onePair(float cost, double largestDistance)
{
    Table<float> costs = Table<float>::Constant(4, 4, noEdge);
    Table<std::uint16_t> lengths = Table<std::uint16_t>::Zero(4, 4);
    costs(1, 3) = cost;
    lengths(1, 3) = 2;
    return {costs, lengths, largestDistance, FrameLayout(std::array<std::int64_t, 2>{2, 2})};
}

} // namespace

TEST(TransitionCosts, WeighDeformationAndDuration)
{
    const TransitionCosts costs = onePair(3, 1.5);
    EXPECT_DOUBLE_EQ(costs.weight(1, 3, 0.01), 2.02);
    EXPECT_EQ(costs.weight(3, 1, 0.01), unreachable);
    EXPECT_TRUE(costs.hasTransition(1, 3));
    EXPECT_FALSE(costs.hasTransition(3, 1));
}

TEST(TransitionCosts, RefuseCostsThatAreNotNumbersOrNegative)
{
    EXPECT_EQ(codeOf([] { onePair(std::numeric_limits<float>::quiet_NaN(), 1); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([] { onePair(-1e-6F, 1); }), ErrorCode::BadArgument);
    try {
        onePair(std::numeric_limits<float>::quiet_NaN(), 1);
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "The transition from frame 1 to frame 3 costs NaN. Check these frames, then "
                     "compute the transitions again.");
    }
}

TEST(TransitionCosts, RefuseALargestDistanceThatCannotBe)
{
    for (const double distance : {0.0, -1.0, unreachable, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(codeOf([&] { onePair(1, distance); }), ErrorCode::BadArgument) << distance;
}

TEST(TransitionCosts, MayBeOfPosesThatAreAllAlike)
{
    EXPECT_DOUBLE_EQ(onePair(0, 0).weight(1, 3, 0.5), 1);
    EXPECT_EQ(onePair(noEdge, 0).weight(1, 3, 0.5), unreachable);
}

TEST(CompleteWeights, RefuseAnAlphaBelowZeroOrNaN)
{
    const TransitionCosts costs = onePair(1, 1);
    for (const double alpha : {-1e-9, unreachable, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(codeOf([&] { completeWeights(costs, alpha); }), ErrorCode::BadArgument) << alpha;
    EXPECT_EQ(completeWeights(costs, 0)(0, 1), 0);
}

TEST(CompleteWeights, LeaveOutWhatIsDearerThanPlayingOn)
{
    const FrameLayout layout(std::array<std::int64_t, 2>{5, 1});
    Table<float> cost = Table<float>::Constant(6, 6, 0.25F);
    const Table<std::uint16_t> length = Table<std::uint16_t>::Constant(6, 6, 1);
    cost(0, 4) = 0.8F;
    const TransitionCosts costs(cost, length, 1, layout);
    const Table<double> weights = completeWeights(costs, 0.25); // a transition weighs 0.5
    EXPECT_EQ(weights(0, 1), 0.25) << "original";
    EXPECT_EQ(weights(0, 2), 0.5) << "as dear as playing on";
    EXPECT_EQ(weights(0, 3), 0.5);
    EXPECT_EQ(weights(0, 4), unreachable) << "dearer than playing on";
    EXPECT_EQ(weights(3, 0), 0.5) << "backwards the rule does not hold";
    EXPECT_EQ(weights(4, 5), 0.5) << "nor between sequences";
    EXPECT_EQ(weights(2, 2), unreachable);
}
