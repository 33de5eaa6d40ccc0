// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/jointangledistance.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

double wrappedDifference(double a, double b)
{
    const double difference = std::fmod(std::abs(a - b), 2 * std::numbers::pi);
    return std::min(difference, 2 * std::numbers::pi - difference);
}

Eigen::Quaterniond rotationOf(std::span<const double, 3> angles)
{
    return Eigen::AngleAxisd(angles[0], Vec3d::UnitX()) * Eigen::AngleAxisd(angles[1], Vec3d::UnitY()) *
           Eigen::AngleAxisd(angles[2], Vec3d::UnitZ());
}

/// \param square  (frame, frame) → squared distance.
template <typename Square>
Table<float> tableOfSquares(std::int64_t frames, const Square& square)
{
    Table<float> table = Table<float>::Zero(frames, frames);
    tbb::parallel_for(std::int64_t{0}, frames, [&](std::int64_t i) {
        for (std::int64_t j = 0; j < frames; ++j) {
            if (i != j)
                table(i, j) = static_cast<float>(std::sqrt(square(std::min(i, j), std::max(i, j))));
        }
    });
    return table;
}

} // namespace

JointAngles joined(std::span<const JointAngles> sequences)
{
    JointAngles result;
    std::vector<std::string> common;
    if (!sequences.empty()) {
        result.fps = sequences.front().fps;
        for (const std::string& joint : sequences.front().joints) {
            const bool isEverywhere = std::all_of(sequences.begin(), sequences.end(), [&](const auto& other) {
                return std::find(other.joints.begin(), other.joints.end(), joint) != other.joints.end();
            });
            if (isEverywhere)
                common.push_back(joint);
        }
    }
    if (common.empty()) {
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("The sequences' joint angles have no joint in common")},
                      {"remedy", QUADRILLE_MESSAGE("Choose BVH files of one skeleton.")}}});
    }
    result.joints = common;
    for (const JointAngles& sequence : sequences) {
        std::vector<std::size_t> indices;
        indices.reserve(common.size());
        for (const std::string& joint : common)
            indices.push_back(static_cast<std::size_t>(
                std::find(sequence.joints.begin(), sequence.joints.end(), joint) - sequence.joints.begin()));
        const JointAngles chosen = selectJoints(sequence, indices);
        result.angles.insert(result.angles.end(), chosen.angles.begin(), chosen.angles.end());
        result.frameCount += sequence.frameCount;
    }
    return result;
}

JointAngles selectJoints(const JointAngles& angles, std::span<const std::size_t> joints)
{
    JointAngles result{.joints = {}, .fps = angles.fps, .frameCount = angles.frameCount, .angles = {}};
    result.joints.reserve(joints.size());
    for (const std::size_t joint : joints)
        result.joints.push_back(angles.joints[joint]);
    for (std::int64_t frame = 0; frame < angles.frameCount; ++frame) {
        for (const std::size_t joint : joints) {
            const auto three = angles.at(frame, joint);
            result.angles.insert(result.angles.end(), three.begin(), three.end());
        }
    }
    return result;
}

Table<float> jointAngleDistances(const JointAngles& angles, JointAngleMetric metric)
{
    const std::size_t joints = angles.joints.size();
    if (metric == JointAngleMetric::EulerAngles) {
        return tableOfSquares(angles.frameCount, [&](std::int64_t i, std::int64_t j) {
            const double* a = angles.angles.data() + static_cast<std::size_t>(i) * joints * 3;
            const double* b = angles.angles.data() + static_cast<std::size_t>(j) * joints * 3;
            return std::transform_reduce(a, a + joints * 3, b, 0.0, std::plus<>(), [](double x, double y) {
                const double difference = wrappedDifference(x, y);
                return difference * difference;
            });
        });
    }
    std::vector<Eigen::Quaterniond> rotations;
    rotations.reserve(static_cast<std::size_t>(angles.frameCount) * joints);
    for (std::int64_t frame = 0; frame < angles.frameCount; ++frame) {
        for (std::size_t joint = 0; joint < joints; ++joint)
            rotations.push_back(rotationOf(angles.at(frame, joint)));
    }
    return tableOfSquares(angles.frameCount, [&](std::int64_t i, std::int64_t j) {
        const auto* a = rotations.data() + static_cast<std::size_t>(i) * joints;
        const auto* b = rotations.data() + static_cast<std::size_t>(j) * joints;
        return std::transform_reduce(a, a + joints, b, 0.0, std::plus<>(), [](const auto& x, const auto& y) {
            const double angle = x.angularDistance(y);
            return angle * angle;
        });
    });
}

} // namespace quadrille
