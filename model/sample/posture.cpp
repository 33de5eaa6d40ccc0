// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/posture.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace quadrille {

namespace {

constexpr double restArmOut = 0.698; ///< of the A-pose
constexpr double restFootYaw = 0.10;

Eigen::Quaterniond turnX(double angle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3d::UnitX()));
}
Eigen::Quaterniond turnY(double angle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3d::UnitY()));
}
Eigen::Quaterniond turnZ(double angle)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3d::UnitZ()));
}

double sign(std::size_t side)
{
    return side == 0 ? 1.0 : -1.0;
}

std::string sideName(std::size_t side, const char* joint)
{
    return (side == 0 ? "left" : "right") + std::string(joint);
}

Eigen::Quaterniond footRotation(std::size_t side, const SidePosture& foot)
{
    const double out = restFootYaw * sign(side);
    return turnY(foot.footYaw + out) * turnX(foot.footPitch) * turnY(-out);
}

/// Takes the frame (along, pole made perpendicular) to another.
Eigen::Quaterniond aligning(const Vec3d& fromAlong, const Vec3d& fromPole, const Vec3d& toAlong,
                            const Vec3d& toPole)
{
    const auto frame = [](const Vec3d& along, const Vec3d& pole) {
        Eigen::Matrix3d m;
        m.col(0) = along.normalized();
        m.col(2) = m.col(0).cross(pole).normalized();
        m.col(1) = m.col(2).cross(m.col(0));
        return m;
    };
    return Eigen::Quaterniond(
        Eigen::Matrix3d(frame(toAlong, toPole) * frame(fromAlong, fromPole).transpose()));
}

void solveArm(const Skeleton& skeleton, SkeletonPose& pose, std::size_t side, const SidePosture& a)
{
    const double s = sign(side);
    const auto rotation = [&](const char* joint) -> Eigen::Quaterniond& {
        return pose.rotations[skeleton.index(sideName(side, joint))];
    };
    // The shoulder blade follows the raised arm.
    const double raised = std::max(0.0, std::max(a.armOut, a.armFlex) - 0.9);
    rotation("Clavicle") = turnY(-s * a.shoulderFore) * turnZ(s * (a.shrug + 0.25 * raised - 0.06));
    const Eigen::Quaterniond hang = turnZ(s * restArmOut);
    rotation("UpperArm") = turnX(-a.armFlex) * turnZ(s * (a.armOut - restArmOut)) * hang *
                           turnY(-s * a.armTwist) * hang.conjugate();
    rotation("Forearm") = hang * turnX(-a.elbow) * turnY(-s * a.pronation) * hang.conjugate();
    rotation("Hand") = hang * turnZ(-s * a.wrist) * hang.conjugate();
    rotation("Fingers") = hang * turnZ(-s * a.curl) * hang.conjugate();
}

/// Turns the arm so that its wrist comes to the place it reaches for.
void reachWithArm(const Skeleton& skeleton, SkeletonPose& pose, const WorldJoints& world, std::size_t side,
                  const SidePosture& a)
{
    if (a.reach <= 0)
        return;
    const std::size_t arm = skeleton.index(sideName(side, "UpperArm"));
    const Eigen::Quaterniond& clavicle = world.rotations[arm - 1];
    // The elbow points back, down and a little out.
    const Vec3d pole = world.rotations[skeleton.index("chest")] * Vec3d(0.35 * sign(side), -0.7, -0.8);
    const Vec3d restPole = -Vec3d::UnitZ();
    const Vec3d target(a.reachX, a.reachY, a.reachZ);
    const auto [upper, lower] = twoBone(skeleton.rest[arm], skeleton.rest[arm + 1], skeleton.rest[arm + 2],
                                        restPole, world.positions[arm], target, pole);
    const Eigen::Quaterniond local = clavicle.conjugate() * upper;
    const double weight = std::clamp(a.reach, 0.0, 1.0);
    pose.rotations[arm] = pose.rotations[arm].slerp(weight, local);
    pose.rotations[arm + 1] = pose.rotations[arm + 1].slerp(weight, upper.conjugate() * lower);
}

void solveLeg(const Skeleton& skeleton, SkeletonPose& pose, const WorldJoints& world, std::size_t side,
              const SidePosture& leg)
{
    const std::size_t hips = skeleton.index("hips");
    const std::size_t thigh = skeleton.index(sideName(side, "Thigh"));
    const Eigen::Quaterniond foot = footRotation(side, leg);
    const Eigen::Quaterniond heading = turnY(leg.footYaw + sign(side) * (0.04 + leg.kneeOut));
    const Vec3d pole = (0.5 * (heading * Vec3d::UnitZ()) +
                        0.5 * (world.rotations[hips] * turnY(sign(side) * leg.kneeOut) * Vec3d::UnitZ()))
                           .normalized();
    const auto [upper, lower] =
        twoBone(skeleton.rest[thigh], skeleton.rest[thigh + 1], skeleton.rest[thigh + 2], Vec3d::UnitZ(),
                world.positions[thigh], ankleTarget(skeleton, side, leg), pole);
    pose.rotations[thigh] = world.rotations[hips].conjugate() * upper;
    pose.rotations[thigh + 1] = upper.conjugate() * lower;
    pose.rotations[thigh + 2] = lower.conjugate() * foot;
    // Toes stay flat while they bear weight.
    const double bearing = std::clamp(1 - leg.footLift / 0.05, 0.0, 1.0);
    const double out = restFootYaw * sign(side);
    const double bend = std::clamp(leg.footPitch, 0.0, 0.95) * (0.25 + 0.75 * bearing);
    pose.rotations[thigh + 3] = turnY(out) * turnX(-bend) * turnY(-out);
}

} // namespace

PostureArray toArray(const Posture& posture)
{
    return std::bit_cast<PostureArray>(posture);
}

Posture fromArray(const PostureArray& channels)
{
    return std::bit_cast<Posture>(channels);
}

Posture standing(const Skeleton& skeleton, double x, double z, double yaw)
{
    Posture p;
    p.hipX = x;
    p.hipZ = z;
    p.hipYaw = yaw;
    for (std::size_t side = 0; side < 2; ++side) {
        const Vec3d& ankle = skeleton.rest[skeleton.index(sideName(side, "Foot"))];
        const Vec3d place = Vec3d(x, 0, z) + turnY(yaw) * Vec3d(ankle.x() * 1.05, 0, ankle.z());
        p.sides[side].footX = place.x();
        p.sides[side].footZ = place.z();
        p.sides[side].footYaw = yaw;
    }
    return p;
}

Vec3d ankleTarget(const Skeleton& skeleton, std::size_t side, const SidePosture& foot)
{
    const std::size_t joint = skeleton.index(sideName(side, "Foot"));
    const double height = skeleton.rest[joint].y();
    const double out = restFootYaw * sign(side);
    // The foot turns about its ball or the back of its heel, both on the ground.
    const Vec3d pivot = turnY(out) * Vec3d(0, -height, foot.footPitch > 0 ? 0.125 : -0.062);
    const Vec3d offset = turnY(foot.footYaw) * pivot - footRotation(side, foot) * pivot;
    return Vec3d(foot.footX, height + foot.footLift, foot.footZ) + offset;
}

double hipExcess(const Skeleton& skeleton, const Posture& posture)
{
    const Eigen::Quaterniond turn = turnY(posture.hipYaw) * turnX(posture.hipPitch) * turnZ(posture.hipRoll);
    double excess = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t thigh = skeleton.index(sideName(side, "Thigh"));
        const double reach = 0.995 * ((skeleton.rest[thigh + 1] - skeleton.rest[thigh]).norm() +
                                      (skeleton.rest[thigh + 2] - skeleton.rest[thigh + 1]).norm());
        const Vec3d hip = Vec3d(posture.hipX, posture.hipY, posture.hipZ) +
                          turn * (skeleton.rest[thigh] - skeleton.rest[0]);
        const Vec3d d = hip - ankleTarget(skeleton, side, posture.sides[side]);
        const double flat = std::min(std::hypot(d.x(), d.z()), 0.98 * reach);
        excess = std::max(excess, d.y() - std::sqrt(reach * reach - flat * flat));
    }
    return excess;
}

std::pair<Eigen::Quaterniond, Eigen::Quaterniond> twoBone(const Vec3d& restA, const Vec3d& restB,
                                                          const Vec3d& restC, const Vec3d& restPole,
                                                          const Vec3d& start, const Vec3d& target,
                                                          const Vec3d& pole)
{
    const double one = (restB - restA).norm();
    const double two = (restC - restB).norm();
    const Vec3d way = target - start;
    const double distance = std::clamp(way.norm(), std::abs(one - two) + 1e-3, 0.9995 * (one + two));
    const Vec3d direction = way.normalized();
    const Vec3d side = (pole - pole.dot(direction) * direction).normalized();
    const double along = (one * one - two * two + distance * distance) / (2 * distance);
    const double off = std::sqrt(std::max(one * one - along * along, 0.0));
    const Vec3d middle = start + along * direction + off * side;
    const Vec3d end = start + distance * direction;
    // The bone's own bend axis decides its twist; it stays the same along the chain.
    const Vec3d axis = direction.cross(side);
    const Vec3d restAxis = (restC - restA).normalized().cross(restPole);
    return {aligning(restB - restA, restAxis, middle - start, axis),
            aligning(restC - restB, restAxis, end - middle, axis)};
}

SkeletonPose solvePosture(const Skeleton& skeleton, const Posture& p)
{
    SkeletonPose pose;
    pose.root = {p.hipX, p.hipY, p.hipZ};
    pose.rotations.assign(skeleton.size(), Eigen::Quaterniond::Identity());
    pose.rotations[skeleton.index("hips")] = turnY(p.hipYaw) * turnX(p.hipPitch) * turnZ(p.hipRoll);
    const auto spine = [&](double share) {
        return turnY(share * p.spineTwist) * turnX(share * p.spineBend) * turnZ(-share * p.spineSide);
    };
    pose.rotations[skeleton.index("spine")] = spine(0.5);
    pose.rotations[skeleton.index("chest")] = spine(0.5);
    const auto head = [&](double share) {
        return turnY(share * p.headYaw) * turnX(share * p.headPitch) * turnZ(share * p.headRoll);
    };
    pose.rotations[skeleton.index("neck")] = head(0.4);
    pose.rotations[skeleton.index("head")] = head(0.6);
    for (std::size_t side = 0; side < 2; ++side)
        solveArm(skeleton, pose, side, p.sides[side]);
    const WorldJoints world = worldJoints(skeleton, pose);
    for (std::size_t side = 0; side < 2; ++side) {
        reachWithArm(skeleton, pose, world, side, p.sides[side]);
        solveLeg(skeleton, pose, world, side, p.sides[side]);
    }
    return pose;
}

Posture postureAt(const std::vector<PostureKey>& keys, double time)
{
    if (time <= keys.front().time)
        return keys.front().posture;
    if (time >= keys.back().time)
        return keys.back().posture;
    std::size_t i = 0;
    while (time >= keys[i + 1].time)
        ++i;
    const auto value = [&](std::size_t k, std::size_t c) { return toArray(keys[k].posture)[c]; };
    const double span = keys[i + 1].time - keys[i].time;
    const double t = (time - keys[i].time) / span;
    PostureArray out{};
    for (std::size_t c = 0; c < postureChannels; ++c) {
        // Slopes that do not overshoot: zero at extremes (Fritsch and Carlson).
        const auto slope = [&](std::size_t k) {
            if (k == 0 || k + 1 == keys.size())
                return 0.0;
            const double before = (value(k, c) - value(k - 1, c)) / (keys[k].time - keys[k - 1].time);
            const double after = (value(k + 1, c) - value(k, c)) / (keys[k + 1].time - keys[k].time);
            return before * after <= 0 ? 0.0 : 2 * before * after / (before + after);
        };
        const double a = value(i, c);
        const double b = value(i + 1, c);
        const double t2 = t * t;
        const double t3 = t2 * t;
        out[c] = (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * span * slope(i) + (3 * t2 - 2 * t3) * b +
                 (t3 - t2) * span * slope(i + 1);
    }
    return fromArray(out);
}

} // namespace quadrille
