// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/evaluation/jointangledistance.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

using namespace quadrille;
using ::testing::ElementsAre;

namespace {

using std::numbers::pi;

JointAngles anglesOf(std::vector<std::string> joints, std::vector<double> angles)
{
    JointAngles result{.joints = std::move(joints), .fps = 30, .frameCount = 0, .angles = std::move(angles)};
    result.frameCount = static_cast<std::int64_t>(result.angles.size() / (3 * result.joints.size()));
    return result;
}

} // namespace

TEST(JointAngleDistance, IsTheNormOfWrappedDifferences)
{
    const JointAngles angles = anglesOf({"knee", "hip"}, {0, 0, 0, 0, 0, 0, //
                                                          3, 0, 0, 0, 4, 0, // more than a half turn
                                                          -pi + 0.1, 0, 0, 0, 0, 0.5}); // wraps
    const Table<float> distances = jointAngleDistances(angles);
    EXPECT_FLOAT_EQ(distances(0, 1), static_cast<float>(std::hypot(3, 2 * pi - 4)));
    EXPECT_FLOAT_EQ(distances(0, 2), static_cast<float>(std::hypot(pi - 0.1, 0.5)));
    EXPECT_NEAR(distances(1, 2), std::hypot(pi + 0.1 - 3, 2 * pi - 4, 0.5), 1e-6);
    EXPECT_EQ(distances(1, 0), distances(0, 1));
    EXPECT_EQ(distances(2, 2), 0);
}

TEST(JointAngleDistance, OfRotationsDoesNotDependOnTheAngles)
{
    // Rx(π)·Ry(π)·Rz(π) turns nothing.
    const JointAngles angles = anglesOf({"knee"}, {0, 0, 0, pi, pi, pi, 0, 0.3, 0});
    const Table<float> distances = jointAngleDistances(angles, JointAngleMetric::Rotations);
    EXPECT_NEAR(distances(0, 1), 0, 1e-7);
    EXPECT_NEAR(distances(0, 2), 0.3, 1e-7);
    EXPECT_NEAR(distances(1, 2), 0.3, 1e-7);
    EXPECT_GT(jointAngleDistances(angles)(0, 1), 5);
}

TEST(JointAngleDistance, SequencesAreJoinedByTheJointsThatTheyShare)
{
    const std::vector<JointAngles> sequences{
        anglesOf({"knee", "hip", "toe"}, {1, 1, 1, 2, 2, 2, 3, 3, 3}),
        anglesOf({"toe", "ear", "knee"}, {3, 4, 5, 0, 0, 0, 6, 7, 8, 9, 9, 9, 0, 0, 0, 1, 2, 3})};
    const JointAngles all = joined(sequences);
    EXPECT_THAT(all.joints, ElementsAre("knee", "toe"));
    EXPECT_EQ(all.frameCount, 3);
    EXPECT_THAT(all.angles, ElementsAre(1, 1, 1, 3, 3, 3, 6, 7, 8, 3, 4, 5, 1, 2, 3, 9, 9, 9));
}

TEST(JointAngleDistance, SkeletonsWithoutACommonJointAreRefused)
{
    const std::vector<JointAngles> sequences{anglesOf({"knee"}, {1, 1, 1}), anglesOf({"ear"}, {1, 1, 1})};
    EXPECT_THROW(joined(sequences), Error);
    EXPECT_THROW(joined({}), Error);
}
