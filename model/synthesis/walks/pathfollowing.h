// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clipplan.h"
#include "model/synthesis/walks/constraints.h"

#include <vector>

namespace quadrille {

/// A frame of a clip beside the path that it follows, in the coordinates of the clip.
struct FollowedFrame
{
    Vec3d centre; ///< of the body; on the ground where heights do not count
    Vec3d wanted; ///< the point of the path at the length that was walked until then

    double deviation = 0; ///< distance of both, metres
};

/// Compares each frame of a clip with the path, as the search for its walk does.
/// \param metresPerUnit  of the coordinates of the clip. \pre the path has two points at least.
std::vector<FollowedFrame> followPath(const PathConstraint& path, const ClipPlan& plan,
                                      double metresPerUnit = 1);

} // namespace quadrille
