// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <Eigen/Geometry>
#include <span>

namespace quadrille {

/// The rotation that turns points onto others with the least squared error, centroids removed: no scale, no
/// reflection. Where several rotations are equally good, the smallest of them.
/// \param covariance  Σ x·yᵀ over the points, x to be reached, y to be turned, both centred; any unit.
/// \return unit quaternion, w ≥ 0. Source: Horn 1987, by the largest root of its characteristic polynomial
/// (Theobald 2005), by the eigenvectors where two roots nearly meet.
Eigen::Quaterniond rotationOfCovariance(const Eigen::Matrix3d& covariance);

/// A rotation about the origin, then a translation.
struct RigidMotion
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Vec3d translation = Vec3d::Zero();

    Vec3d operator()(const Vec3d& point) const { return rotation * point + translation; }
};

/// Mean of some positions; the origin when there are none.
Vec3d centroid(Positions positions);

/// The rigid motion that brings one pose nearest to another, by the mean squared vertex distance.
/// \pre Both poses have as many vertices.
RigidMotion rigidProcrustes(Positions moved, Positions target);
/// The same by the weighted mean. \param weights  one per vertex, none negative, not all zero.
RigidMotion rigidProcrustes(Positions moved, Positions target, std::span<const double> weights);

} // namespace quadrille
