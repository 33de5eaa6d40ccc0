// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/variation/sampling.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

// Two frames: given the first, the second is Gaussian with the mean and the variance of eq. 9 and 10.
TEST(TrajectorySamples, ofTwoFramesHaveTheMeanAndVarianceOfThePrediction)
{
    const LatentLoops loops = latentLoops(2, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix start = loops.trajectory(0).topRows(2);
    constexpr int count = 2000;
    const TrajectorySamples samples =
        sampleTrajectories(dynamics, start, count, 3, {.leapfrogSteps = 5, .thinning = 2});
    ASSERT_EQ(samples.trajectories.size(), static_cast<std::size_t>(count));
    const Eigen::RowVectorXd mean = dynamics.next(start.row(0));
    const double variance = dynamics.variance(start.row(0));
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(3);
    Eigen::RowVectorXd squares = Eigen::RowVectorXd::Zero(3);
    for (const RowMatrix& trajectory : samples.trajectories) {
        ASSERT_EQ(trajectory.row(0), start.row(0));
        const Eigen::RowVectorXd from = trajectory.row(1) - mean;
        sum += from / count;
        squares += from.cwiseAbs2() / count;
    }
    for (Eigen::Index d = 0; d < 3; ++d) {
        EXPECT_NEAR(sum[d], 0, 4 * std::sqrt(variance / count));
        EXPECT_NEAR(squares[d], variance, 4 * variance * std::sqrt(2.0 / count));
    }
}

TEST(TrajectorySamples, varyAroundWhatWasLearned)
{
    const LatentLoops loops = latentLoops(4, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const TrajectorySamples samples = sampleTrajectories(dynamics, loops.trajectory(1), 20, 1);
    const HmcReport& r = samples.report;
    EXPECT_GE(r.acceptance, 0.6);
    EXPECT_LE(r.acceptance, 0.9);
    EXPECT_TRUE(r.effectiveSampleSize >= 20 || r.thinning == 160);
    for (const RowMatrix& trajectory : samples.trajectories) {
        const double distance = (trajectory - loops.trajectory(1)).rowwise().norm().mean();
        EXPECT_GT(distance, 0.01);
        EXPECT_LT(distance, 1);
    }
}
