// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/topology.h"

#include <span>
#include <vector>

namespace quadrille {

/// Per triangle of a pose the orthonormal frame with x along v1 − v3 and z along the normal, as a unit
/// quaternion, and the two edges v1 − v3 = (b11, 0), v2 − v3 = (b12, b22) in it, metres; b11 and b22 are
/// positive. Double precision, one array per quantity.
struct PoseFrames
{
    std::vector<double> qw;
    std::vector<double> qx;
    std::vector<double> qy;
    std::vector<double> qz;
    std::vector<double> b11;
    std::vector<double> b12;
    std::vector<double> b22;
    /// Triangles with an area below 1e-12 of the squared diagonal of the pose's bounding box, ascending;
    /// their frames are the identity.
    std::vector<int> degenerate;

    std::size_t size() const { return qw.size(); }
};

/// Frames of all triangles.
/// \param positions  of all vertices, finite, metres.
PoseFrames poseFrames(std::span<const Triangle> triangles, Positions positions);

} // namespace quadrille
