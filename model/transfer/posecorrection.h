// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transfer/posedsurface.h"

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace quadrille {

/// The rotation of each marked place from a target's pose to the template's reference pose: an arm that a
/// scan holds away from its body is brought to where the template's is. The template's surface is laid onto
/// the target's marks as rigidly as it can be (pliablesurface.h), marks that do not fit counting less; turns
/// of a few degrees, which differences of shape look like, are left out. \param target  turned as the
/// template, metres. \return one for each pair, unit quaternions whose real part is not negative; all the
/// identity for fewer than four pairs, and where the target is more like the template seen in a mirror. Cost:
/// see PliableSurface.
std::vector<Eigen::Quaterniond> poseCorrections(const PosedSurface& reference, const PosedMesh& target,
                                                std::span<const TrianglePair> pairs);

} // namespace quadrille
