// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"
#include "posedloops.h"
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

/// All that the chain draws, its samples next to each other.
constexpr SamplingSettings anywhere{.chain = {.thinning = 1},
                                    .limits = {.uncertainty = std::numeric_limits<double>::infinity()}};

TrajectorySamples sampled(const PosedLoops& posed, std::size_t sequence, int count, std::uint64_t seed,
                          const SamplingSettings& settings = {}, const Progress& progress = {})
{
    return sampleTrajectories(posed.dynamics, posed.poses, {posed.loops.trajectory(sequence)}, count, seed,
                              settings, progress);
}

double furthest(const PosedLoops& posed, const TrajectorySamples& samples)
{
    double uncertainty = 0;
    for (const RowMatrix& trajectory : samples.trajectories)
        uncertainty = std::max(uncertainty, posed.poses.posed(trajectory).uncertainty);
    return uncertainty;
}

Eigen::VectorXd laterPositions(const RowMatrix& trajectory)
{
    return Eigen::Map<const Eigen::VectorXd>(trajectory.data() + trajectory.cols(),
                                             trajectory.size() - trajectory.cols());
}

struct SampleMoments
{
    Eigen::VectorXd mean;
    Eigen::VectorXd variance;
};

template <typename Samples>
SampleMoments momentsOf(const Samples& samples)
{
    const auto n = static_cast<double>(samples.size());
    SampleMoments moments{.mean = Eigen::VectorXd::Zero(samples[0].size()),
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

// Two frames: given the first, the second is Gaussian with the variance of eq. 10.
TEST(TrajectorySamples, ofTwoFramesHaveTheVarianceOfThePrediction)
{
    const PosedLoops posed(2, 20);
    const RowMatrix start = posed.loops.trajectory(0).topRows(2);
    constexpr int count = 2000;
    const TrajectorySamples samples =
        sampleTrajectories(posed.dynamics, posed.poses, {start}, count, 3, anywhere);
    ASSERT_EQ(samples.trajectories.size(), static_cast<std::size_t>(count));
    const double scale = samples.report.scale;
    ASSERT_GT(scale, 0);
    const double variance = scale * scale * posed.dynamics.variance(start.row(0));
    std::vector<Eigen::VectorXd> later;
    for (const RowMatrix& trajectory : samples.trajectories) {
        ASSERT_EQ(trajectory.row(0), start.row(0));
        later.push_back(laterPositions(trajectory));
    }
    const SampleMoments moments = momentsOf(later);
    // The first 24 say where the middle is.
    for (Eigen::Index d = 0; d < 3; ++d) {
        EXPECT_NEAR(moments.mean[d], start(1, d), 5 * std::sqrt(variance / 24));
        EXPECT_NEAR(moments.variance[d], variance, 5 * variance * std::sqrt(2.0 / count));
    }
}

// Waves make any trajectory of so few frames: both chains have the joint conditional as their target, one in
// positions, one in waves. Variances of n independent draws from distributions with variance v differ by
// about 2·v/√n (somewhat more where tails are long); five of that are allowed.
TEST(TrajectorySamples, haveTheVariancesOfAChainInPositions)
{
    LatentLoops loops = latentLoops(3, 12);
    loops.state.hyperparameters.beta4 = 300;
    const PosedLoops posed(std::move(loops));
    const RowMatrix trajectory = posed.loops.trajectory(1).topRows(6);
    const HmcChain inPositions = drawInPositions(posed.dynamics, trajectory, 1500);
    SamplingSettings settings = anywhere;
    settings.chain.thinning = 4;
    const TrajectorySamples samples =
        sampleTrajectories(posed.dynamics, posed.poses, {trajectory}, 1500, 6, settings);
    EXPECT_GE(inPositions.report.effectiveSampleSize, 1000);
    std::vector<Eigen::VectorXd> later;
    for (const RowMatrix& sample : samples.trajectories)
        later.push_back(laterPositions(sample) / samples.report.scale);
    const SampleMoments expected = momentsOf(inPositions.samples);
    const SampleMoments found = momentsOf(later);
    const double n = std::min(1500.0, inPositions.report.effectiveSampleSize);
    for (Eigen::Index i = 0; i < expected.mean.size(); ++i)
        EXPECT_NEAR(found.variance[i], expected.variance[i], 5 * 2 * expected.variance[i] / std::sqrt(n))
            << i;
}

TEST(TrajectorySamples, varyAroundWhatWasLearnedAndAreWorthTheirNumber)
{
    const PosedLoops posed(4, 40);
    for (const std::size_t sequence : {std::size_t{0}, std::size_t{2}}) {
        const RowMatrix learned = posed.loops.trajectory(sequence);
        const TrajectorySamples samples = sampled(posed, sequence, 20, 1);
        const HmcReport& chain = samples.report.chain;
        EXPECT_GE(chain.acceptance, 0.6);
        EXPECT_LE(chain.acceptance, 0.9);
        EXPECT_GE(chain.effectiveSampleSize, 20);
        EXPECT_LT(std::abs(chain.lag1), 1);
        ASSERT_EQ(samples.trajectories.size(), 20u);
        RowMatrix mean = RowMatrix::Zero(40, 3);
        double apart = 0;
        for (const RowMatrix& trajectory : samples.trajectories) {
            EXPECT_EQ(trajectory.row(0), learned.row(0));
            mean += trajectory / 20;
            apart += (trajectory - learned).norm() / 20;
        }
        EXPECT_GT(apart, 0.1);
        EXPECT_LT((mean - learned).norm(), 0.5 * apart);
    }
}

// As many as decide on the scale, none too unsure: their spread is the one that was asked for.
TEST(TrajectorySamples, areAsFarApartAsWasAskedFor)
{
    const PosedLoops posed(4, 40);
    double before = 0;
    for (const double spread : {0.1, 0.3, 0.6, 1.0}) {
        SamplingSettings settings;
        settings.limits.spread = spread;
        const TrajectorySamples samples = sampled(posed, 1, 24, 1, settings);
        ASSERT_EQ(samples.report.rejected, 0);
        EXPECT_NEAR(samples.report.spread, spread, 0.011 * spread);
        std::vector<PosedTrajectory> each;
        for (const RowMatrix& trajectory : samples.trajectories)
            each.push_back(posed.poses.posed(trajectory));
        EXPECT_NEAR(posed.poses.between(each) / posed.poses.reference(), samples.report.spread, 1e-9);
        EXPECT_GT(samples.report.scale, before);
        before = samples.report.scale;
    }
}

TEST(TrajectorySamples, ofOneTakeDifferByAShareOfHowFarItMoves)
{
    const PosedLoops one(1, 40);
    SamplingSettings settings;
    settings.limits.spread = 0.4;
    const TrajectorySamples samples = sampled(one, 0, 24, 1, settings);
    EXPECT_NEAR(samples.report.spread, 0.4, 0.005);
    EXPECT_GT(one.poses.reference(), 0);
}

TEST(TrajectorySamples, withoutSpreadRepeatTheTake)
{
    const PosedLoops posed(3, 20);
    SamplingSettings settings;
    settings.limits.spread = 0;
    for (const RowMatrix& trajectory : sampled(posed, 0, 5, 1, settings).trajectories)
        EXPECT_EQ(trajectory, posed.loops.trajectory(0));
}

TEST(TrajectorySamples, ofWhatStandsStillStandStill)
{
    LatentLoops loops = latentLoops(2, 15);
    loops.state.latents.setZero();
    const PosedLoops posed(std::move(loops));
    const TrajectorySamples samples = sampled(posed, 1, 3, 1);
    ASSERT_EQ(samples.trajectories.size(), 3u);
    for (const RowMatrix& trajectory : samples.trajectories)
        EXPECT_EQ(trajectory, posed.loops.trajectory(1));
}

TEST(TrajectorySamples, followFromTheSeedWithAnyNumberOfThreads)
{
    const PosedLoops posed(2, 15);
    const auto draw = [&](std::uint64_t seed, int threads) {
        std::vector<RowMatrix> trajectories;
        tbb::task_arena(threads).execute([&] { trajectories = sampled(posed, 0, 4, seed).trajectories; });
        return trajectories;
    };
    const std::vector<RowMatrix> one = draw(7, 1);
    EXPECT_EQ(one, draw(7, 4));
    EXPECT_NE(one, draw(8, 1));
    EXPECT_NE(one[0], one[1]);
}

TEST(TrajectorySamples, ofOneFrameAreThatFrame)
{
    const PosedLoops posed(1, 5);
    const RowMatrix frame = posed.loops.state.latents.topRows(1);
    const TrajectorySamples samples = sampleTrajectories(posed.dynamics, posed.poses, {frame}, 3, 1);
    ASSERT_EQ(samples.trajectories.size(), 3u);
    for (const RowMatrix& trajectory : samples.trajectories)
        EXPECT_EQ(trajectory, frame);
}

TEST(TrajectorySamples, refuseWhatHasNoSense)
{
    const PosedLoops posed(1, 5);
    EXPECT_EQ(codeOf([&] { sampleTrajectories(posed.dynamics, posed.poses, {RowMatrix(0, 3)}, 1, 1); }),
              ErrorCode::BadArgument);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const TrajectoryLimits& limits :
         {TrajectoryLimits{.spread = -1}, TrajectoryLimits{.spread = infinity},
          TrajectoryLimits{.uncertainty = -1}, TrajectoryLimits{.uncertainty = NAN}})
        EXPECT_EQ(codeOf([&] { sampled(posed, 0, 1, 1, {.limits = limits}); }), ErrorCode::BadArgument);
    EXPECT_TRUE(sampled(posed, 0, 0, 1).trajectories.empty());
}

TEST(TrajectorySamples, areSureAndSayWhatThatTook)
{
    const PosedLoops posed(4, 40);
    const auto limited = [](double uncertainty) {
        return SamplingSettings{.limits = {.spread = 3, .uncertainty = uncertainty}};
    };
    const TrajectorySamples free = sampled(posed, 2, 10, 1, limited(2));
    EXPECT_EQ(free.report.rejected, 0);
    const double limit = 0.2 * furthest(posed, free);
    const TrajectorySamples kept = sampled(posed, 2, 10, 1, limited(limit));
    EXPECT_LT(kept.report.scale, free.report.scale);
    EXPECT_LT(kept.report.spread, free.report.spread);
    EXPECT_GT(kept.report.spread, 0.1);
    EXPECT_EQ(kept.report.uncertain, 0);
    EXPECT_LE(furthest(posed, kept), limit);
    // No pose at all is as sure as that: the take is given, and counted.
    const TrajectorySamples none = sampled(posed, 2, 10, 1, limited(0));
    EXPECT_EQ(none.report.uncertain, 10);
    EXPECT_EQ(none.report.rejected, 24);
    ASSERT_EQ(none.trajectories.size(), 10u);
    EXPECT_EQ(none.trajectories[3], posed.loops.trajectory(2));
}

TEST(TrajectorySamples, theFirstStayWhenMoreAreAskedFor)
{
    const PosedLoops posed(2, 20);
    const auto few = sampled(posed, 0, 5, 3).trajectories;
    const auto more = sampled(posed, 0, 9, 3).trajectories;
    for (std::size_t i = 0; i < few.size(); ++i)
        EXPECT_EQ(few[i], more[i]);
}

TEST(TrajectorySamples, stopSoonAfterTheyWereCancelled)
{
    const PosedLoops posed(5, 40);
    for (const double when : {0.1, 0.955}) {
        CancelToken token;
        double last = 0;
        const Progress progress(token, [&](double done) {
            last = done;
            if (done > when)
                token.cancel();
        });
        EXPECT_EQ(codeOf([&] { sampled(posed, 0, 30, 1, {}, progress); }), ErrorCode::Cancelled);
        EXPECT_LT(last, when + 0.05);
    }
}
