// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

enum class BvhChannel
{
    XPosition,
    YPosition,
    ZPosition,
    XRotation,
    YRotation,
    ZRotation,
};

struct BvhJoint
{
    std::string name;
    int parent = -1;              ///< −1 for the root
    Vec3d offset = Vec3d::Zero(); ///< from the parent, in the file's unit
    std::vector<BvhChannel> channels;
    std::size_t firstChannel = 0; ///< column in a row of the motion
};

/// A skeleton and its motion as the file has them; end sites are left out.
struct Bvh
{
    std::vector<BvhJoint> joints; ///< parents first
    std::size_t channelCount = 0;
    std::int64_t frameCount = 0;
    double fps = 0;
    std::vector<double> motion; ///< frames × channels; degrees and the file's unit
};

/// Reads a BVH file.
/// \throws Error file errors, FileEncoding, FileSyntax (with line), CountTooLarge, FileTruncated (fewer
/// frames than promised).
Bvh readBvh(const std::filesystem::path& path);
/// \overload from text. \param path  names the file in errors.
Bvh parseBvh(std::string_view text, const std::filesystem::path& path);

/// The joint angles that a motion is measured against (for evaluation): each joint's rotation relative to its
/// parent.
struct JointAngles
{
    std::vector<std::string> joints;
    double fps = 0;
    std::int64_t frameCount = 0;
    /// frames × joints × 3, radians: the joint's rotation as x, y, z Euler angles, R = Rx·Ry·Rz, whatever
    /// order the file has; every angle in (−π, π], y in [−π/2, π/2].
    std::vector<double> angles;

    std::span<const double, 3> at(std::int64_t frame, std::size_t joint) const;
    std::span<double, 3> at(std::int64_t frame, std::size_t joint);
};

/// Joint angles of a BVH; joints without rotation channels are left out.
/// \param excludeRoot  leaves out the root's rotation, which only places the body.
/// \throws Error BadArgument when no joint is left.
JointAngles jointAngles(const Bvh& bvh, bool excludeRoot = true);

/// The angles at another rate, beginning at frame `first` of the source (or between two), `frameCount` frames
/// long; rotations are interpolated on the sphere. Used to lay a BVH beside the frames of a sequence.
/// \throws Error RangeOutside when the source is shorter (by more than half a frame), BadArgument for an
/// impossible rate.
JointAngles resampled(const JointAngles& angles, double fps, double first, std::int64_t frameCount);

} // namespace quadrille
