// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/core/symmetriceigen.h"
#include "model/variation/smoothdeviations.h"

#include <gtest/gtest.h>
#include <numbers>

using namespace quadrille;
using namespace quadrille::test;

TEST(SmoothDeviations, beginWhereTheTrajectoryDoes)
{
    const LatentLoops loops = latentLoops(2, 30);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const SmoothDeviations smooth(dynamics, {loops.trajectory(0)});
    const RowMatrix deviation = smooth.deviation(normals(smooth.size(), 1, 4));
    ASSERT_EQ(deviation.rows(), 30);
    EXPECT_EQ(deviation.row(0).norm(), 0);
    EXPECT_GT(deviation.row(1).norm(), 0);
}

// The shortest of six waves has 5½ half periods on 39½ frames: second differences are at most the square of
// its frequency. Those of noise are 2.4 times the noise.
TEST(SmoothDeviations, bendNoFasterThanTheShortestWave)
{
    const LatentLoops loops = latentLoops(2, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const SmoothDeviations smooth(dynamics, {loops.trajectory(0)});
    ASSERT_EQ(smooth.size(), 6 * 3);
    const RowMatrix d = smooth.deviation(normals(smooth.size(), 1, 5));
    const RowMatrix bends = d.bottomRows(38) - 2 * d.middleRows(1, 38) + d.topRows(38);
    const double frequency = 5.5 * std::numbers::pi / 39.5;
    EXPECT_LE(bends.norm(), frequency * frequency * d.norm());
}

// The reference has 24 frames for what the take passes in four: where the take is quick on the reference,
// deviations change as slowly from frame to frame as the reference does.
TEST(SmoothDeviations, areSmoothInTheTimeOfTheTake)
{
    const LatentLoops loops = latentLoops(2, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    std::vector<double> times;
    for (int f = 0; f < 40; ++f)
        times.push_back(f < 8 ? f : f < 32 ? 8 + (f - 8) / 6.0 : f - 20);
    const SmoothDeviations smooth(dynamics, {loops.trajectory(0), times});
    double slow = 0;
    double quick = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const RowMatrix d = smooth.deviation(normals(smooth.size(), 1, seed));
        ASSERT_EQ(d.row(0).norm(), 0);
        slow += (d.row(20) - d.row(19)).norm();
        quick += (d.row(35) - d.row(34)).norm();
    }
    // A sixth where waves are long, no more than a quarter where they are short.
    EXPECT_LT(slow, 0.25 * quick);
}

TEST(SmoothDeviations, areAsManyAsTheTimesTellApart)
{
    const LatentLoops loops = latentLoops(2, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    std::vector<double> times(20, 3.0);
    times.front() = 0;
    const SmoothDeviations smooth(dynamics, {loops.trajectory(0), times});
    EXPECT_EQ(smooth.size(), 3);
    EXPECT_TRUE(smooth.deviation(normals(smooth.size(), 1, 5)).allFinite());
}

TEST(SmoothDeviations, takeMoreWavesWhereTheTrajectoryNeedsThem)
{
    LatentLoops loops = latentLoops(1, 40);
    for (Eigen::Index f = 0; f < 40; ++f)
        loops.state.latents.row(f).array() += std::sin(1.3 * static_cast<double>(f));
    const GpdmDynamics dynamics(loops.state, loops.spans);
    EXPECT_GT(SmoothDeviations(dynamics, {loops.trajectory(0)}).size(), 6 * 3);
    // No more than positions after the first.
    EXPECT_EQ(SmoothDeviations(dynamics, {loops.trajectory(0).topRows(2)}).size(), 3);
}

TEST(SmoothDeviations, gradientIsThatOfFiniteDifferences)
{
    const LatentLoops loops = latentLoops(3, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const SmoothDeviations smooth(dynamics, {loops.trajectory(1)});
    const Eigen::VectorXd at = 0.02 * normals(smooth.size(), 1, 6);
    Eigen::VectorXd gradient;
    EXPECT_NEAR(smooth.energy(at, gradient), dynamics.energy(loops.trajectory(1) + smooth.deviation(at)),
                1e-9);
    Eigen::VectorXd unused;
    for (Eigen::Index i = 0; i < smooth.size(); ++i) {
        const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(smooth.size(), i);
        const double slope = (smooth.energy(at + step, unused) - smooth.energy(at - step, unused)) / 2e-5;
        EXPECT_NEAR(gradient[i], slope, 1e-5 * gradient.norm()) << i;
    }
}

TEST(SmoothDeviations, curvatureIsPositiveDefiniteAndThatOfTheEnergy)
{
    const LatentLoops loops = latentLoops(3, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const SmoothDeviations smooth(dynamics, {loops.trajectory(0)});
    const Eigen::MatrixXd curvature = smooth.curvature();
    EXPECT_GT(symmetricEigen(curvature).values[0], 0);
    const Eigen::VectorXd direction = normals(smooth.size(), 1, 7).normalized();
    Eigen::VectorXd unused;
    const auto energy = [&](double step) { return smooth.energy(step * direction, unused); };
    // Fourth derivatives matter a little at this step.
    const double second = (energy(1e-3) - 2 * energy(0) + energy(-1e-3)) / 1e-6;
    EXPECT_NEAR(direction.dot(curvature * direction), second, 1e-2 * second);
}

// A trajectory that stays where it is says nothing of scales; nothing may fail.
TEST(SmoothDeviations, ofWhatStandsStillHaveACurvature)
{
    LatentLoops loops = latentLoops(1, 10);
    loops.state.latents.setZero();
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const SmoothDeviations smooth(dynamics, {loops.trajectory(0)});
    const Eigen::MatrixXd curvature = smooth.curvature();
    EXPECT_TRUE(curvature.allFinite());
    EXPECT_GT(symmetricEigen(curvature).values[0], 0);
}
