// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/procrustes.h"
#include "model/synthesis/finishing/loopplayings.h"
#include "tests/model/synthesis/errorcodeof.h"
#include "tests/model/synthesis/stridingtube.h"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::errorCodeOf;
using test::largestDistance;
using test::movedBy;
using test::stridingTube;

const BlendMethod uprightTube{.up = UpAxis::Z, .pose = {}, .transitions = {}};

/// A curved walk of three periods and a half.
Clip walkOf(double swelling = 0, int frames = 70)
{
    Clip clip = stridingTube({.frames = frames, .period = 20, .pace = {0.03, Vec2d(0.04, 0.01)}});
    const Clip narrow = clip;
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const Vec3f centre = centroid(narrow.frame(f)).cast<float>();
        for (Vec3f& p : clip.frame(f)) {
            const auto size = static_cast<float>(1 + swelling);
            p.x() = centre.x() + size * (p.x() - centre.x());
            p.y() = centre.y() + size * (p.y() - centre.y());
        }
    }
    return clip;
}

/// Plays clips that swell more from one to the next.
PlayingClip swellingBy(double swelling, int frames = 70)
{
    return [=](int playing, const Progress&) {
        return std::make_shared<const Clip>(walkOf(swelling * playing, frames));
    };
}

/// The largest change of a vertex's step, with the first frames again behind the last, metres.
double roughness(const Loop& loop)
{
    const Clip twice = repeated(loop, 2, UpAxis::Z);
    double largest = 0;
    for (std::int64_t f = 1; f <= loop.cycle.frameCount(); ++f) {
        for (std::size_t v = 0; v < twice.frame(f).size(); ++v)
            largest = std::max(
                largest, static_cast<double>(
                             (twice.frame(f - 1)[v] - 2 * twice.frame(f)[v] + twice.frame(f + 1)[v]).norm()));
    }
    return largest;
}

TEST(LoopPlayings, OfTheSameClipAreTheLoopRepeated)
{
    const Loop loop = seamlessLoop(walkOf(), {}, uprightTube);
    const auto clip = std::make_shared<const Clip>(walkOf());
    const LoopPlayings playings = playedAs(
        loop, 3, [&](int, const Progress&) { return clip; }, uprightTube);
    const Clip plain = repeated(loop, 3, UpAxis::Z);
    ASSERT_EQ(playings.loop.cycle.frameCount(), plain.frameCount());
    EXPECT_EQ(playings.framesOfEach(), loop.cycle.frameCount());
    for (std::int64_t f = 0; f < plain.frameCount(); ++f) {
        EXPECT_LT(largestDistance(playings.loop.cycle.frame(f), plain.frame(f)), 1e-5) << f;
        EXPECT_EQ(playings.loop.cycle.origins[static_cast<std::size_t>(f)],
                  plain.origins[static_cast<std::size_t>(f)]);
    }
    const GroundMotion travel = repeatedTravel(loop.travel, 3);
    EXPECT_NEAR(playings.loop.travel.turn, travel.turn, 1e-6);
    EXPECT_LT((playings.loop.travel.shift - travel.shift).norm(), 1e-5);
}

TEST(LoopPlayings, ShowTheirClipsWithoutASeam)
{
    const Loop loop = seamlessLoop(walkOf(), {}, uprightTube);
    const LoopPlayings playings = playedAs(loop, 3, swellingBy(0.1), uprightTube);
    const auto [last, first] = loop.closure.frames;
    const std::int64_t each = playings.framesOfEach();
    GroundMotion place;
    for (int k = 0; k < 3; ++k) {
        const Clip own = walkOf(0.1 * k);
        for (NodeIndex f = first; f <= last; ++f)
            EXPECT_LT(largestDistance(playings.loop.cycle.frame(k * each + f - first),
                                      movedBy(place, own.frame(f), UpAxis::Z)),
                      1e-5)
                << k << " " << f;
        place = place * playings.travels[static_cast<std::size_t>(k)];
    }
    // A fifth of 0.2 m over a blend is not seen beside the swaying.
    EXPECT_LT(roughness(playings.loop), 1.2 * 1.2 * roughness(loop));
}

TEST(LoopPlayings, OfAClipThatGoesRoundComeBackToItsEnds)
{
    const Clip walk = walkOf(0, 40);
    const Loop loop = seamlessLoop(walk, {}, uprightTube);
    ASSERT_TRUE(loop.closure.path.empty());
    const LoopPlayings playings = playedAs(loop, 2, swellingBy(0.2, 40), uprightTube, 0.2);
    const std::int64_t each = playings.framesOfEach();
    ASSERT_EQ(each, 40);
    // The first as it is; of the second the middle, and its ends on the way there.
    const Clip second = walkOf(0.2, 40);
    for (std::int64_t f = 0; f < each; ++f) {
        EXPECT_LT(largestDistance(playings.loop.cycle.frame(f), walk.frame(f)), 1e-6) << f;
        const double apart = largestDistance(playings.loop.cycle.frame(each + f),
                                             movedBy(loop.travel, second.frame(f), UpAxis::Z));
        if (f >= 5 && f < each - 5)
            EXPECT_LT(apart, 1e-5) << f;
        else
            EXPECT_GT(apart, 1e-4) << f;
    }
    EXPECT_LT(roughness(playings.loop), 1.5 * roughness(loop));
}

TEST(LoopPlayings, StayInPlaceHoweverFarTheyTurn)
{
    // Some 100 degrees each.
    const Loop loop = seamlessLoop(walkOf(), {}, uprightTube);
    const LoopPlayings still = inPlace(playedAs(loop, 5, swellingBy(0.05), uprightTube), UpAxis::Z);
    ASSERT_GT(5 * std::abs(loop.travel.turn), std::numbers::pi);
    EXPECT_EQ(still.loop.travel, GroundMotion());
    const Loop usual = inPlace(loop, UpAxis::Z);
    for (std::int64_t f = 0; f < still.loop.cycle.frameCount(); ++f) {
        const auto own = usual.cycle.frame(f % usual.cycle.frameCount());
        EXPECT_LT((centroid(still.loop.cycle.frame(f)) - centroid(own)).norm(), 0.05) << f;
    }
}

TEST(LoopPlayings, AreNotPlayedTooOften)
{
    const Loop loop = seamlessLoop(walkOf(), {}, uprightTube);
    EXPECT_EQ(errorCodeOf([&] { playedAs(loop, 0, swellingBy(0), uprightTube); }), ErrorCode::BadArgument);
    EXPECT_EQ(errorCodeOf([&] { playedAs(loop, 10'001, swellingBy(0), uprightTube); }),
              ErrorCode::BadArgument);
}

} // namespace
} // namespace quadrille
