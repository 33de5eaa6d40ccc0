// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/placement.h"

#include <gtest/gtest.h>

using namespace quadrille;

namespace {

/// A body of two vertices, a sole and a head a metre above, whose sole goes back by `step` a frame while its
/// middle stays where it is.
std::vector<Vec3f> walking(int frames, float step, float lift = 0)
{
    std::vector<Vec3f> positions;
    for (int f = 0; f < frames; ++f) {
        positions.emplace_back(-step * static_cast<float>(f), -0.5F - lift, 0.0F);
        positions.emplace_back(0.0F, 0.5F, 0.0F);
    }
    return positions;
}

TemplateCourse straightAhead(int frames, double step)
{
    TemplateCourse course;
    for (int f = 0; f < frames; ++f) {
        course.middles.emplace_back(3 + step * f, 1, 5);
        course.lowest.push_back(0.02);
        course.stands.push_back(1);
    }
    course.ground = groundOf(course);
    return course;
}

} // namespace

TEST(Placement, StepsTellTheScale)
{
    std::vector<Vec3f> positions = walking(30, 0.055F);
    EXPECT_NEAR(scaleOfSteps(straightAhead(30, 0.05), {positions, 2}, UpAxis::Y, 1), 1.1, 1e-5);
}

/// The template's feet go a fifth of its way while they stand: so may the target's.
TEST(Placement, FeetMaySlideAsThoseOfTheTemplate)
{
    TemplateCourse course = straightAhead(30, 0.05);
    course.slides.assign(30, Vec3d(0.01, 0, 0));
    std::vector<Vec3f> positions = walking(30, 0.044F); // 0.011 a frame less than its own way
    EXPECT_NEAR(scaleOfSteps(course, {positions, 2}, UpAxis::Y, 1), 1.1, 1e-5);
}

TEST(Placement, ScaleStaysNearThatOfHeights)
{
    std::vector<Vec3f> positions = walking(30, 0.2F);
    EXPECT_DOUBLE_EQ(scaleOfSteps(straightAhead(30, 0.05), {positions, 2}, UpAxis::Y, 1.2), 1.5);
}

TEST(Placement, WhoHardlyMovesHasTheScaleOfHeights)
{
    std::vector<Vec3f> positions = walking(10, 0.055F);
    EXPECT_DOUBLE_EQ(scaleOfSteps(straightAhead(10, 0.05), {positions, 2}, UpAxis::Y, 0.9), 0.9);
    positions = walking(30, 0.055F);
    TemplateCourse flying = straightAhead(30, 0.05);
    flying.stands.assign(30, 0);
    EXPECT_DOUBLE_EQ(scaleOfSteps(flying, {positions, 2}, UpAxis::Y, 0.9), 0.9);
}

TEST(Placement, FollowsTheScaledWayOnTheGround)
{
    std::vector<Vec3f> positions = walking(30, 0.055F);
    const PosedTarget target{positions, 2};
    placeOnGround(straightAhead(30, 0.05), 1.1, UpAxis::Y, target);
    for (std::size_t f = 0; f < target.count(); ++f) {
        EXPECT_NEAR(target.at(f)[1].x(), 3 + 0.055 * static_cast<double>(f), 1e-5);
        EXPECT_NEAR(target.at(f)[1].z(), 5, 1e-5);
        EXPECT_NEAR(target.at(f)[0].y(), 0.02, 1e-5);
        EXPECT_NEAR(target.at(f)[0].x(), 3, 1e-5);
    }
}

TEST(Placement, LeapsAreScaledAboveTheGround)
{
    TemplateCourse course = straightAhead(60, 0.05);
    for (std::size_t f = 20; f < 40; ++f) {
        course.lowest[f] += 0.4;
        course.middles[f].y() += 0.4;
        course.stands[f] = 0;
    }
    std::vector<Vec3f> positions = walking(60, 0.055F);
    const PosedTarget target{positions, 2};
    placeOnGround(course, 1.1, UpAxis::Y, target);
    EXPECT_NEAR(target.at(10)[0].y(), 0.02, 1e-5);
    EXPECT_NEAR(target.at(30)[0].y(), 0.02 + 1.1 * 0.4, 1e-5);
}

TEST(Placement, WorksForEveryUpAxis)
{
    for (const UpAxis up : {UpAxis::X, UpAxis::Z}) {
        // Axes exchanged in turn: y becomes the axis that points up.
        const auto turned = [&](const auto& p) {
            auto result = p;
            for (Eigen::Index i = 0; i < 3; ++i)
                result[(i + static_cast<Eigen::Index>(up) + 2) % 3] = p[i];
            return result;
        };
        std::vector<Vec3f> positions = walking(30, 0.055F);
        for (Vec3f& p : positions)
            p = turned(p);
        TemplateCourse course = straightAhead(30, 0.05);
        for (Vec3d& p : course.middles)
            p = turned(p);
        const PosedTarget target{positions, 2};
        EXPECT_NEAR(scaleOfSteps(course, target, up, 1), 1.1, 1e-5);
        placeOnGround(course, 1.1, up, target);
        EXPECT_LT((target.at(20)[0].cast<double>() - turned(Vec3d(3, 0.02, 5))).norm(), 1e-5);
    }
}
