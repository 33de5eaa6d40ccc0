// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/sequence/io/bvh.h"

#include <span>

namespace quadrille {

/// How the angles of a joint in two frames are compared.
enum class JointAngleMetric
{
    EulerAngles, ///< differences of the three angles, wrapped to [0, π] (SMCAS Table 1)
    Rotations,   ///< the angle of the rotation from one to the other, whatever the order of Euler angles
};

/// The frames of several sequences, one after the other, with the joints that all of them have, in the order
/// of the first. \throws Error BadArgument where they have none in common.
JointAngles joined(std::span<const JointAngles> sequences);

/// Some of the joints. \param joints  indices.
JointAngles selectJoints(const JointAngles& angles, std::span<const std::size_t> joints);

/// How far apart the poses of a skeleton are: the Euclidean norm of the differences of all joints.
/// \return frames × frames, radians; symmetric, zeros on the diagonal. Cost: O(frames² · joints).
Table<float> jointAngleDistances(const JointAngles& angles,
                                 JointAngleMetric metric = JointAngleMetric::EulerAngles);

} // namespace quadrille
