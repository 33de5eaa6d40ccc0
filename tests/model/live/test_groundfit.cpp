// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/random.h"
#include "model/live/groundfit.h"

#include <gtest/gtest.h>
#include <vector>

namespace quadrille {
namespace {

std::vector<Vec3f> movedOver(const std::vector<Vec3f>& pose, const GroundMotion& motion, const Ground& ground)
{
    std::vector<Vec3f> moved;
    for (const Vec3f& point : pose)
        moved.push_back(motion(point.cast<double>(), ground).cast<float>());
    return moved;
}

std::vector<Vec3f> standingPose(UpAxis up)
{
    Random random(3);
    std::vector<Vec3f> pose;
    for (int v = 0; v < 60; ++v) {
        Vec3d point(random.between(-0.4, 0.4), random.between(-0.4, 0.4), random.between(-0.4, 0.4));
        point[static_cast<int>(up)] = v < 12 ? random.between(0, 0.02) : random.between(0.3, 1.8);
        pose.push_back(point.cast<float>());
    }
    return pose;
}

} // namespace

TEST(GroundFit, FindsARigidMotionOverTheGround)
{
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        const Ground ground(up);
        const std::vector<Vec3f> pose = standingPose(up);
        const GroundMotion motion{2.5, Vec2d(3, -1)};
        const GroundMotion found = fitOverGround(pose, movedOver(pose, motion, ground), ground);
        EXPECT_NEAR(wrappedAngle(found.turn - motion.turn), 0, 1e-5);
        EXPECT_LT((found.shift - motion.shift).norm(), 1e-5);
    }
}

TEST(GroundFit, KeepsFeetWhereTheyStandWhateverTheBodyDoes)
{
    const Ground ground(UpAxis::Y);
    const std::vector<Vec3f> pose = standingPose(UpAxis::Y);
    std::vector<Vec3f> onto = pose;
    for (std::size_t v = 12; v < onto.size(); ++v)
        onto[v] += Vec3f(0.3F, 0, -0.2F); // all but the feet lean over; the trunk turns by chance
    const GroundMotion found = fitOverGround(pose, onto, ground);
    for (std::size_t v = 0; v < 12; ++v)
        EXPECT_LT((found(pose[v].cast<double>(), ground) - onto[v].cast<double>()).norm(), 0.05) << v;
}

TEST(GroundFit, TakesAllVerticesWhereNoneStandsInBothPoses)
{
    const Ground ground(UpAxis::Y);
    const std::vector<Vec3f> pose = standingPose(UpAxis::Y);
    std::vector<Vec3f> onto = movedOver(pose, {0.4, Vec2d(1, 2)}, ground);
    for (Vec3f& point : onto)
        point.y() += 0.5F; // in the air
    const GroundMotion found = fitOverGround(pose, onto, ground);
    EXPECT_NEAR(found.turn, 0.4, 1e-5);
    EXPECT_LT((found.shift - Vec2d(1, 2)).norm(), 1e-5);
}

} // namespace quadrille
