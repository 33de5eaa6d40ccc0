// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/variation/sampling.h"
#include "tests/model/codeof.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <limits>
#include <tbb/task_arena.h>
#include <thread>

using namespace quadrille;
using namespace quadrille::test;

namespace {

constexpr TrajectoryLimits anywhere{.reach = std::numeric_limits<double>::infinity()};

Eigen::VectorXd laterPositions(const RowMatrix& trajectory)
{
    return Eigen::Map<const Eigen::VectorXd>(trajectory.data() + trajectory.cols(),
                                             trajectory.size() - trajectory.cols());
}

struct Moments
{
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;
};

template <typename Samples>
Moments momentsOf(const Samples& samples)
{
    const auto n = static_cast<double>(samples.size());
    Moments moments{.mean = Eigen::VectorXd::Zero(samples[0].size()),
                    .variance = Eigen::VectorXd::Zero(samples[0].size())};
    for (const Eigen::VectorXd& sample : samples)
        moments.mean += sample / n;
    for (const Eigen::VectorXd& sample : samples)
        moments.variance += (sample - moments.mean).cwiseAbs2() / n;
    return moments;
}

/// A chain in the positions themselves, with the energy and its gradient; its mass are the energy's second
/// derivatives at the mean prediction.
HmcChain drawInPositions(const GpdmDynamics& dynamics, const RowMatrix& trajectory, int count)
{
    RowMatrix mean = dynamics.meanPrediction(trajectory.row(0), trajectory.rows());
    const auto evaluate = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        RowMatrix moved = mean;
        moved.bottomRows(mean.rows() - 1) =
            Eigen::Map<const RowMatrix>(x.data(), mean.rows() - 1, mean.cols());
        RowMatrix byPositions;
        const double energy = dynamics.energy(moved, &byPositions);
        gradient = laterPositions(byPositions);
        return energy;
    };
    const Eigen::VectorXd start = laterPositions(mean);
    Eigen::MatrixXd second(start.size(), start.size());
    for (Eigen::Index i = 0; i < start.size(); ++i) {
        const Eigen::VectorXd step = 1e-4 * Eigen::VectorXd::Unit(start.size(), i);
        Eigen::VectorXd above;
        Eigen::VectorXd below;
        evaluate(start + step, above);
        evaluate(start - step, below);
        second.col(i) = (above - below) / 2e-4;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (second + second.transpose()));
    const Eigen::VectorXd values =
        solver.eigenvalues().cwiseAbs().cwiseMax(1e-3 * solver.eigenvalues().maxCoeff());
    return drawByHmc(evaluate, start,
                     solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose(), count,
                     5, {.thinning = 2});
}

} // namespace

// Two frames: given the first, the second is Gaussian with the mean and the variance of eq. 9 and 10.
TEST(TrajectorySamples, ofTwoFramesHaveTheMeanAndVarianceOfThePrediction)
{
    const LatentLoops loops = latentLoops(2, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix start = loops.trajectory(0).topRows(2);
    constexpr int count = 2000;
    const TrajectorySamples samples =
        sampleTrajectories(dynamics, start, count, 3, {.thinning = 1}, {}, anywhere);
    ASSERT_EQ(samples.trajectories.size(), static_cast<std::size_t>(count));
    const Eigen::RowVectorXd mean = dynamics.next(start.row(0));
    const double variance = dynamics.variance(start.row(0));
    std::vector<Eigen::VectorXd> later;
    for (const RowMatrix& trajectory : samples.trajectories) {
        ASSERT_EQ(trajectory.row(0), start.row(0));
        later.push_back(laterPositions(trajectory));
    }
    const Moments moments = momentsOf(later);
    for (Eigen::Index d = 0; d < 3; ++d) {
        EXPECT_NEAR(moments.mean[d], mean[d], 4 * std::sqrt(variance / count));
        EXPECT_NEAR(moments.variance[d], variance, 4 * variance * std::sqrt(2.0 / count));
    }
}

// Both chains have the joint conditional as their target, one by its energy and gradient, one by innovations.
// Means of n independent draws from distributions with variance v differ by about √(2·v/n), their variances
// by about 2·v/√n (somewhat more where tails are long); five of that are allowed.
TEST(TrajectorySamples, haveTheMomentsOfAChainInPositions)
{
    LatentLoops loops = latentLoops(3, 12);
    loops.state.hyperparameters.beta4 = 300;
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix trajectory = loops.trajectory(1).topRows(6);
    const HmcChain inPositions = drawInPositions(dynamics, trajectory, 1500);
    const TrajectorySamples samples =
        sampleTrajectories(dynamics, trajectory, 1500, 6, {.thinning = 1}, {}, anywhere);
    EXPECT_GE(inPositions.report.effectiveSampleSize, 1000);
    std::vector<Eigen::VectorXd> later;
    for (const RowMatrix& sample : samples.trajectories)
        later.push_back(laterPositions(sample));
    const Moments expected = momentsOf(inPositions.samples);
    const Moments found = momentsOf(later);
    const double n = std::min(1500.0, inPositions.report.effectiveSampleSize);
    for (Eigen::Index i = 0; i < expected.mean.size(); ++i) {
        const double variance = expected.variance[i];
        EXPECT_NEAR(found.mean[i], expected.mean[i], 5 * std::sqrt(2 * variance / n)) << i;
        EXPECT_NEAR(found.variance[i], variance, 5 * 2 * variance / std::sqrt(n)) << i;
    }
}

TEST(TrajectorySamples, varyAroundWhatWasLearnedAndAreWorthTheirNumber)
{
    const LatentLoops loops = latentLoops(4, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    for (const std::size_t sequence : {std::size_t{0}, std::size_t{2}}) {
        const RowMatrix learned = loops.trajectory(sequence);
        const TrajectorySamples samples = sampleTrajectories(dynamics, learned, 20, 1);
        const HmcReport& report = samples.report;
        EXPECT_GE(report.acceptance, 0.6);
        EXPECT_LE(report.acceptance, 0.9);
        EXPECT_GE(report.effectiveSampleSize, 20);
        EXPECT_LT(std::abs(report.lag1), 1);
        ASSERT_EQ(samples.energies.size(), 20u);
        for (std::size_t i = 0; i < 20; ++i) {
            const RowMatrix& trajectory = samples.trajectories[i];
            const double distance = (trajectory - learned).rowwise().norm().mean();
            EXPECT_GT(distance, 0.01);
            EXPECT_LE(dynamics.furthestFromTraining(trajectory), 1);
            EXPECT_EQ(samples.energies[i], dynamics.energy(trajectory));
        }
    }
}

TEST(TrajectorySamples, comeCloserToTheMeanPredictionWithLessSpread)
{
    const LatentLoops loops = latentLoops(3, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix learned = loops.trajectory(0);
    const RowMatrix mean = dynamics.meanPrediction(learned.row(0), 20);
    const auto distance = [&](double spread) {
        TrajectoryLimits limits = anywhere;
        limits.spread = spread;
        double sum = 0;
        for (const RowMatrix& trajectory :
             sampleTrajectories(dynamics, learned, 10, 1, {}, {}, limits).trajectories)
            sum += (trajectory - mean).norm();
        return sum;
    };
    EXPECT_LT(distance(0), 1e-6);
    EXPECT_LT(distance(0.2), 0.5 * distance(1));
    EXPECT_GT(distance(0.2), 0.02 * distance(1));
}

TEST(TrajectorySamples, followFromTheSeedWithAnyNumberOfThreads)
{
    const LatentLoops loops = latentLoops(2, 15);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const auto draw = [&](std::uint64_t seed, int threads) {
        std::vector<RowMatrix> trajectories;
        tbb::task_arena(threads).execute(
            [&] { trajectories = sampleTrajectories(dynamics, loops.trajectory(0), 4, seed).trajectories; });
        return trajectories;
    };
    const std::vector<RowMatrix> one = draw(7, 1);
    EXPECT_EQ(one, draw(7, 4));
    EXPECT_NE(one, draw(8, 1));
    EXPECT_NE(one[0], one[1]);
}

TEST(TrajectorySamples, ofOneFrameAreThatFrame)
{
    const LatentLoops loops = latentLoops(1, 5);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix frame = loops.state.latents.topRows(1);
    const TrajectorySamples samples = sampleTrajectories(dynamics, frame, 3, 1);
    ASSERT_EQ(samples.trajectories.size(), 3u);
    for (const RowMatrix& trajectory : samples.trajectories)
        EXPECT_EQ(trajectory, frame);
}

TEST(TrajectorySamples, refuseWhatHasNoSense)
{
    const LatentLoops loops = latentLoops(1, 5);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    EXPECT_EQ(codeOf([&] { sampleTrajectories(dynamics, RowMatrix(0, 3), 1, 1); }), ErrorCode::BadArgument);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const TrajectoryLimits& limits :
         {TrajectoryLimits{.spread = -1}, TrajectoryLimits{.spread = infinity}, TrajectoryLimits{.reach = -1},
          TrajectoryLimits{.reach = NAN}})
        EXPECT_EQ(codeOf([&] { sampleTrajectories(dynamics, loops.state.latents, 1, 1, {}, {}, limits); }),
                  ErrorCode::BadArgument);
    EXPECT_TRUE(sampleTrajectories(dynamics, loops.state.latents, 0, 1).trajectories.empty());
}

TEST(TrajectorySamples, keepWithinTheReachAndSayWhatThatTook)
{
    const LatentLoops loops = latentLoops(4, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const RowMatrix learned = loops.trajectory(2);
    const TrajectorySamples free = sampleTrajectories(dynamics, learned, 10, 1, {}, {}, anywhere);
    EXPECT_EQ(free.spread, 1);
    EXPECT_EQ(free.rejected, 0);
    const TrajectorySamples kept = sampleTrajectories(dynamics, learned, 10, 1, {}, {}, {.reach = 0.25});
    EXPECT_LT(kept.spread, 1);
    EXPECT_EQ(kept.beyondReach, 0);
    for (const RowMatrix& trajectory : kept.trajectories)
        EXPECT_LE(dynamics.furthestFromTraining(trajectory), 0.25);
    // Nothing keeps within this: the nearest are given, and counted.
    const TrajectorySamples none = sampleTrajectories(dynamics, learned, 10, 1, {}, {}, {.reach = 1e-9});
    EXPECT_EQ(none.beyondReach, 10);
    EXPECT_EQ(none.rejected, 80);
    ASSERT_EQ(none.trajectories.size(), 10u);
    EXPECT_LE(dynamics.furthestFromTraining(none.trajectories[0]),
              dynamics.furthestFromTraining(none.trajectories[9]));
}

TEST(TrajectorySamples, theFirstStayWhenMoreAreAskedFor)
{
    const LatentLoops loops = latentLoops(2, 20);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    const auto few = sampleTrajectories(dynamics, loops.trajectory(0), 5, 3).trajectories;
    const auto more = sampleTrajectories(dynamics, loops.trajectory(0), 9, 3).trajectories;
    for (std::size_t i = 0; i < few.size(); ++i)
        EXPECT_EQ(few[i], more[i]);
}

TEST(TrajectorySamples, stopSoonAfterTheyWereCancelled)
{
    const LatentLoops loops = latentLoops(5, 40);
    const GpdmDynamics dynamics(loops.state, loops.spans);
    for (const double when : {0.1, 0.6}) {
        CancelToken token;
        double last = 0;
        const Progress progress(token, [&](double done) {
            last = done;
            if (done > when)
                token.cancel();
        });
        EXPECT_EQ(codeOf([&] { sampleTrajectories(dynamics, loops.trajectory(0), 200, 1, {}, progress); }),
                  ErrorCode::Cancelled);
        EXPECT_LT(last, when + 0.02);
    }
}
