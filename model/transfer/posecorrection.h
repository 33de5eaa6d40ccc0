// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transfer/transferclip.h"

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace quadrille {

/// The rotation of each marked place from a target's pose to the template's reference pose: an arm that a
/// scan holds away from its body is brought to where the template's is. As rigid as possible: the ways from
/// each mark to those near it over the template's surface, and where it faces, agree as well as they can;
/// turns of a few degrees, which differences of shape look like, are left out. \param target  turned as the
/// template, metres. \return one for each pair, unit quaternions whose real part is not negative; all the
/// identity for fewer than four pairs. Cost: for each pair the surface distances up to its fourth neighbour;
/// 50 rounds of a 3 × 3 rotation each.
std::vector<Eigen::Quaterniond> poseCorrections(const PosedMesh& reference, const PosedMesh& target,
                                                std::span<const TrianglePair> pairs);

} // namespace quadrille
