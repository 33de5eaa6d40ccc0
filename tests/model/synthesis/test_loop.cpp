// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"
#include "model/synthesis/finishing/loop.h"
#include "model/synthesis/finishing/ownperiod.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/synthesis/clipof.h"
#include "tests/model/synthesis/errorcodeof.h"
#include "tests/model/synthesis/stridingtube.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::errorCodeOf;
using test::largestDistance;
using test::movedBy;
using test::stridingTube;

const BlendMethod uprightBlend{.up = UpAxis::Z, .pose = {}, .transitions = {}};

/// A curved walk of three periods and a half.
const test::Stride curved{.frames = 70, .period = 20, .pace = {0.03, Vec2d(0.04, 0.01)}};

TEST(Loop, OfAPeriodicMotionIsAWholeNumberOfPeriods)
{
    const Clip clip = stridingTube(curved);
    const Loop loop = seamlessLoop(clip, {}, uprightBlend);
    const auto count = static_cast<int>(loop.cycle.frameCount());
    EXPECT_EQ(count % curved.period, 0);
    EXPECT_EQ(count, 60); // the longest that fits
    // Two cycles are the motion itself, played on.
    const Clip twice = repeated(loop, 2, UpAxis::Z);
    test::Stride longer = curved;
    longer.frames = 200;
    const Clip expected = stridingTube(longer);
    for (int f = 0; f < 2 * count; ++f)
        EXPECT_LT(largestDistance(twice.frame(f), expected.frame(loop.closure.frames.destination + f)), 2e-4)
            << f;
    EXPECT_NEAR(wrappedAngle(loop.travel.turn - count * curved.pace.turn), 0, 1e-5);
}

TEST(Loop, KeepsWhatIsAskedFor)
{
    test::Stride stride = curved;
    stride.frames = 65; // two periods fit, with a blend
    const Clip clip = stridingTube(stride);
    const FramePair free = seamlessLoop(clip, {}, uprightBlend).closure.frames;
    const FrameRange asked{FrameIndex(free.destination), FrameIndex(free.source + 10)};
    const FramePair kept = seamlessLoop(clip, {}, uprightBlend, asked).closure.frames;
    EXPECT_LE(kept.destination, asked.first.value);
    EXPECT_GE(kept.source, asked.last.value);
}

TEST(Loop, NamesTheOriginsOfItsFrames)
{
    const Clip clip = stridingTube(curved);
    BlendMethod plain = uprightBlend;
    plain.blend = {};
    const Loop loop = seamlessLoop(clip, {}, plain);
    const auto [last, first] = loop.closure.frames;
    EXPECT_GT(last, first);
    EXPECT_EQ(loop.cycle.origins.front(), clip.origins[static_cast<std::size_t>(first)]);
    EXPECT_EQ(loop.cycle.frameCount(), last - first + loop.closure.length() - 1);
    for (int t = 1; t + 1 < loop.closure.length(); ++t) {
        const FrameProvenance& origin = loop.cycle.origins[static_cast<std::size_t>(last - first + t)];
        EXPECT_EQ(origin.source, loop.closure.path[static_cast<std::size_t>(t)].source);
        EXPECT_EQ(origin.destination, loop.closure.path[static_cast<std::size_t>(t)].destination);
        EXPECT_DOUBLE_EQ(origin.lambda, t / (loop.closure.length() - 1.0));
    }
}

TEST(Loop, HasNoSeamWhereTheMotionIsNotQuitePeriodic)
{
    test::Stride growing = curved;
    growing.growth = 0.01;
    const Clip clip = stridingTube(growing);
    double captured = 0;
    for (std::int64_t f = 1; f < clip.frameCount(); ++f)
        captured = std::max(captured, largestDistance(clip.frame(f - 1), clip.frame(f)));
    const Clip twice = repeated(seamlessLoop(clip, {}, uprightBlend), 2, UpAxis::Z);
    for (std::int64_t f = 1; f < twice.frameCount(); ++f)
        EXPECT_LT(largestDistance(twice.frame(f - 1), twice.frame(f)), 1.2 * captured) << f;
}

TEST(Loop, CutsNoMoreThanItMay)
{
    const Clip clip = stridingTube(curved);
    const LoopSettings settings{.cutStart = Seconds{0.4}, .cutEnd = Seconds{0.6}};
    const Loop loop = seamlessLoop(clip, settings, uprightBlend);
    EXPECT_LE(loop.closure.frames.destination, 10);
    EXPECT_GE(loop.closure.frames.source, clip.frameCount() - 1 - 15);
}

TEST(Loop, MovesWithItsClip)
{
    const GroundMotion elsewhere{2, Vec2d(-3, 8)};
    const Loop here = seamlessLoop(stridingTube(curved), {}, uprightBlend);
    const Loop there = seamlessLoop(stridingTube(curved, elsewhere), {}, uprightBlend);
    ASSERT_EQ(here.closure.frames, there.closure.frames);
    for (std::int64_t f = 0; f < here.cycle.frameCount(); ++f)
        EXPECT_LT(largestDistance(movedBy(elsewhere, here.cycle.frame(f), UpAxis::Z), there.cycle.frame(f)),
                  1e-4);
    const GroundMotion expected = elsewhere * here.travel * elsewhere.inverse();
    EXPECT_LT((expected.shift - there.travel.shift).norm(), 1e-3);
}

TEST(Loop, InPlaceComesBackToWhereItBegan)
{
    LoopSettings settings;
    settings.inPlace = true;
    const Loop loop = seamlessLoop(stridingTube(curved), settings, uprightBlend);
    EXPECT_EQ(loop.travel, GroundMotion());
    const Ground ground(UpAxis::Z);
    const Clip around = repeated(loop, 2, UpAxis::Z);
    // An even pace is taken out whole: what stays is the sway, of the size of 0.3 m.
    for (std::int64_t f = 0; f < around.frameCount(); ++f) {
        EXPECT_LT((ground.of(centroid(around.frame(f))) - ground.of(centroid(around.frame(0)))).norm(), 0.7);
        EXPECT_LT(largestDistance(around.frame(f), around.frame(f % loop.cycle.frameCount())), 1e-6);
        const auto later = (f + curved.period) % around.frameCount();
        EXPECT_LT(largestDistance(around.frame(f), around.frame(later)), 1e-3) << f;
    }
}

TEST(Loop, SaysWhatItNeeds)
{
    test::Stride brief = curved;
    brief.frames = 17;
    EXPECT_EQ(errorCodeOf([&] { seamlessLoop(stridingTube(brief), {}, uprightBlend); }),
              ErrorCode::LoopTooShort);
    const Clip clip = stridingTube(curved);
    const auto cutting = [&](double seconds) {
        return errorCodeOf(
            [&] { seamlessLoop(clip, {.cutStart = Seconds{seconds}, .cutEnd = {}}, uprightBlend); });
    };
    EXPECT_EQ(cutting(0.1), ErrorCode::LoopCutTooShort);
    EXPECT_EQ(cutting(-1), ErrorCode::BadArgument);
    EXPECT_EQ(cutting(std::numeric_limits<double>::quiet_NaN()), ErrorCode::BadArgument);
    const Loop loop = seamlessLoop(clip, {}, uprightBlend);
    for (const int cycles : {0, -1, 100000})
        EXPECT_EQ(errorCodeOf([&] { repeated(loop, cycles, UpAxis::Z); }), ErrorCode::BadArgument);
}

TEST(Loop, OfTheShortestClipThatCanBeBlended)
{
    test::Stride brief = curved;
    brief.frames = 18;
    const Loop loop = seamlessLoop(stridingTube(brief), {}, uprightBlend);
    EXPECT_GE(loop.cycle.frameCount(), 9);
}

TEST(Loop, LeavesAClipThatGoesRoundAsItIs)
{
    // Two periods, without and with the frame that begins the third one.
    for (const int frames : {40, 41}) {
        test::Stride whole = curved;
        whole.frames = frames;
        const Clip clip = stridingTube(whole);
        const Loop loop = seamlessLoop(clip, {}, uprightBlend);
        EXPECT_EQ(loop.cycle.frameCount(), 40);
        EXPECT_TRUE(loop.closure.path.empty());
        EXPECT_EQ(loop.cycle.origins.front(), clip.origins.front());
        for (std::int64_t f = 0; f < 40; ++f)
            EXPECT_EQ(largestDistance(loop.cycle.frame(f), clip.frame(f)), 0);
        test::Stride longer = curved;
        longer.frames = 80;
        const Clip twice = repeated(loop, 2, UpAxis::Z);
        const Clip expected = stridingTube(longer);
        // Where the third period is not seen to begin, the pace over the seam is the mean of those around it.
        for (std::int64_t f = 40; f < 80; ++f)
            EXPECT_LT(largestDistance(twice.frame(f), expected.frame(f)), frames == 41 ? 1e-4 : 0.03) << f;
    }
}

TEST(Loop, DoesNotTakeAWayBackForARound)
{
    // There and back again: the last pose is the first one, but goes the other way.
    const Clip there = stridingTube({.frames = 21, .period = 80, .pace = {}});
    Clip clip = there;
    for (std::int64_t f = 19; f >= 0; --f) {
        clip.origins.push_back(there.origins[static_cast<std::size_t>(f)]);
        clip.positions.insert(clip.positions.end(), there.frame(f).begin(), there.frame(f).end());
    }
    EXPECT_FALSE(ownPeriod(clip, UpAxis::Z, {}));
    EXPECT_FALSE(seamlessLoop(clip, {}, uprightBlend).closure.path.empty());
}

TEST(Loop, IsNotFrozenByMeanCosts)
{
    if (!test::realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    for (const char* take : {"walk_1", "walk_fast", "run_1"}) {
        const Clip clip = test::clipOf(*test::realTake(take));
        double least = 1;
        for (std::int64_t f = 1; f < clip.frameCount(); ++f)
            least = std::min(least, largestDistance(clip.frame(f - 1), clip.frame(f)));
        for (const TransitionCost cost : {TransitionCost::Sum, TransitionCost::Mean}) {
            BlendMethod method;
            method.transitions.cost = cost;
            const Loop loop = seamlessLoop(clip, {}, method);
            const Clip twice = repeated(loop, 2, UpAxis::Y);
            for (std::int64_t f = 1; f < twice.frameCount(); ++f)
                EXPECT_GT(largestDistance(twice.frame(f - 1), twice.frame(f)), 0.5 * least)
                    << take << " " << f;
        }
    }
}

TEST(Loop, StopsWhenCancelled)
{
    CancelToken token;
    token.cancel();
    EXPECT_EQ(errorCodeOf([&] { seamlessLoop(stridingTube(curved), {}, uprightBlend, {}, Progress(token)); }),
              ErrorCode::Cancelled);
}

TEST(GroundMotion, HasPartsThatAddUp)
{
    for (const double turn : {0.0, 1e-6, 0.7, -3.0}) {
        const GroundMotion whole{turn, Vec2d(2, -1)};
        const GroundMotion third = partOf(whole, 1.0 / 3);
        const GroundMotion sum = third * third * third;
        EXPECT_NEAR(sum.turn, turn, 1e-12);
        EXPECT_LT((sum.shift - whole.shift).norm(), 1e-9);
    }
    // A quarter of a circle of radius 1: half of it ends at 45 degrees.
    const GroundMotion half = partOf({std::numbers::pi / 2, Vec2d(1, 1)}, 0.5);
    EXPECT_LT((half.shift - Vec2d(std::sqrt(0.5), 1 - std::sqrt(0.5))).norm(), 1e-12);
}

} // namespace
} // namespace quadrille
