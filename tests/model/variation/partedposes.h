// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/procrustes.h"
#include "model/variation/parts/stitching.h"
#include "tests/model/largestdistance.h"
#include "tests/model/transition/bars.h"
#include "tests/model/variation/handmadeparts.h"

#include <algorithm>
#include <vector>

namespace quadrille::test {

using Pose = std::vector<Vec3f>;

inline const RigidMotion someMotion{
    Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Vec3d(1, 2, -0.5).normalized())), Vec3d(3, -1, 0.4)};
inline const RigidMotion otherMotion{
    Eigen::Quaterniond(Eigen::AngleAxisd(2.2, Vec3d(-1, 0.3, 2).normalized())), Vec3d(-2, 0.1, 5)};

inline Pose movedBy(const Pose& pose, const RigidMotion& motion)
{
    return moved(pose, [&](const Vec3d& p) { return motion(p); });
}

inline Pose stitched(const Stitching& stitching, const std::vector<Pose>& poses)
{
    Pose out(stitching.topology().vertexCount());
    stitching.stitch(viewed(poses), out);
    return out;
}

inline std::vector<Pose> cutDifferently(const PartedBar& parted, const std::vector<Pose>& wholes)
{
    std::vector<Pose> poses;
    for (std::size_t p = 0; p < wholes.size(); ++p)
        poses.push_back(cutPose(parted.parts, wholes[p])[p]);
    return poses;
}

/// Bars that are bent and twisted differently, one for each part.
inline std::vector<Pose> variousPoses(const PartedBar& parted, double amount)
{
    std::vector<Pose> wholes;
    for (int p = 0; p < 5; ++p)
        wholes.push_back(
            bent(twisted(parted.bar.positions, 2.0, amount * (p - 2)), 2.0, 0.6 + amount * (p % 3)));
    return cutDifferently(parted, wholes);
}

} // namespace quadrille::test
