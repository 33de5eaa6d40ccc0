// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/skeleton.h"

#include <array>
#include <vector>

namespace quadrille {

/// What an animator sets on one side of the body; angles in radians.
struct SidePosture
{
    double armFlex = 0.05;   ///< upper arm forwards
    double armOut = 0.14;    ///< upper arm away from the body; 0 hangs down
    double armTwist = 0;     ///< about its own axis, inwards
    double elbow = 0.22;     ///< bend
    double pronation = 0;    ///< forearm turned, palm backwards
    double wrist = 0.05;     ///< bend towards the palm
    double curl = 0.25;      ///< fingers closed
    double shrug = 0;        ///< shoulder raised
    double shoulderFore = 0; ///< shoulder brought forwards
    double footX = 0;        ///< ankle over the ground, metres
    double footZ = 0;
    double footLift = 0;  ///< above the ground, metres
    double footYaw = 0;   ///< to the left
    double footPitch = 0; ///< heel up about the ball; negative: toes up about the heel
    double kneeOut = 0;   ///< knee turned outwards
    double reach = 0;     ///< 0: the arm's angles above count; 1: the wrist goes to the place below
    double reachX = 0;    ///< metres in the world
    double reachY = 1;
    double reachZ = 0.3;
};

/// A pose as an animator thinks of it: hips in the world, feet on the ground, the rest as angles. All members
/// are doubles, so that postures are interpolated channel by channel.
struct Posture
{
    double hipX = 0;
    double hipY = 0.955;
    double hipZ = 0;
    double hipYaw = 0;     ///< to the left
    double hipPitch = 0;   ///< forwards
    double hipRoll = 0;    ///< left side up
    double spineBend = 0;  ///< forwards
    double spineSide = 0;  ///< to the right
    double spineTwist = 0; ///< to the left
    double headPitch = 0;  ///< down
    double headYaw = 0;    ///< to the left
    double headRoll = 0;
    std::array<SidePosture, 2> sides; ///< left, right
};

constexpr std::size_t postureChannels = sizeof(Posture) / sizeof(double);
using PostureArray = std::array<double, postureChannels>;
PostureArray toArray(const Posture& posture);
Posture fromArray(const PostureArray& channels);

/// Standing at ease at a place: feet beside each other.
Posture standing(const Skeleton& skeleton, double x = 0, double z = 0, double yaw = 0);

/// Joint angles of a posture: legs by inverse kinematics, the rest directly.
SkeletonPose solvePosture(const Skeleton& skeleton, const Posture& posture);

/// Lowest point of a foot's contact: where the ankle is for a place, pitch and lift of the foot.
Vec3d ankleTarget(const Skeleton& skeleton, std::size_t side, const SidePosture& foot);

/// How much lower the hips must be for both feet to be in reach, metres; 0 when they are.
double hipExcess(const Skeleton& skeleton, const Posture& posture);

/// A two-bone chain: bends in the plane of `pole`.
/// \return world rotations of the upper and lower bone that bring the end to `target`, or as near as it gets.
std::pair<Eigen::Quaterniond, Eigen::Quaterniond> twoBone(const Vec3d& restA, const Vec3d& restB,
                                                          const Vec3d& restC, const Vec3d& restPole,
                                                          const Vec3d& start, const Vec3d& target,
                                                          const Vec3d& pole);

/// A posture at a time.
struct PostureKey
{
    double time = 0; ///< seconds
    Posture posture;
};

/// Smooth (monotone cubic per channel) interpolation through keys; held before the first and after the last.
Posture postureAt(const std::vector<PostureKey>& keys, double time);

} // namespace quadrille
