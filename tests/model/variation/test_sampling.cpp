// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"
#include "plaindynamics.h"
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

/// The settings of the model's own trajectories.
SamplingSettings ofModel()
{
    SamplingSettings settings{.chain = {.thinning = 4}};
    settings.limits.draw = TrajectoryDraw::Model;
    return settings;
}

/// An exact draw from the joint conditional: position after position, each given all before it and the
/// training, by inverses.
RowMatrix ancestralDraw(const PlainDynamics& training, const Eigen::RowVectorXd& start, Eigen::Index frames,
                        Random& random)
{
    PlainDynamics known = training;
    RowMatrix trajectory(frames, start.size());
    trajectory.row(0) = start;
    for (Eigen::Index f = 1; f < frames; ++f) {
        const auto [mean, covariance] = known.joint(trajectory.row(f - 1));
        trajectory.row(f) = mean;
        for (double& value : trajectory.row(f))
            value += std::sqrt(covariance(0, 0)) * random.normal();
        known.inputs.emplace_back(trajectory.row(f - 1));
        known.outputs.emplace_back(trajectory.row(f));
    }
    return trajectory;
}

Eigen::MatrixXd covarianceOf(const std::vector<Eigen::VectorXd>& samples)
{
    const Eigen::VectorXd mean = momentsOf(samples).mean;
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(mean.size(), mean.size());
    for (const Eigen::VectorXd& sample : samples)
        covariance += (sample - mean) * (sample - mean).transpose() / static_cast<double>(samples.size());
    return covariance;
}

} // namespace

// Two frames: given the first, the second is Gaussian with the mean and the variance of eq. 9 and 10.
TEST(TrajectorySamples, ofTheModelAreExactForTwoFrames)
{
    const PosedLoops posed(2, 20);
    const RowMatrix start = posed.loops.trajectory(0).topRows(2);
    constexpr int count = 2000;
    const TrajectorySamples samples =
        sampleTrajectories(posed.dynamics, posed.poses, {start}, count, 3, ofModel());
    ASSERT_EQ(samples.trajectories.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(samples.report.scale, 1);
    const double variance = posed.dynamics.variance(start.row(0));
    const Eigen::RowVectorXd next = posed.dynamics.next(start.row(0));
    std::vector<Eigen::VectorXd> later;
    for (const RowMatrix& trajectory : samples.trajectories) {
        ASSERT_EQ(trajectory.row(0), start.row(0));
        later.push_back(laterPositions(trajectory));
    }
    const SampleMoments moments = momentsOf(later);
    const double n = std::min<double>(count, samples.report.chain.effectiveSampleSize);
    EXPECT_GE(n, 0.5 * count);
    for (Eigen::Index d = 0; d < 3; ++d) {
        EXPECT_NEAR(moments.mean[d], next[d], 5 * std::sqrt(variance / n));
        EXPECT_NEAR(moments.variance[d], variance, 5 * variance * std::sqrt(2 / n));
    }
}

// Longer ones by mean, covariance and energy, against draws position after position. Five standard errors of
// both samples are allowed; those of covariances are of Gaussian ones, twice where tails are longer.
TEST(TrajectorySamples, ofTheModelAreLikeAncestralDraws)
{
    LatentLoops loops = latentLoops(3, 12);
    loops.state.hyperparameters.beta4 = 300;
    const PlainDynamics training(loops);
    const PosedLoops posed(std::move(loops));
    constexpr Eigen::Index frames = 5;
    constexpr int count = 1500;
    const RowMatrix trajectory = posed.loops.trajectory(1).topRows(frames);
    const TrajectorySamples samples =
        sampleTrajectories(posed.dynamics, posed.poses, {trajectory}, count, 6, ofModel());
    Random random(5);
    std::vector<Eigen::VectorXd> exact;
    std::vector<Eigen::VectorXd> found;
    Eigen::VectorXd exactEnergies(count);
    Eigen::VectorXd energies(count);
    for (int i = 0; i < count; ++i) {
        const RowMatrix draw = ancestralDraw(training, trajectory.row(0), frames, random);
        const RowMatrix& sample = samples.trajectories[static_cast<std::size_t>(i)];
        exact.push_back(laterPositions(draw));
        found.push_back(laterPositions(sample));
        exactEnergies[i] = posed.dynamics.energy(draw);
        energies[i] = posed.dynamics.energy(sample);
    }
    const double n = std::min<double>(count, samples.report.chain.effectiveSampleSize) / 2;
    EXPECT_GE(n, 200);
    const Eigen::MatrixXd expected = covarianceOf(exact);
    const Eigen::MatrixXd covariance = covarianceOf(found);
    const SampleMoments exactMoments = momentsOf(exact);
    const SampleMoments moments = momentsOf(found);
    for (Eigen::Index i = 0; i < expected.rows(); ++i) {
        EXPECT_NEAR(moments.mean[i], exactMoments.mean[i], 5 * std::sqrt(expected(i, i) / n)) << i;
        for (Eigen::Index j = 0; j <= i; ++j)
            EXPECT_NEAR(covariance(i, j), expected(i, j),
                        5 * 2 * std::sqrt(expected(i, i) * expected(j, j) / n))
                << i << " " << j;
    }
    const double deviation = std::sqrt((exactEnergies.array() - exactEnergies.mean()).square().mean() / n);
    EXPECT_NEAR(energies.mean(), exactEnergies.mean(), 5 * deviation);
    // What is reported is of the chain that is delivered, one state for each sample or more.
    EXPECT_EQ(samples.report.chain.energies.back(), energies[count - 1]);
}

// However long they are: over positions, a chain of some thousand states is worth six of these.
TEST(TrajectorySamples, ofTheModelAreWorthTheirNumber)
{
    LatentLoops loops = latentLoops(3, 80);
    loops.state.hyperparameters.beta4 = 300;
    const PosedLoops posed(std::move(loops));
    const TrajectorySamples samples =
        sampleTrajectories(posed.dynamics, posed.poses, {posed.loops.trajectory(1)}, 24, 1, ofModel());
    EXPECT_GE(samples.report.chain.effectiveSampleSize, 24);
    EXPECT_GE(samples.report.chain.acceptance, 0.6);
    EXPECT_LE(samples.report.chain.acceptance, 0.9);
}

// What runs along the learned trajectory would let parts of a body hurry each on its own.
TEST(TrajectorySamples, deviateAcrossWhatWasLearned)
{
    const PosedLoops posed(4, 40);
    const RowMatrix learned = posed.loops.trajectory(1);
    const TrajectorySamples samples = sampled(posed, 1, 20, 1);
    double along = 0;
    double all = 0;
    for (const RowMatrix& trajectory : samples.trajectories) {
        for (Eigen::Index f = 1; f + 1 < learned.rows(); ++f) {
            const Eigen::RowVectorXd direction = (learned.row(f + 1) - learned.row(f - 1)).normalized();
            const Eigen::RowVectorXd deviation = trajectory.row(f) - learned.row(f);
            along += std::pow(deviation.dot(direction), 2);
            all += deviation.squaredNorm();
        }
    }
    EXPECT_GT(all, 0);
    EXPECT_LT(along, 0.01 * all);
}

// A cycle ends where it began, and goes on as it came.
TEST(TrajectorySamples, ofCyclesClose)
{
    const PosedLoops posed(4, 40);
    const RowMatrix learned = posed.loops.trajectory(1);
    const TrajectorySamples samples = sampleTrajectories(
        posed.dynamics, posed.poses, {.positions = learned, .closes = true}, 20, 1, SamplingSettings{});
    for (const RowMatrix& trajectory : samples.trajectories) {
        const RowMatrix deviation = trajectory - learned;
        const double greatest = deviation.rowwise().norm().maxCoeff();
        EXPECT_GT(greatest, 0);
        EXPECT_LT(deviation.row(39).norm(), 0.4 * greatest);
        EXPECT_LT((deviation.row(39) + deviation.row(1)).norm(), 0.6 * greatest);
    }
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
    for (const double spread : {0.1, 0.2, 0.4, 0.6}) {
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

// However far apart they are asked to be.
TEST(TrajectorySamples, areNotRestless)
{
    const PosedLoops posed(1, 40);
    SamplingSettings settings;
    settings.limits = {.spread = 20, .uncertainty = std::numeric_limits<double>::infinity()};
    const TrajectorySamples samples = sampled(posed, 0, 24, 1, settings);
    double bending = 0;
    for (const RowMatrix& trajectory : samples.trajectories)
        bending += posed.poses.bending(posed.poses.posed(trajectory)) / 24;
    EXPECT_GT(samples.report.spread, 0.05);
    EXPECT_LE(bending, 1.11 * posed.poses.bending(posed.poses.posed(posed.loops.trajectory(0))));
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
