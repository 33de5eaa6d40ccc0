// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/core/random.h"
#include "model/variation/sampling.h"
#include "plaindynamics.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

// One pair, x = 0 → x′ = 1, with β₁ = 2, β₂ = 2, β₃ = 3, β₄ = 1: K = 2 + 1 = 3, k(z) = 2·e^(−z²).
TEST(GpdmDynamics, solvesOnePairAsByHand)
{
    GpdmState state{.latents = RowMatrix(2, 1),
                    .hyperparameters = {.beta1 = 2, .beta2 = 2, .beta3 = 3, .beta4 = 1}};
    state.latents << 0, 1;
    const RowSpan span{0, 2};
    const GpdmDynamics dynamics(state, std::span(&span, 1));
    const Eigen::RowVectorXd at = Eigen::RowVectorXd::Constant(1, 0.5);
    const double k = 2 * std::exp(-0.25);
    EXPECT_NEAR(dynamics.next(at)[0], k / 3, 1e-14);
    const double variance = 2 + 3 * 0.25 + 1 - k * k / 3;
    EXPECT_NEAR(dynamics.variance(at), variance, 1e-14);
    RowMatrix trajectory(2, 1);
    trajectory << 0.5, 0.9;
    const double residual = 0.9 - k / 3;
    RowMatrix gradient;
    EXPECT_NEAR(dynamics.energy(trajectory, &gradient),
                0.5 * std::log(variance) + 0.5 * residual * residual / variance, 1e-14);
    EXPECT_EQ(gradient(0, 0), 0);
    EXPECT_NEAR(gradient(1, 0), residual / variance, 1e-14);
}

// The inverse of the plain formula loses about the condition of K_X, 1e5, times the precision.
TEST(GpdmDynamics, energyIsThatOfThePlainFormula)
{
    const LatentLoops loops = latentLoops(3, 15);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const PlainDynamics plain(loops);
    for (const double noise : {0.0, 0.02, 0.5}) {
        const RowMatrix trajectory = loops.trajectory(1) + noise * normals(15, 3, 7);
        const double expected = plain.energy(trajectory);
        EXPECT_NEAR(dynamics.energy(trajectory), expected, 1e-8 * (100 + std::abs(expected))) << noise;
    }
}

TEST(GpdmDynamics, gradientIsThatOfFiniteDifferences)
{
    const LatentLoops loops = latentLoops(2, 12);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    for (const double noise : {0.01, 0.3}) {
        RowMatrix trajectory = loops.trajectory(0) + noise * normals(12, 3, 3);
        RowMatrix gradient;
        dynamics.energy(trajectory, &gradient);
        EXPECT_EQ(gradient.row(0).norm(), 0);
        const double scale = gradient.cwiseAbs().maxCoeff();
        for (Eigen::Index i = 1; i < trajectory.rows(); ++i)
            for (Eigen::Index d = 0; d < 3; ++d) {
                constexpr double h = 1e-5;
                const double kept = trajectory(i, d);
                trajectory(i, d) = kept + h;
                const double above = dynamics.energy(trajectory);
                trajectory(i, d) = kept - h;
                const double below = dynamics.energy(trajectory);
                trajectory(i, d) = kept;
                EXPECT_NEAR(gradient(i, d), (above - below) / (2 * h), 1e-5 * scale) << i << ' ' << d;
            }
    }
}

TEST(GpdmDynamics, meanPredictionFollowsWhatWasLearned)
{
    const LatentLoops loops = latentLoops(1, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix predicted = dynamics.meanPrediction(loops.state.latents.row(0), 40);
    EXPECT_EQ(predicted.row(0), loops.state.latents.row(0));
    EXPECT_EQ(predicted.row(1), dynamics.next(predicted.row(0)));
    EXPECT_LT((predicted - loops.state.latents).rowwise().norm().maxCoeff(), 0.15);
}

// By the chain rule: what is drawn position after position has the density of the whole.
TEST(GpdmDynamics, trajectoriesOfInnovationsHaveTheirDensity)
{
    const LatentLoops loops = latentLoops(3, 12);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const PlainDynamics plain(loops);
    const Eigen::RowVectorXd start = loops.state.latents.row(0);
    constexpr Eigen::Index frames = 7;
    EXPECT_LT(
        (dynamics.trajectory(start, RowMatrix::Zero(frames - 1, 3)) - dynamics.meanPrediction(start, frames))
            .norm(),
        1e-9);
    Random random(3);
    RowMatrix innovations(frames - 1, 3);
    for (double& value : innovations.reshaped())
        value = random.normal();
    const RowMatrix trajectory = dynamics.trajectory(start, innovations);
    EXPECT_EQ(trajectory.row(0), start);
    const auto [mean, covariance] = plain.joint(trajectory.topRows(frames - 1));
    const double determinant = std::log(covariance.determinant());
    EXPECT_NEAR(dynamics.energy(trajectory) - 0.5 * 3 * determinant, 0.5 * innovations.squaredNorm(), 1e-6);
}

TEST(GpdmDynamics, isSureWhereItWasTaughtAndUnsureElsewhere)
{
    const LatentLoops loops = latentLoops(2, 30);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const GpdmHyperparameters& p = loops.state.hyperparameters;
    EXPECT_LT(dynamics.variance(loops.state.latents.row(10)), 3 / p.beta4);
    EXPECT_GT(dynamics.variance(Eigen::RowVectorXd::Constant(3, 9)), p.beta1);
}

TEST(GpdmDynamics, oneFrameHasNeitherEnergyNorGradient)
{
    const LatentLoops loops = latentLoops(1, 5);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    RowMatrix gradient;
    EXPECT_EQ(dynamics.energy(loops.state.latents.topRows(1), &gradient), 0);
    EXPECT_EQ(gradient.norm(), 0);
}

// All frames alike and no noise to speak of: the kernel matrix is singular in double precision.
TEST(GpdmDynamics, staysFiniteWithASingularKernel)
{
    LatentLoops loops = latentLoops(2, 10);
    loops.state.latents.setConstant(0.7);
    loops.state.hyperparameters.beta1 = 1e6;
    loops.state.hyperparameters.beta4 = 1e14;
    const GpdmDynamics dynamics(loops.state, loops.spans);
    EXPECT_NEAR(dynamics.next(loops.state.latents.row(0))[0], 0.7, 1e-3);
    EXPECT_TRUE(dynamics.meanPrediction(loops.state.latents.row(0), 10).allFinite());
}
