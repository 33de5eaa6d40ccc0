// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/message.h"
#include "model/sequence/io/bvh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace quadrille {

namespace {

constexpr double radiansPerDegree = std::numbers::pi / 180.0;

std::optional<Vec3d> axisOf(BvhChannel channel)
{
    switch (channel) {
    case BvhChannel::XRotation:
        return Vec3d::UnitX();
    case BvhChannel::YRotation:
        return Vec3d::UnitY();
    case BvhChannel::ZRotation:
        return Vec3d::UnitZ();
    default:
        return std::nullopt;
    }
}

Eigen::Quaterniond rotationOf(const BvhJoint& joint, const double* row)
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    for (std::size_t c = 0; c < joint.channels.size(); ++c) {
        if (const auto axis = axisOf(joint.channels[c]))
            rotation = rotation * Eigen::AngleAxisd(row[joint.firstChannel + c] * radiansPerDegree, *axis);
    }
    return rotation;
}

/// x, y, z with R = Rx·Ry·Rz; z is zero where y is ±π/2 and only the sum of x and z counts.
Vec3d eulerAngles(const Eigen::Quaterniond& rotation)
{
    const Eigen::Matrix3d R = rotation.toRotationMatrix();
    const double y = std::asin(std::clamp(R(0, 2), -1.0, 1.0));
    if (std::abs(R(0, 2)) > 1 - 1e-12)
        return {std::atan2(R(2, 1), R(1, 1)), y, 0};
    return {std::atan2(-R(1, 2), R(2, 2)), y, std::atan2(-R(0, 1), R(0, 0))};
}

Eigen::Quaterniond fromEuler(std::span<const double, 3> angles)
{
    return Eigen::AngleAxisd(angles[0], Vec3d::UnitX()) * Eigen::AngleAxisd(angles[1], Vec3d::UnitY()) *
           Eigen::AngleAxisd(angles[2], Vec3d::UnitZ());
}

void store(const Vec3d& from, std::span<double, 3> to)
{
    std::copy(from.data(), from.data() + 3, to.begin());
}

} // namespace

std::span<const double, 3> JointAngles::at(std::int64_t frame, std::size_t joint) const
{
    return std::span<const double, 3>(
        angles.data() + (static_cast<std::size_t>(frame) * joints.size() + joint) * 3, 3);
}

std::span<double, 3> JointAngles::at(std::int64_t frame, std::size_t joint)
{
    return std::span<double, 3>(angles.data() + (static_cast<std::size_t>(frame) * joints.size() + joint) * 3,
                                3);
}

JointAngles jointAngles(const Bvh& bvh, bool excludeRoot)
{
    JointAngles result;
    std::vector<const BvhJoint*> turning;
    for (const BvhJoint& joint : bvh.joints) {
        const bool turns = std::any_of(joint.channels.begin(), joint.channels.end(),
                                       [](BvhChannel c) { return axisOf(c).has_value(); });
        if ((excludeRoot && joint.parent < 0) || !turns)
            continue;
        turning.push_back(&joint);
        result.joints.push_back(joint.name);
    }
    if (turning.empty()) {
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("No joint has rotation channels")},
                      {"remedy", QUADRILLE_MESSAGE("Choose a BVH with joint rotations.")}}});
    }
    result.fps = bvh.fps;
    result.frameCount = bvh.frameCount;
    result.angles.resize(static_cast<std::size_t>(bvh.frameCount) * turning.size() * 3);
    for (std::int64_t f = 0; f < bvh.frameCount; ++f) {
        const double* row = bvh.motion.data() + static_cast<std::size_t>(f) * bvh.channelCount;
        for (std::size_t j = 0; j < turning.size(); ++j)
            store(eulerAngles(rotationOf(*turning[j], row)), result.at(f, j));
    }
    return result;
}

JointAngles resampled(const JointAngles& angles, double fps, double first, std::int64_t frameCount)
{
    if (!(fps > 0) || !std::isfinite(fps)) {
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", "A frame rate of " + std::to_string(fps) + " is not possible"},
                      {"remedy", QUADRILLE_MESSAGE("Give a positive number of frames a second.")}}});
    }
    const double step = angles.fps / fps;
    const double end = first + static_cast<double>(frameCount - 1) * step;
    if (!(first >= 0) || frameCount < 1 || end > static_cast<double>(angles.frameCount) - 0.5) {
        throw Error(ErrorCode::RangeOutside, {{},
                                              {},
                                              {{"first", std::to_string(std::llround(first))},
                                               {"last", std::to_string(std::llround(end))},
                                               {"count", std::to_string(angles.frameCount)}}});
    }
    JointAngles result;
    result.joints = angles.joints;
    result.fps = fps;
    result.frameCount = frameCount;
    result.angles.resize(static_cast<std::size_t>(frameCount) * angles.joints.size() * 3);
    for (std::int64_t f = 0; f < frameCount; ++f) {
        const double time = first + static_cast<double>(f) * step;
        const auto before =
            std::min(static_cast<std::int64_t>(std::floor(time + 1e-9)), angles.frameCount - 1);
        const auto after = std::min(before + 1, angles.frameCount - 1);
        const double weight = std::clamp(time - static_cast<double>(before), 0.0, 1.0);
        for (std::size_t j = 0; j < angles.joints.size(); ++j) {
            const auto rotation =
                fromEuler(angles.at(before, j)).slerp(weight, fromEuler(angles.at(after, j)));
            store(eulerAngles(rotation), result.at(f, j));
        }
    }
    return result;
}

} // namespace quadrille
