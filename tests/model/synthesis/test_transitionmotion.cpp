// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/transitionmotion.h"
#include "tests/model/transition/swayingtube.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

/// Frames of which all poses are one pose turned and moved over the ground (z up).
RootPoses trail(const std::vector<GroundMotion>& motions, const Vec3d& centre = Vec3d(0, 0, 1))
{
    const auto count = static_cast<Eigen::Index>(motions.size());
    RootPoses roots{.up = UpAxis::Z};
    Table<float> turns(count, count);
    for (std::size_t i = 0; i < motions.size(); ++i) {
        roots.centres.push_back(motions[i](centre, Ground(UpAxis::Z)));
        for (std::size_t j = 0; j < motions.size(); ++j)
            turns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                static_cast<float>(wrappedAngle(motions[i].turn - motions[j].turn));
    }
    roots.turns = SharedTable<float>(std::move(turns));
    return roots;
}

Transition diagonal(NodeIndex source, NodeIndex destination, int length)
{
    Transition transition{
        .frames = {source, destination + length - 1}, .sourceWindow = length, .destinationWindow = length};
    for (int t = 0; t < length; ++t)
        transition.path.push_back({source + t, destination + t});
    return transition;
}

/// Two takes of one straight walk along x; the second one lies elsewhere and is turned.
std::vector<GroundMotion> walkTwice(int frames, const GroundMotion& elsewhere)
{
    std::vector<GroundMotion> motions;
    for (int take = 0; take < 2; ++take) {
        for (int f = 0; f < frames; ++f) {
            const GroundMotion step{0, Vec2d(0.1 * f, 0)};
            motions.push_back(take == 0 ? step : elsewhere * step);
        }
    }
    return motions;
}

TEST(RootPoses, PacesAreThoseAroundAFrame)
{
    // A take that stands for a second and then gets on by two units a second along an axis.
    RootPoses roots{.up = UpAxis::Z};
    for (int f = 0; f < 21; ++f)
        roots.centres.emplace_back(0.2 * std::max(0, f - 10), 5, f % 2);
    roots.centres.emplace_back(1, 1, 0);
    const std::vector<double> paces = pacesOf(roots, FrameLayout(std::vector<std::int64_t>{21, 1}), 10);
    EXPECT_DOUBLE_EQ(paces[0], 0);
    EXPECT_DOUBLE_EQ(paces[5], 0);
    EXPECT_NEAR(paces[10], 1, 1e-12) << "half of the time";
    EXPECT_NEAR(paces[15], 2, 1e-12);
    EXPECT_NEAR(paces[20], 2, 1e-12);
    EXPECT_DOUBLE_EQ(paces[21], 0) << "a take of one frame";
}

TEST(Ground, AxesAreRightHanded)
{
    for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        const Ground ground(up);
        const Vec3d first = ground.at({1, 0}, 0);
        const Vec3d second = ground.at({0, 1}, 0);
        EXPECT_TRUE(first.cross(second).isApprox(ground.up()));
        const GroundMotion quarter{std::numbers::pi / 2, Vec2d(2, 3)};
        EXPECT_TRUE(quarter.inSpace(ground)(first).isApprox(quarter(first, ground)));
        EXPECT_TRUE((quarter * quarter.inverse())(Vec2d(4, 5)).isApprox(Vec2d(4, 5)));
    }
}

TEST(RootPoses, FindsHowPosesAreTurned)
{
    const auto topology = test::tubeTopology(12, 9);
    const MeshSequence tube = test::swayingTube(topology, 12, 3, 0.2);
    const Ground ground(UpAxis::Z);
    std::vector<Vec3f> positions;
    const std::vector<double> angles{0, 1, -2.5};
    for (const double angle : angles) {
        const RigidMotion turn = GroundMotion{angle, Vec2d(angle, 3)}.inSpace(ground);
        for (const Vec3f& p : tube.frame(FrameIndex(1)).positions())
            positions.push_back(turn(p.cast<double>()).cast<float>());
    }
    const std::vector<MeshSequence> turned{makeSequence(
        "turned", topology, std::make_shared<MemoryFrames>(positions, topology->vertexCount()), 25)};
    const RootPoses roots = rootPoses(CharacterFrames(turned), UpAxis::Z);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const auto expected =
                wrappedAngle(angles[static_cast<std::size_t>(i)] - angles[static_cast<std::size_t>(j)]);
            EXPECT_NEAR(roots.turns(i, j), expected, 1e-5);
            EXPECT_NEAR(groundAlignment(turned[0].frame(FrameIndex(j)).positions(),
                                        turned[0].frame(FrameIndex(i)).positions(), ground),
                        expected, 1e-5);
        }
    }
}

TEST(TransitionMotion, GoesStraightOnBetweenEqualWalksThatLieElsewhere)
{
    const GroundMotion elsewhere{2.2, Vec2d(-7, 3)};
    const RootPoses roots = trail(walkTwice(20, elsewhere));
    const TransitionMotion motion = transitionMotion(roots, diagonal(5, 25, 10));
    ASSERT_EQ(motion.steps.size(), 10U);
    for (std::size_t t = 0; t < 10; ++t) {
        EXPECT_NEAR(motion.steps[t].centre.x(), 0.5 + 0.1 * static_cast<double>(t), 1e-6);
        EXPECT_NEAR(motion.steps[t].centre.y(), 0, 1e-6);
        EXPECT_DOUBLE_EQ(motion.steps[t].lambda, static_cast<double>(t) / 9);
    }
    EXPECT_NEAR(wrappedAngle(motion.exit().turn + elsewhere.turn), 0, 1e-6);
    EXPECT_TRUE((motion.exit() * elsewhere)(Vec2d(0, 0)).isApprox(Vec2d(0, 0), 1e-5) ||
                (motion.exit() * elsewhere)(Vec2d(0, 0)).norm() < 1e-5);
}

TEST(TransitionMotion, StaysWhereTheWarpRepeatsAFrame)
{
    const RootPoses roots = trail(walkTwice(20, {}));
    Transition transition{.frames = {5, 27}, .sourceWindow = 3, .destinationWindow = 3};
    transition.path = {{5, 25}, {6, 25}, {7, 25}, {7, 26}, {7, 27}};
    const TransitionMotion motion = transitionMotion(roots, transition);
    const std::vector<double> expected{0.5, 0.6, 0.675, 0.725, 0.8};
    for (std::size_t t = 0; t < expected.size(); ++t)
        EXPECT_NEAR(motion.steps[t].centre.x(), expected[t], 1e-6);
}

TEST(TransitionMotion, DoesNotReverseWhereOneTakeTurnsLeftAndTheOtherRight)
{
    std::vector<GroundMotion> motions;
    for (const double side : {1.0, -1.0}) {
        GroundMotion pose{side * 1.5, Vec2d::Zero()};
        for (int f = 0; f < 20; ++f) {
            motions.push_back(pose);
            pose = pose * GroundMotion{side * 0.08, Vec2d(0.1, 0)};
        }
    }
    const RootPoses roots = trail(motions);
    const Transition transition = diagonal(0, 20, 20);
    const auto lengthOf = [&](BlendAlignment alignment) {
        const TransitionMotion motion =
            transitionMotion(roots, transition, {.alignment = alignment, .constantWeight = 0.5});
        double length = 0;
        for (std::size_t t = 1; t < motion.steps.size(); ++t)
            length += (motion.steps[t].centre - motion.steps[t - 1].centre).norm();
        return length;
    };
    const double ours = lengthOf(BlendAlignment::EveryStep);
    EXPECT_GT(ours, lengthOf(BlendAlignment::MidWindow));
    EXPECT_GT(lengthOf(BlendAlignment::MidWindow), lengthOf(BlendAlignment::None));
    EXPECT_NEAR(ours, 19 * 0.1, 0.02);
}

} // namespace

TEST(WrappedAngle, IsTheRemainderOfWholeTurns)
{
    constexpr double pi = std::numbers::pi;
    for (int k = -4000; k <= 4000; ++k) {
        const double angle = k * pi / 1000 + (k % 7) * 1e-9;
        const double remainder = std::remainder(angle, 2 * pi);
        EXPECT_EQ(wrappedAngle(angle), remainder <= -pi ? pi : remainder) << angle;
    }
    EXPECT_EQ(wrappedAngle(-pi), pi);
    EXPECT_EQ(wrappedAngle(pi), pi);
}
} // namespace quadrille
