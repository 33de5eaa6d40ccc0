// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/units.h"

#include <Eigen/Core>
#include <span>

namespace quadrille {

/// A pose and the mean of its vertices.
struct CentredPose
{
    Positions positions;
    Vec3d centre = Vec3d::Zero();
};

/// The covariances Σ x·yᵀ of all pairs of two sets of poses, x of a target, y of a source, both centred: rows
/// 3·t … 3·t+2 and columns 3·s … 3·s+2 hold that of target t and source s, m². Single-precision products over
/// 32 vertices each, summed in double precision. Exactly symmetric for equal poses.
/// \pre All poses have the same number of vertices.
/// \throws Error Cancelled. Cost: O(targets · sources · vertices).
Eigen::MatrixXd covariances(std::span<const CentredPose> targets, std::span<const CentredPose> sources,
                            const Progress& progress = {});

} // namespace quadrille
