// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/playback.h"
#include "model/variation/resampling.h"
#include "tests/model/codeof.h"
#include "tests/model/variation/swayingtakes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace quadrille {
namespace {

using test::strideAt;

std::vector<RigidMotion> stride(int frames)
{
    std::vector<RigidMotion> placements;
    for (int f = 0; f < frames; ++f)
        placements.push_back(strideAt(f));
    return placements;
}

TEST(PathOnGround, OfATakesOwnDisplacementsIsItsPath)
{
    const std::vector<RigidMotion> placements = stride(50);
    for (const double halfLife : {0.0, 0.25, 100.0}) {
        const auto path = pathOnGround(displacementsOf(placements), placements, {.driftHalfLife = halfLife});
        for (std::size_t f = 0; f < path.size(); ++f) {
            EXPECT_LT((path[f].translation - placements[f].translation).norm(), 1e-9);
            EXPECT_LT(path[f].rotation.angularDistance(placements[f].rotation), 1e-7);
        }
    }
}

TEST(PathOnGround, ForgetsDriftOfHeightAndTiltButNotOfTheWay)
{
    const std::vector<RigidMotion> placements = stride(200);
    std::vector<Displacement> displacements = displacementsOf(placements);
    for (Displacement& d : displacements) {
        d[0] += 0.004;
        d[1] += 0.002; // 40 cm over the take
        d[3] += 0.002; // 23 degrees
    }
    const auto free = integrated(displacements, placements.front());
    const auto path = pathOnGround(displacements, placements, {.fps = 25, .driftHalfLife = 0.25});
    double greatestHeight = 0;
    double greatestTilt = 0;
    for (std::size_t f = 0; f < path.size(); ++f) {
        greatestHeight =
            std::max(greatestHeight, std::abs(path[f].translation.y() - placements[f].translation.y()));
        const Vec3d up = upSeenFrom(path[f], Vec3d::UnitY());
        greatestTilt = std::max(greatestTilt, (up - upSeenFrom(placements[f], Vec3d::UnitY())).norm());
    }
    // Drift that is halved every 6.25 frames comes to 8.5 frames' worth of it; leaning leads upwards, too.
    EXPECT_LT(greatestHeight, 0.08);
    EXPECT_LT(greatestTilt, 0.03);
    EXPECT_GT(std::abs(free.back().translation.y() - placements.back().translation.y()), 0.3);
    EXPECT_GT((free.back().translation - placements.back().translation).norm(), 0.3);
    EXPECT_GT((path.back().translation - placements.back().translation).norm(), 0.3);
}

TEST(PathOnGround, TurnsWithItsGuide)
{
    const std::vector<RigidMotion> placements = stride(30);
    std::vector<Displacement> displacements = displacementsOf(placements);
    for (Displacement& d : displacements)
        d[4] += 0.01;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.3, Vec3d::UnitY()));
    std::vector<RigidMotion> turned;
    for (const RigidMotion& p : placements)
        turned.push_back({turn * p.rotation, turn * p.translation + Vec3d(3, 0, -1)});
    const auto a = pathOnGround(displacements, placements);
    const auto b = pathOnGround(displacements, turned);
    for (std::size_t f = 0; f < a.size(); ++f)
        EXPECT_LT((turn * a[f].translation + Vec3d(3, 0, -1) - b[f].translation).norm(), 1e-9);
}

TEST(Played, PutsReferenceFramesInTheTimingOfATake)
{
    const TakeWarp warp{
        .frames = {FrameIndex(5), FrameIndex(9)}, .positions = {5, 7, 9}, .playback = {0, 0.5, 1, 1.5, 2}};
    const std::vector<Vec3f> poses = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Eigen::Quaterniond half(Eigen::AngleAxisd(1, Vec3d::UnitY()));
    const std::vector<RigidMotion> placements = {{half, {0, 0, 0}}, {half, {0, 1, 0}}, {half, {0, 3, 0}}};
    const std::vector<Vec3f> frames = played(poses, placements, warp);
    ASSERT_EQ(frames.size(), 5U);
    // Between 0, 1 and 3 by Catmull–Rom, with −1 before and 5 after them.
    const std::vector<double> heights{0, 0.4375, 1, 1.9375, 3};
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec3d expected = half * Vec3d(0.5 * static_cast<double>(k), 0, 0) + Vec3d(0, heights[k], 0);
        EXPECT_LT((frames[k].cast<double>() - expected).norm(), 1e-6);
    }
}

// On a parabola at another speed, as of a jump, no frame is on a chord.
TEST(Played, KeepsToTheWayOfFlight)
{
    TakeWarp warp{.frames = FrameRange::all(11), .positions = {}, .playback = {}};
    std::vector<Vec3f> poses;
    std::vector<RigidMotion> placements;
    const auto heightAt = [](double t) { return 3 * t - 0.3 * t * t; };
    for (int r = 0; r < 8; ++r) {
        warp.positions.push_back(10.0 / 7 * r);
        poses.emplace_back(0, 0.1 * r * r, 0);
        placements.push_back({Eigen::Quaterniond::Identity(), {0, heightAt(r), 0}});
    }
    warp.playback = inverseWarp(warp.positions, 0, 11);
    const std::vector<Vec3f> frames = played(poses, placements, warp);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const double r = 0.7 * static_cast<double>(k);
        if (r >= 1 && r <= 6) { // where there are frames on both sides
            EXPECT_NEAR(frames[k].y(), heightAt(r) + 0.1 * r * r, 1e-5) << k;
        }
    }
}

TEST(FramesAround, AreTheFramesThemselvesWhereTheyLie)
{
    for (const double frame : {0.0, 1.0, 4.0, -2.0, 9.0}) {
        const FramesAround at = framesAround(frame, 5);
        double own = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (static_cast<double>(at.frames[i]) == std::clamp(frame, 0.0, 4.0))
                own += at.weights[i];
            else
                EXPECT_EQ(at.weights[i], 0) << frame;
        }
        EXPECT_EQ(own, 1) << frame;
    }
    const FramesAround only = framesAround(0, 1);
    EXPECT_EQ(only.weights[0] + only.weights[1] + only.weights[2] + only.weights[3], 1);
}

TEST(Played, CanBeCancelled)
{
    CancelToken token;
    token.cancel();
    const TakeWarp warp{.frames = FrameRange::all(2), .positions = {0, 1}, .playback = {0, 1}};
    const std::vector<Vec3f> poses(2, Vec3f::Zero());
    const std::vector<RigidMotion> placements(2);
    EXPECT_EQ(test::codeOf([&] { played(poses, placements, warp, Progress(token)); }), ErrorCode::Cancelled);
}

TEST(VariationOrigins, NameTheCapturedFramesOfTheSamePhase)
{
    const TakeWarp a{.frames = {FrameIndex(2), FrameIndex(4)}, .positions = {2, 3, 4}, .playback = {0, 1, 2}};
    const TakeWarp b{
        .frames = FrameRange::all(5), .positions = {0, 1, 4}, .playback = {0, 1, 4. / 3, 5. / 3, 2}};
    const std::vector<FrameProvenance> own = variationOrigins(a, 100);
    EXPECT_EQ(own, (std::vector<FrameProvenance>{
                       {102, 102, 0, false}, {103, 103, 0, false}, {104, 104, 0, false}}));
    EXPECT_EQ(variationOrigins(std::array{OriginTake{{&a, 1}, 100}}), own);
    const std::vector<FrameProvenance> half =
        variationOrigins(std::array{OriginTake{{&a, 0.5}, 100}, OriginTake{{&b, 0.5}, 200}});
    ASSERT_EQ(half.size(), 4U);
    EXPECT_EQ(half.front(), (FrameProvenance{102, 200, 0.5, false}));
    EXPECT_EQ(half[1], (FrameProvenance{103, 201, 0.5, false}));
    EXPECT_EQ(half.back(), (FrameProvenance{104, 204, 0.5, false}));
}

TEST(VariationOrigins, NameTheTwoTakesWithTheLargestShares)
{
    const TakeWarp a{.frames = FrameRange::all(3), .positions = {0, 1, 2}, .playback = {0, 1, 2}};
    const std::vector<FrameProvenance> origins =
        variationOrigins(std::array{OriginTake{{&a, 0.1}, 100}, OriginTake{{&a, 0.3}, 200},
                                    OriginTake{{&a, 0.1}, 300}, OriginTake{{&a, 0.5}, 400}});
    ASSERT_EQ(origins.size(), 3U);
    EXPECT_EQ(origins[1].source, 201);
    EXPECT_EQ(origins[1].destination, 401);
    EXPECT_NEAR(origins[1].lambda, 0.625, 1e-12);
}

} // namespace
} // namespace quadrille
