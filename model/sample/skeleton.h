// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille {

/// Joints of the sample's skeleton; parents come before children. In the rest pose all axes are the world's.
struct Skeleton
{
    std::vector<std::string> names;
    std::vector<int> parents; ///< −1 for the root
    std::vector<Vec3d> rest;  ///< positions in the rest pose, metres

    std::size_t size() const { return names.size(); }
    /// Index of a joint by its name. \pre It exists.
    std::size_t index(const std::string& name) const;
};

using JointRotations = std::vector<Eigen::Quaterniond>;

/// One pose: where the root is, and how each joint is turned against its parent.
struct SkeletonPose
{
    Vec3d root = Vec3d::Zero();
    JointRotations rotations;
};

/// Place and rotation of every joint in the world.
struct WorldJoints
{
    std::vector<Vec3d> positions;
    JointRotations rotations;
};
WorldJoints worldJoints(const Skeleton& skeleton, const SkeletonPose& pose);

/// Centre of mass with the shares of body segments. Source: de Leva, 1996 (rounded).
Vec3d centreOfMass(const Skeleton& skeleton, const WorldJoints& joints);

/// Weights of the joints that move a vertex, largest first; they add up to one.
struct VertexWeights
{
    std::array<std::uint16_t, 4> joints{};
    std::array<float, 4> weights{};
};

/// Vertices moved by dual quaternions. Source: Kavan et al., Geometric Skinning with Approximate Dual
/// Quaternion Blending, 2008. \param out one position per vertex.
void skin(const std::vector<Vec3d>& rest, const std::vector<VertexWeights>& weights, const Skeleton& skeleton,
          const WorldJoints& joints, std::vector<Vec3d>& out);

} // namespace quadrille
