// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/synthesis/cliptest.h"

#include <atomic>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

const TubeTakes& clipTakes()
{
    static const TubeTakes only(threeTakes());
    return only;
}

const Walk& someWalk()
{
    static const Walk walk{{{2, 5}, {30, 33}, {50, 50}, {12, 19}}};
    return walk;
}

/// One take twice, the second time elsewhere.
std::vector<MeshSequence> twice(const GroundMotion& elsewhere)
{
    const MeshSequence take = swayingTube(tubeTopology(12, 9), 12, 20, 0.02);
    return {take, movedOverGround(take, elsewhere)};
}

} // namespace

TEST(MakeClip, PlaysCapturedFramesAsTheyAre)
{
    const Clip clip = clipTakes().clip({{{22, 30}}});
    ASSERT_EQ(clip.frameCount(), 9);
    EXPECT_EQ(clip.fps, 25);
    for (int f = 0; f < 9; ++f) {
        EXPECT_TRUE(std::ranges::equal(clip.frame(f), clipTakes().character.frame(22 + f).positions()));
        EXPECT_EQ(clip.origins[static_cast<std::size_t>(f)], (FrameProvenance{22 + f, 22 + f}));
    }
}

TEST(MakeClip, JoinsOneMotionThatLiesElsewhereWithoutATrace)
{
    const TubeTakes two(twice({2.2, Vec2d(-7, 3)}));
    Transition transition = advancingTogether(5, 30, 6);
    const ClipPlan plan = planClip(two.roots, {{{0, 5}, {30, 39}}}, std::vector{transition});
    const Clip clip = makeClip(two.character, plan);
    ASSERT_EQ(clip.frameCount(), 20);
    // Poses that are blended are equal up to rounding, as is the turn between them.
    for (int f = 0; f < 20; ++f)
        EXPECT_LT(largestDistance(clip.frame(f), two.character.frame(f).positions()), 2e-5) << f;
}

TEST(MakeClip, ShowsTheEndsOfTransitionsExactly)
{
    const ClipPlan plan = clipTakes().plan(someWalk());
    const Clip clip = makeClip(clipTakes().character, plan);
    EXPECT_EQ(clip.frameCount(), plan.frameCount());
    for (std::size_t f = 0; f < plan.frames.size(); ++f) {
        const PlannedFrame& planned = plan.frames[f];
        EXPECT_EQ(clip.origins[f], planned.origin);
        if (planned.origin.isCaptured()) {
            EXPECT_TRUE(std::ranges::equal(clip.frame(static_cast<std::int64_t>(f)),
                                           clipTakes().placed(planned.origin.source, planned.placeSource)));
        }
    }
    const Transition transition = clipTakes().paths.get({5, 30});
    const Clip blended = blendTransition(clipTakes().character, clipTakes().roots, transition);
    ASSERT_EQ(blended.frameCount(), transition.length());
    EXPECT_TRUE(std::ranges::equal(blended.frame(0), clipTakes().character.frame(5).positions()));
    const TransitionMotion motion = transitionMotion(clipTakes().roots, transition);
    EXPECT_TRUE(
        std::ranges::equal(blended.frame(blended.frameCount() - 1), clipTakes().placed(30, motion.exit())));
}

TEST(MakeClip, KeepsTheCentreOnThePlan)
{
    for (const BlendAlignment alignment :
         {BlendAlignment::EveryStep, BlendAlignment::MidWindow, BlendAlignment::None}) {
        const PlanOptions options{.start = {0.7, Vec2d(4, -1)}, .blend = {.alignment = alignment}};
        const ClipPlan plan = clipTakes().plan(someWalk(), options);
        const Clip clip = makeClip(clipTakes().character, plan);
        double largestStep = 0;
        for (std::size_t f = 0; f < plan.frames.size(); ++f) {
            // Single precision, some metres from the origin.
            EXPECT_LT((centroid(clip.frame(static_cast<std::int64_t>(f))) - plan.frames[f].centre).norm(),
                      1e-5)
                << f;
            if (f > 0)
                largestStep =
                    std::max(largestStep, (plan.frames[f].centre - plan.frames[f - 1].centre).norm());
        }
        double largestCaptured = 0;
        for (NodeIndex node = 1; node < clipTakes().character.frameCount(); ++node) {
            if (node % 20 != 0)
                largestCaptured =
                    std::max(largestCaptured, (clipTakes().roots.centres[static_cast<std::size_t>(node)] -
                                               clipTakes().roots.centres[static_cast<std::size_t>(node) - 1])
                                                  .norm());
        }
        if (alignment == BlendAlignment::EveryStep) {
            EXPECT_LT(largestStep, largestCaptured * 1.0001);
        }
    }
}

TEST(MakeClip, MovesRigidlyWithItsInputs)
{
    const std::vector<MeshSequence> original = threeTakes();
    const Clip expected = clipTakes().clip(someWalk());
    const GroundMotion elsewhere{-1.9, Vec2d(3, 8)};
    const auto expectSame = [&](const std::vector<MeshSequence>& moved, const GroundMotion& start) {
        const TubeTakes other(moved);
        std::vector<Transition> transitions =
            transitionsOf(someWalk(), clipTakes().character.layout(), clipTakes().paths);
        const Clip clip = makeClip(other.character, planClip(other.roots, someWalk(), transitions, {start}));
        ASSERT_EQ(clip.frameCount(), expected.frameCount());
        // Positions of some metres in single precision, turns in single precision.
        EXPECT_LT(largestDistance(clip.positions, expected.positions), 5e-5);
    };
    expectSame({movedOverGround(original[0], elsewhere), original[1], original[2]}, elsewhere.inverse());
    expectSame({original[0], movedOverGround(original[1], elsewhere), original[2]}, {});
    expectSame({original[0], original[1], movedOverGround(original[2], elsewhere)}, {});
}

TEST(MakeClip, InterpolatesByTheMethodAskedFor)
{
    const ClipPlan plan = clipTakes().plan({{{2, 5}, {30, 33}}});
    const Clip linear = makeClip(clipTakes().character, plan, InterpolationMethod::Linear);
    const auto f = static_cast<std::size_t>(plan.junctions[0].first + 2);
    const PlannedFrame& planned = plan.frames[f];
    const std::vector<Vec3f> source = clipTakes().placed(planned.origin.source, planned.placeSource);
    const std::vector<Vec3f> destination =
        clipTakes().placed(planned.origin.destination, planned.placeDestination);
    std::vector<Vec3f> expected;
    for (std::size_t v = 0; v < source.size(); ++v)
        expected.push_back(((1 - planned.origin.lambda) * source[v].cast<double>() +
                            planned.origin.lambda * destination[v].cast<double>())
                               .cast<float>());
    EXPECT_LT(largestDistance(linear.frame(static_cast<std::int64_t>(f)), expected), 1e-6);
    EXPECT_NE(linear.positions, makeClip(clipTakes().character, plan).positions);
    EXPECT_NE(makeClip(clipTakes().character, plan, InterpolationMethod::Slerp).positions, linear.positions);
}

TEST(MakeClip, IsTheSameOnAnyNumberOfThreads)
{
    // More blended frames than are computed at a time.
    Walk walk;
    for (int k = 0; k < 80; ++k)
        walk.spans.push_back({k % 3 * 20 + 9, k % 3 * 20 + 9 + k % 2});
    const ClipPlan plan = clipTakes().plan(walk);
    const Clip parallel = makeClip(clipTakes().character, plan);
    ASSERT_GT(std::ranges::count_if(plan.frames, [](const auto& f) { return !f.origin.isCaptured(); }), 128);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(makeClip(clipTakes().character, plan).positions, parallel.positions);
    const ClipPlayer player(clipTakes().character, plan);
    for (std::int64_t f = 0; f < player.frameCount(); f += 3)
        EXPECT_TRUE(std::ranges::equal(player.frame(f), parallel.frame(f))) << f;
}

TEST(MakeClip, StopsWhenCancelled)
{
    const ClipPlan plan = clipTakes().plan(someWalk());
    std::atomic<double> last = 0;
    makeClip(clipTakes().character, plan, InterpolationMethod::Poisson,
             Progress({}, [&](double fraction) { last = fraction; }));
    EXPECT_EQ(last, 1.0);
    for (const double when : {0.0, 0.05, 0.5}) {
        CancelToken token;
        const Progress progress(token, [&](double fraction) {
            if (fraction >= when)
                token.cancel();
        });
        try {
            makeClip(clipTakes().character, plan, InterpolationMethod::Poisson, progress);
            ADD_FAILURE() << when;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Cancelled);
        }
    }
}

TEST(ClipOfRealTakes, GoesOnAcrossTransitions)
{
    if (!realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    std::vector<MeshSequence> real;
    for (const char* name : {"walk_1", "walk_turn_left_1", "run_1"})
        real.push_back(*realTake(name));
    const CharacterFrames character(real);
    const RootPoses roots = rootPoses(character, UpAxis::Y);
    const Table<float> distances = poseDistances(character).distances;
    const WarpPaths paths(distances, character.layout(), {.fps = 30});
    const Walk walk{{{0, 20}, {90, 95}, {140, 145}, {40, 60}}};
    const ClipPlan plan = planClip(roots, character.layout(), paths, walk);
    const Clip clip = makeClip(character, plan);
    double fastest = 0;
    for (NodeIndex node = 1; node < character.frameCount(); ++node) {
        if (character.layout().sequenceOf(node) == character.layout().sequenceOf(node - 1))
            fastest = std::max(fastest, (roots.centres[static_cast<std::size_t>(node)] -
                                         roots.centres[static_cast<std::size_t>(node) - 1])
                                            .norm());
    }
    for (std::int64_t f = 1; f < clip.frameCount(); ++f) {
        EXPECT_LT((centroid(clip.frame(f)) - centroid(clip.frame(f - 1))).norm(), fastest * 1.02) << f;
        EXPECT_LT((centroid(clip.frame(f)) - plan.frames[static_cast<std::size_t>(f)].centre).norm(), 1e-3);
    }
}
