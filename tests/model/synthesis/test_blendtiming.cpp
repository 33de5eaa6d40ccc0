// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/plainalgebra.h"
#include "tests/model/synthesis/cliptest.h"

#include <gtest/gtest.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// The source waits in the middle, the destination at the beginning and the end.
Transition waiting()
{
    Transition transition{.frames = {5, 41}, .sourceWindow = 8, .destinationWindow = 7};
    transition.path = {{5, 35}, {6, 35}, {7, 35},  {8, 36},  {8, 37}, {8, 38},
                       {8, 39}, {9, 40}, {10, 41}, {11, 41}, {12, 41}};
    return transition;
}

double valueOf(const FrameTime& time)
{
    return time.frame + time.part;
}

} // namespace

TEST(BlendTiming, FollowsTheCells)
{
    const std::vector<BlendTimes> times = blendTimes(waiting(), BlendTiming::Cells);
    ASSERT_EQ(times.size(), 11U);
    EXPECT_EQ(times[4].source, (FrameTime{8, 0}));
    EXPECT_EQ(times[4].destination, (FrameTime{37, 0}));
    EXPECT_EQ(times[4].source.next(), 8);
    EXPECT_EQ((FrameTime{3, 0.5}.nearest()), 4);
    EXPECT_EQ((FrameTime{3, 0.4}.nearest()), 3);
}

TEST(BlendTiming, IsTheSameWhereBothWindowsAdvanceTogether)
{
    const Transition transition = advancingTogether(5, 38, 9);
    const std::vector<BlendTimes> cells = blendTimes(transition, BlendTiming::Cells);
    const std::vector<BlendTimes> smooth = blendTimes(transition, BlendTiming::Smooth);
    for (std::size_t t = 0; t < cells.size(); ++t) {
        EXPECT_EQ(smooth[t].source, cells[t].source);
        EXPECT_EQ(smooth[t].destination, cells[t].destination);
    }
}

TEST(BlendTiming, BalancesThePaceAgainstTheMatchOfPoses)
{
    // Waits of the path are evened out: the leads of the source are those of a plain least-squares fit.
    Transition transition{.frames = {5, 47}, .sourceWindow = 13, .destinationWindow = 13};
    transition.path = {{5, 35},  {6, 36},  {7, 38},  {8, 40},  {9, 41},  {10, 42}, {11, 43},
                       {12, 44}, {13, 45}, {14, 46}, {15, 46}, {16, 47}, {17, 47}};
    const auto count = static_cast<Eigen::Index>(transition.path.size());
    const double last = static_cast<double>(count - 1);
    const auto shareAt = [&](double t) { return t / last * t / last * (3 - 2 * t / last); };
    const auto weightOf = [](double share) { return share * (1 - share) + 1e-3; };
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    for (Eigen::Index t = 0; t < count; ++t) {
        const FramePair cell = transition.path[static_cast<std::size_t>(t)];
        const auto here = static_cast<double>(t);
        const double near = weightOf(shareAt(here)) / std::pow(0.5 * static_cast<double>(count), 2);
        normal(t, t) += near;
        right[t] = near * (cell.source - 5 - (cell.destination - 47 + last));
        if (t + 1 == count)
            break;
        const double change = weightOf((shareAt(here) + shareAt(here + 1)) / 2);
        normal.block<2, 2>(t, t) += change * Eigen::Matrix2d{{1, -1}, {-1, 1}};
    }
    // What both windows bear alike, in the shape of λ(1 − λ).
    Eigen::VectorXd missing = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd waves(count - 1);
    for (Eigen::Index t = 0; t + 1 < count; ++t) {
        const double between = (shareAt(static_cast<double>(t)) + shareAt(static_cast<double>(t + 1))) / 2;
        waves[t] = between * (1 - between);
        missing[0] += t == 0 ? 1 : 0;
        missing[t] -= 1 - between;
        missing[t + 1] += 1 - between;
    }
    waves /= waves.sum();
    normal += waves.squaredNorm() * missing * missing.transpose();
    const Eigen::VectorXd leads = solutionOf(normal, right);
    const std::vector<BlendTimes> times = blendTimes(transition, BlendTiming::Smooth);
    for (std::size_t t = 0; t < times.size(); ++t)
        EXPECT_NEAR(valueOf(times[t].source) - 5 - (valueOf(times[t].destination) - 47 + last),
                    leads[static_cast<Eigen::Index>(t)], 1e-8)
            << t;
    EXPECT_EQ(times.front().source, (FrameTime{5, 0}));
    EXPECT_EQ(times.back().destination, (FrameTime{47, 0}));
}

TEST(BlendTiming, LetsWhatShowsKeepItsPace)
{
    // Each take waits while the other one hurries, by up to two frames at a time.
    Transition transition{.frames = {5, 45}, .sourceWindow = 11, .destinationWindow = 11};
    transition.path = {{5, 35}, {5, 37},  {6, 39},  {6, 40},  {7, 42}, {7, 43},
                       {8, 43}, {10, 44}, {11, 44}, {13, 45}, {15, 45}};
    const std::vector<BlendTimes> times = blendTimes(transition, BlendTiming::Smooth);
    for (std::size_t t = 1; t < times.size(); ++t) {
        const double even = (static_cast<double>(t) - 0.5) / static_cast<double>(times.size() - 1);
        const double share = even * even * (3 - 2 * even);
        const double source = valueOf(times[t].source) - valueOf(times[t - 1].source);
        const double destination = valueOf(times[t].destination) - valueOf(times[t - 1].destination);
        EXPECT_NEAR((1 - share) * source + share * destination, 1, 0.3) << t;
        EXPECT_NEAR(source, 1, 0.1 + share) << t;
        EXPECT_NEAR(destination, 1, 1.1 - share) << t;
    }
}

TEST(BlendTiming, StaysInItsWindowsAndNeverGoesBack)
{
    const Transition transition = waiting();
    const std::vector<BlendTimes> times = blendTimes(transition, BlendTiming::Smooth);
    ASSERT_EQ(times.size(), transition.path.size());
    for (std::size_t t = 1; t < times.size(); ++t) {
        EXPECT_GE(valueOf(times[t].source), valueOf(times[t - 1].source)) << t;
        EXPECT_GE(valueOf(times[t].destination), valueOf(times[t - 1].destination)) << t;
    }
    EXPECT_LE(valueOf(times.back().source), 12);
    EXPECT_GE(valueOf(times.front().destination), 35);
    // It leaves and arrives at full speed.
    const std::size_t last = times.size() - 1;
    EXPECT_NEAR(valueOf(times[1].source) - valueOf(times[0].source), 1, 0.1);
    EXPECT_NEAR(valueOf(times[last].destination) - valueOf(times[last - 1].destination), 1, 0.1);
}

TEST(BlendTiming, OfOneFrameIsItsCell)
{
    const std::vector<BlendTimes> times = blendTimes(advancingTogether(5, 38, 1), BlendTiming::Smooth);
    ASSERT_EQ(times.size(), 1U);
    EXPECT_EQ(times[0].source, (FrameTime{5, 0}));
    EXPECT_EQ(times[0].destination, (FrameTime{38, 0}));
}

TEST(BlendTiming, ClipsShowPosesBetweenFrames)
{
    const TubeTakes takes(threeTakes());
    const Transition transition = waiting();
    const PlanOptions options{.blend = {.timing = BlendTiming::Smooth}};
    const ClipPlan plan = planClip(takes.roots, {{{5, 5}, {41, 41}}}, std::span(&transition, 1), options);
    const std::size_t f = 5;
    const PlannedFrame& planned = plan.frames[f];
    ASSERT_GT(planned.times.source.part, 0);
    EXPECT_EQ(planned.origin.source, planned.times.source.nearest());
    EXPECT_EQ(planned.origin.destination, planned.times.destination.nearest());
    EXPECT_EQ(planned.origin.lambda, planned.lambda);
    const auto pose = [&](const FrameTime& time) {
        std::vector<Vec3f> positions;
        const Frame here = takes.character.frame(time.frame);
        const Frame next = takes.character.frame(time.next());
        for (std::size_t v = 0; v < here.positions().size(); ++v)
            positions.push_back(((1 - time.part) * here.positions()[v].cast<double>() +
                                 time.part * next.positions()[v].cast<double>())
                                    .cast<float>());
        return positions;
    };
    const Ground ground(UpAxis::Z);
    const auto system = std::make_shared<const PoissonSystem>(takes.character.sequences()[0].topology);
    std::vector<Vec3f> expected(takes.character.vertexCount());
    PoseInterpolation(std::make_shared<const PreparedPose>(system, pose(planned.times.source)),
                      std::make_shared<const PreparedPose>(system, pose(planned.times.destination)))
        .at(planned.lambda, expected, InterpolationMethod::Poisson, planned.placeSource.inSpace(ground),
            planned.placeDestination.inSpace(ground));
    const ClipPlayer player(takes.character, plan);
    const Clip clip = player.clip();
    EXPECT_LT(largestDistance(clip.frame(f), expected), 1e-5);
    for (std::int64_t g = 0; g < clip.frameCount(); ++g) {
        EXPECT_TRUE(std::ranges::equal(player.frame(g), clip.frame(g)));
        EXPECT_LT((centroid(clip.frame(g)) - plan.frames[static_cast<std::size_t>(g)].centre).norm(), 1e-5);
    }
}
