// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"
#include "model/synthesis/clips/frameprovenance.h"
#include "model/synthesis/finishing/monotonecurve.h"
#include "model/synthesis/finishing/retime.h"
#include "model/transition/poseinterpolation.h"
#include "tests/model/synthesis/errorcodeof.h"
#include "tests/model/synthesis/stridingtube.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::errorCodeOf;
using test::largestDistance;
using test::movedBy;
using test::stridingTube;

const test::Stride stride{.frames = 21, .period = 20, .pace = {0.02, Vec2d(0.05, 0)}};

RetimeSettings by(double factor, bool keepsRootSpeed = false)
{
    return {.time = RetimeFactor{factor}, .keepsRootSpeed = keepsRootSpeed};
}

Vec2d placeOf(const Clip& clip, std::int64_t frame)
{
    return Ground(UpAxis::Z).of(centroid(clip.frame(frame)));
}

TEST(MonotoneCurve, PassesItsPointsWithoutOvershoot)
{
    const std::vector<Vec2d> points{{0, 0}, {1, 0}, {2, 5}, {3, 5.1}, {7, 20}};
    const MonotoneCurve curve(points);
    for (const Vec2d& p : points)
        EXPECT_DOUBLE_EQ(curve(p.x()), p.y());
    double before = 0;
    for (double x = -1; x < 8; x += 0.01) {
        EXPECT_GE(curve(x), before - 1e-12);
        before = curve(x);
    }
    EXPECT_DOUBLE_EQ(before, 20);
    EXPECT_DOUBLE_EQ(curve(0.5), 0); // level between equal values
}

TEST(MonotoneCurve, HasTheSlopesOfFritschAndButland)
{
    // Secants 1 and 4 over widths 1 and 2: weights 5 and 4, slope 9 / (5/1 + 4/4) = 1.5 at the middle; at the
    // first point ((2·1 + 2)·1 − 1·4) / 3 = 0, at the last one ((2·2 + 1)·4 − 2·1) / 3 = 6.
    const MonotoneCurve curve({{0, 0}, {1, 1}, {3, 9}});
    const double h = 1e-6;
    EXPECT_NEAR((curve(1 + h) - curve(1 - h)) / (2 * h), 1.5, 1e-5);
    EXPECT_NEAR((curve(h) - curve(0)) / h, 0, 1e-5);
    EXPECT_NEAR((curve(3) - curve(3 - h)) / h, 6, 1e-5);
}

TEST(MonotoneCurve, ThroughTwoPointsIsStraight)
{
    const MonotoneCurve curve({{1, 2}, {3, 8}});
    EXPECT_DOUBLE_EQ(curve(1.5), 3.5);
}

TEST(Retime, ByOneChangesNothing)
{
    const Clip clip = stridingTube(stride);
    for (const bool keeps : {false, true}) {
        const Clip same = retimed(clip, by(1, keeps), UpAxis::Z);
        EXPECT_EQ(same.positions, clip.positions);
        EXPECT_EQ(same.origins, clip.origins);
    }
    const Clip same = retimed(clip, {.time = Seconds{20 / 25.0}}, UpAxis::Z);
    EXPECT_EQ(same.positions, clip.positions);
}

TEST(Retime, ByTwoShowsEachFrameAndOneBetween)
{
    const Clip clip = stridingTube(stride);
    const Clip slow = retimed(clip, by(2), UpAxis::Z);
    ASSERT_EQ(slow.frameCount(), 41);
    for (std::int64_t f = 0; f < 21; ++f)
        EXPECT_EQ(largestDistance(slow.frame(2 * f), clip.frame(f)), 0) << f;
    for (std::int64_t f = 0; f < 20; ++f) {
        const auto expected = interpolatePoses(clip.topology, clip.frame(f), clip.frame(f + 1), 0.5,
                                               InterpolationMethod::Poisson);
        EXPECT_LT(largestDistance(slow.frame(2 * f + 1), expected), 1e-6);
        EXPECT_EQ(slow.origins[static_cast<std::size_t>(2 * f + 1)],
                  (FrameProvenance{static_cast<NodeIndex>(f), static_cast<NodeIndex>(f + 1), 0.5, false}));
    }
}

TEST(Retime, ByAHalfShowsEverySecondFrame)
{
    const Clip clip = stridingTube(stride);
    const Clip fast = retimed(clip, by(0.5), UpAxis::Z);
    ASSERT_EQ(fast.frameCount(), 11);
    for (std::int64_t f = 0; f < 11; ++f)
        EXPECT_EQ(largestDistance(fast.frame(f), clip.frame(2 * f)), 0);
}

TEST(Retime, KeepsTheSpeedOfTheRoot)
{
    const Clip clip = stridingTube({.frames = 21, .period = 20, .pace = {0, Vec2d(0.05, 0)}});
    const Clip slow = retimed(clip, by(2), UpAxis::Z);
    const Clip kept = retimed(clip, by(2, true), UpAxis::Z);
    const Vec2d travel = placeOf(clip, 20) - placeOf(clip, 0);
    EXPECT_LT((placeOf(slow, 40) - placeOf(slow, 0) - travel).norm(), 1e-5);
    EXPECT_LT((placeOf(kept, 40) - placeOf(kept, 0) - 2 * travel).norm(), 1e-5);
    for (std::int64_t f = 0; f < 40; ++f) {
        const Vec2d original = placeOf(clip, f / 2 + 1) - placeOf(clip, f / 2);
        EXPECT_LT((placeOf(kept, f + 1) - placeOf(kept, f) - original).norm(), 1e-5) << f;
    }
}

TEST(Retime, GoesOnWhereTimeStandsStillIfItKeepsTheSpeed)
{
    const Clip clip = stridingTube({.frames = 21, .period = 20, .pace = {0, Vec2d(0.05, 0)}});
    RetimeSettings settings{.time = RetimeSettings::Curve{{{0}, {0}}, {{0.4}, {0.4}}, {{0.8}, {0.4}}}};
    const Clip held = retimed(clip, settings, UpAxis::Z);
    ASSERT_EQ(held.frameCount(), 21);
    for (std::int64_t f = 11; f < 21; ++f)
        EXPECT_EQ(largestDistance(held.frame(f), clip.frame(10)), 0);
    settings.keepsRootSpeed = true;
    const Clip gliding = retimed(clip, settings, UpAxis::Z);
    const Vec2d pace = placeOf(clip, 11) - placeOf(clip, 10);
    EXPECT_LT((placeOf(gliding, 20) - placeOf(gliding, 10) - 10 * pace).norm(), 1e-5);
}

TEST(Retime, FollowsACurve)
{
    const Clip clip = stridingTube(stride);
    const RetimeSettings settings{.time =
                                      RetimeSettings::Curve{{{0}, {0.2}}, {{0.4}, {0.3}}, {{1.2}, {0.8}}}};
    const std::vector<double> moments = retimedMoments(settings, 20, 25);
    ASSERT_EQ(moments.size(), 31U);
    EXPECT_DOUBLE_EQ(moments[0], 5);
    EXPECT_DOUBLE_EQ(moments[10], 7.5);
    EXPECT_DOUBLE_EQ(moments[30], 20);
    EXPECT_TRUE(std::ranges::is_sorted(moments));
    const Clip result = retimed(clip, settings, UpAxis::Z);
    EXPECT_EQ(largestDistance(result.frame(0), clip.frame(5)), 0);
    EXPECT_EQ(largestDistance(result.frame(30), clip.frame(20)), 0);
}

TEST(Retime, MovesWithItsClip)
{
    const GroundMotion elsewhere{-2.5, Vec2d(4, 1)};
    for (const bool keeps : {false, true}) {
        const Clip here = retimed(stridingTube(stride), by(1.7, keeps), UpAxis::Z);
        const Clip there = retimed(stridingTube(stride, elsewhere), by(1.7, keeps), UpAxis::Z);
        for (std::int64_t f = 0; f < here.frameCount(); ++f)
            EXPECT_LT(largestDistance(movedBy(elsewhere, here.frame(f), UpAxis::Z), there.frame(f)), 1e-4);
    }
}

TEST(Retime, OfALoopClosesAsBefore)
{
    Loop loop{.cycle = stridingTube({.frames = 20, .period = 20, .pace = stride.pace}),
              .travel = {},
              .closure = {}};
    for (int f = 0; f < 20; ++f)
        loop.travel = loop.travel * stride.pace;
    for (const bool keeps : {false, true}) {
        const Loop slow = retimed(loop, by(1.5, keeps), UpAxis::Z);
        EXPECT_EQ(slow.cycle.frameCount(), 30);
        const Clip twice = repeated(slow, 2, UpAxis::Z);
        double largest = 0;
        for (std::int64_t f = 1; f < 30; ++f)
            largest = std::max(largest, largestDistance(twice.frame(f - 1), twice.frame(f)));
        EXPECT_LT(largestDistance(twice.frame(29), twice.frame(30)), 1.01 * largest);
        EXPECT_NEAR(slow.travel.turn, loop.travel.turn, 1e-12);
    }
    // Straight on, three halves of the time at the same speed lead three halves as far.
    Loop straight{.cycle = stridingTube({.frames = 20, .period = 20, .pace = {0, Vec2d(0.05, 0)}}),
                  .travel = {0, Vec2d(1, 0)},
                  .closure = {}};
    EXPECT_LT((retimed(straight, by(1.5, true), UpAxis::Z).travel.shift - Vec2d(1.5, 0)).norm(), 1e-5);
    EXPECT_LT((retimed(straight, by(1.5), UpAxis::Z).travel.shift - Vec2d(1, 0)).norm(), 1e-12);
}

TEST(Retime, RefusesTimesThatCannotBe)
{
    const Clip clip = stridingTube(stride);
    const auto code = [&](const RetimeSettings& settings) {
        return errorCodeOf([&] { retimed(clip, settings, UpAxis::Z); });
    };
    using Curve = RetimeSettings::Curve;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, nan, 1e9, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(code(by(bad)), ErrorCode::BadArgument) << bad;
        EXPECT_EQ(code({.time = Seconds{bad}}), ErrorCode::BadArgument) << bad;
    }
    EXPECT_EQ(code({.time = Curve{}}), ErrorCode::BadArgument);
    EXPECT_EQ(code({.time = Curve{{{0}, {0}}}}), ErrorCode::BadArgument);
    EXPECT_EQ(code({.time = Curve{{{0}, {0}}, {{1}, {2}}}}), ErrorCode::BadArgument);
    EXPECT_EQ(code({.time = Curve{{{0}, {-1}}, {{1}, {0.5}}}}), ErrorCode::BadArgument);
    EXPECT_EQ(code({.time = Curve{{{0}, {nan}}, {{1}, {0.5}}}}), ErrorCode::BadArgument);
    EXPECT_EQ(code({.time = Curve{{{0}, {0.5}}, {{1}, {0.2}}}}), ErrorCode::TimeCurveNotMonotone);
    EXPECT_EQ(code({.time = Curve{{{1}, {0.2}}, {{1}, {0.5}}}}), ErrorCode::TimeCurveNotMonotone);
    Loop loop{.cycle = clip, .travel = {}, .closure = {}};
    const RetimeSettings half{.time = Curve{{{0}, {0}}, {{1}, {0.4}}}};
    EXPECT_EQ(errorCodeOf([&] { retimed(loop, half, UpAxis::Z); }), ErrorCode::BadArgument);
}

TEST(Retime, OfOneFrame)
{
    const Clip clip = stridingTube({.frames = 1, .period = 20, .pace = {}});
    for (const bool keeps : {false, true}) {
        EXPECT_EQ(retimed(clip, by(3, keeps), UpAxis::Z).frameCount(), 1);
        const Clip still = retimed(clip, {.time = Seconds{0.4}, .keepsRootSpeed = keeps}, UpAxis::Z);
        ASSERT_EQ(still.frameCount(), 11);
        EXPECT_EQ(largestDistance(still.frame(10), clip.frame(0)), 0);
    }
}

TEST(Retime, StopsWhenCancelled)
{
    CancelToken token;
    token.cancel();
    EXPECT_EQ(errorCodeOf([&] {
                  retimed(stridingTube(stride), by(2), UpAxis::Z, InterpolationMethod::Poisson,
                          Progress(token));
              }),
              ErrorCode::Cancelled);
}

TEST(FrameOrigins, NameWhatLiesBetween)
{
    const FrameProvenance captured{3, 3, 0, false};
    const FrameProvenance other{7, 7, 0, false};
    const FrameProvenance blend{3, 7, 0.4, false};
    EXPECT_EQ(originBetween(captured, other, 0.25), (FrameProvenance{3, 7, 0.25, false}));
    EXPECT_EQ(originBetween(captured, captured, 0.25), captured);
    EXPECT_EQ(originBetween(captured, other, 1), other);
    EXPECT_EQ(originBetween(captured, blend, 0.5), (FrameProvenance{3, 7, 0.2, false}));
    EXPECT_EQ(originBetween(blend, other, 0.5), (FrameProvenance{3, 7, 0.7, false}));
    EXPECT_EQ(originBetween(blend, {3, 7, 0.8, false}, 0.25), (FrameProvenance{3, 7, 0.5, false}));
    EXPECT_EQ(originBetween(blend, {4, 8, 0.6, false}, 0.25), blend);
    EXPECT_EQ(originBetween(blend, {4, 8, 0.6, false}, 0.5), (FrameProvenance{4, 8, 0.6, false}));
    EXPECT_EQ(originBetween(captured, {7, 7, 0, true}, 0.75), (FrameProvenance{7, 7, 0, true}));
}

} // namespace
} // namespace quadrille
