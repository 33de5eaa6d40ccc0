// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/transition/poseinterpolation.h"
#include "tests/model/transition/bars.h"

#include <atomic>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace quadrille {
namespace {

/// Two windows of poses of a bar and a path through them, longer than what is computed at a time.
struct Blend
{
    Bar bar = makeBar(15, 2, 2.0F, 0.3F);
    std::shared_ptr<const PoissonSystem> system = std::make_shared<const PoissonSystem>(bar.topology);
    std::vector<std::vector<Vec3f>> poses;
    std::vector<Positions> sources;
    std::vector<Positions> targets;
    std::vector<BlendStep> steps;

    Blend()
    {
        for (int f = 0; f < 50; ++f)
            poses.push_back(bent(shaken(bar.positions, 0.01, static_cast<unsigned>(f)), 2.0, 0.5 + 0.02 * f));
        for (int f = 0; f < 50; ++f)
            (f < 25 ? sources : targets).push_back(poses[static_cast<std::size_t>(f)]);
        for (int t = 0; t < 70; ++t) {
            BlendStep step{t * 24 / 69, t * t * 24 / (69 * 69), t / 69.0, {}, {}};
            step.placeTarget.translation = Vec3d(0.1, 0, 0.01 * t);
            steps.push_back(step);
        }
    }
    std::vector<Vec3f> run(InterpolationMethod method, const Progress& progress = {}) const
    {
        return blendPoses(system, sources, targets, steps, method, progress);
    }
};

TEST(BlendPoses, InterpolatesEveryStep)
{
    const Blend blend;
    const std::size_t count = blend.bar.positions.size();
    for (const InterpolationMethod method :
         {InterpolationMethod::Poisson, InterpolationMethod::Slerp, InterpolationMethod::Linear}) {
        const std::vector<Vec3f> out = blend.run(method);
        ASSERT_EQ(out.size(), blend.steps.size() * count);
        for (std::size_t t = 0; t < blend.steps.size(); ++t) {
            const BlendStep& step = blend.steps[t];
            const auto pose = [&](Positions positions) {
                return std::make_shared<const PreparedPose>(blend.system, positions);
            };
            std::vector<Vec3f> expected(count);
            PoseInterpolation(pose(blend.sources[static_cast<std::size_t>(step.source)]),
                              pose(blend.targets[static_cast<std::size_t>(step.target)]))
                .at(step.lambda, expected, method, step.placeSource, step.placeTarget);
            EXPECT_TRUE(std::ranges::equal(expected, Positions(out).subspan(t * count, count))) << t;
        }
    }
}

TEST(BlendPoses, GivesTheSameOnAnyNumberOfThreads)
{
    const Blend blend;
    const std::vector<Vec3f> parallel = blend.run(InterpolationMethod::Poisson);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(blend.run(InterpolationMethod::Poisson), parallel);
}

TEST(BlendPoses, ReportsProgressToTheEnd)
{
    std::atomic<double> last = 0;
    std::atomic<int> calls = 0;
    Blend().run(InterpolationMethod::Poisson, Progress({}, [&](double fraction) {
                    last = fraction;
                    ++calls;
                }));
    EXPECT_EQ(last, 1.0);
    EXPECT_GT(calls, 70);
}

TEST(BlendPoses, CanBeCancelled)
{
    CancelToken token;
    std::atomic<int> calls = 0;
    try {
        Blend().run(InterpolationMethod::Poisson, Progress(token, [&](double) {
                        if (++calls == 10)
                            token.cancel();
                    }));
        FAIL() << "went on";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
        EXPECT_LT(calls, 20);
    }
}

TEST(BlendPoses, OfNoStepsIsEmpty)
{
    Blend blend;
    blend.steps.clear();
    EXPECT_TRUE(blend.run(InterpolationMethod::Poisson).empty());
}

} // namespace
} // namespace quadrille
