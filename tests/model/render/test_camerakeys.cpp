// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/camerakeys.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

std::vector<CameraKey> threeKeys()
{
    return {{.time = 1, .target = {0, 1, 0}, .distance = 4, .azimuth = 170, .elevation = 10},
            {.time = 2, .target = {1, 1, 0}, .distance = 8, .azimuth = -170, .elevation = 10},
            {.time = 4,
             .target = {1, 1, 2},
             .distance = 8,
             .azimuth = -170,
             .elevation = -20,
             .fieldOfView = 50}};
}

} // namespace

TEST(CameraKeys, AreMetAtTheirTimesAndHeldBeforeAndAfter)
{
    const auto keys = threeKeys();
    for (const CameraKey& key : keys) {
        const CameraKey at = cameraAt(keys, key.time);
        EXPECT_LT((at.target - key.target).norm(), 1e-12);
        EXPECT_NEAR(at.distance, key.distance, 1e-12);
        EXPECT_NEAR(at.azimuth, key.azimuth, 1e-12);
        EXPECT_NEAR(at.elevation, key.elevation, 1e-12);
        EXPECT_NEAR(at.fieldOfView, key.fieldOfView, 1e-12);
    }
    CameraKey first = keys.front();
    first.time = -3;
    EXPECT_EQ(cameraAt(keys, -3), first);
    CameraKey last = keys.back();
    last.time = 9;
    EXPECT_EQ(cameraAt(keys, 9), last);
}

TEST(CameraKeys, TurnTheShorterWayAndStandStillBetweenEqualOnes)
{
    const auto keys = threeKeys();
    for (double t = 1; t <= 2; t += 0.05)
        EXPECT_GE(std::abs(cameraAt(keys, t).azimuth), 170 - 1e-9) << t;
    EXPECT_NEAR(std::abs(cameraAt(keys, 1.5).azimuth), 180, 1);
    for (double t = 2; t <= 4; t += 0.05) {
        EXPECT_NEAR(cameraAt(keys, t).distance, 8, 1e-9) << t;
        EXPECT_NEAR(cameraAt(keys, t).azimuth, -170, 1e-9) << t;
        EXPECT_NEAR(cameraAt(keys, t).target.x(), 1, 1e-12) << t;
    }
}

TEST(CameraKeys, NeverGoBeyondThem)
{
    std::vector<CameraKey> keys;
    const double heights[] = {0, 10, 11, 11, 80, -5};
    for (std::size_t i = 0; i < 6; ++i)
        keys.push_back({.time = static_cast<double>(i * i) / 4, .elevation = heights[i]});
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const auto [low, high] = std::minmax(heights[i], heights[i + 1]);
        for (double s = 0; s <= 1; s += 1 / 64.0) {
            const double value = cameraAt(keys, std::lerp(keys[i].time, keys[i + 1].time, s)).elevation;
            EXPECT_GE(value, low - 1e-9);
            EXPECT_LE(value, high + 1e-9);
        }
    }
}

TEST(CameraKeys, MoveSmoothly)
{
    // The largest change of speed between steps falls with the step: the speed has no jumps.
    const auto keys = threeKeys();
    const auto worst = [&](double step) {
        double largest = 0;
        for (double t = 0; t < 5; t += step) {
            const Vec3d before = toCamera(cameraAt(keys, t), UpAxis::Y).eye;
            const Vec3d here = toCamera(cameraAt(keys, t + step), UpAxis::Y).eye;
            const Vec3d after = toCamera(cameraAt(keys, t + 2 * step), UpAxis::Y).eye;
            largest = std::max(largest, (after - 2 * here + before).norm() / step);
        }
        return largest;
    };
    EXPECT_LT(worst(0.001), 0.15 * worst(0.01));
}

TEST(CameraKeys, LookFromTheSideThatTheySay)
{
    const CameraKey front{.target = {0, 1, 0}, .distance = 2};
    EXPECT_LT((toCamera(front, UpAxis::Y).eye - Vec3d(0, 1, 2)).norm(), 1e-12);
    CameraKey side = front;
    side.azimuth = 90;
    EXPECT_LT((toCamera(side, UpAxis::Y).eye - Vec3d(2, 1, 0)).norm(), 1e-12);
    CameraKey above = front;
    above.elevation = 90;
    EXPECT_LT((toCamera(above, UpAxis::Y).eye - Vec3d(0, 3, 0)).norm(), 1e-12);
    EXPECT_LT((toCamera(above, UpAxis::Y).up - Vec3d(0, 0, -1)).norm(), 1e-12);
}

TEST(CameraKeys, ComeBackFromTheCameraThatTheyMake)
{
    const CameraKey key{.time = 2, .target = {1, 2, 3}, .distance = 4, .azimuth = -130, .elevation = 35};
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        const CameraKey back = toCameraKey(toCamera(key, up), up, 2);
        EXPECT_LT((back.target - key.target).norm(), 1e-12);
        EXPECT_NEAR(back.distance, 4, 1e-9);
        EXPECT_NEAR(back.azimuth, -130, 1e-9);
        EXPECT_NEAR(back.elevation, 35, 1e-9);
        EXPECT_EQ(back.time, 2);
    }
}

TEST(CameraKeys, ShowTheSameInOtherCoordinates)
{
    const CameraKey key{.target = {1, 2, 3}, .distance = 4, .azimuth = 25, .elevation = 35};
    const CoordinateSystem systems[] = {{UpAxis::Y, 1}, {UpAxis::Z, 0.01}, {UpAxis::X, 2}};
    for (const CoordinateSystem& from : systems) {
        for (const CoordinateSystem& to : systems) {
            const Vec3d moved = conversionMatrix(from, to).cast<double>() * toCamera(key, from.up).eye;
            EXPECT_LT((toCamera(converted(key, from, to), to.up).eye - moved).norm(), 1e-4 * moved.norm());
        }
    }
}
