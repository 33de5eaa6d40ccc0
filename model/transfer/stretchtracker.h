// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poseframes.h"
#include "model/transfer/surroundings.h"

#include <Eigen/Core>
#include <vector>

namespace quadrille {

/// How the skin of a template is stretched and pressed together about each mark: the polar factor S of what
/// happens to the triangles there (SMCAS eq. 1), which the rotations of SCANS leave out; bends need it to
/// keep their volume. A mean over the surface near the mark, as single triangles are noisy.
class StretchTracker
{
public:
    /// \param patches  over which stretches are means. \param reference  the pose that they are counted from,
    /// all vertices, metres.
    StretchTracker(MarkPatches patches, Positions reference);

    /// \param frame  all vertices, metres. \return for each mark a symmetric matrix in the axes of the
    /// reference pose; the identity where the surface is as in that. Cost: O(triangles near marks).
    std::vector<Eigen::Matrix3d> next(Positions frame) const;

private:
    MarkPatches m_patches;
    PoseFrames m_reference;
};

} // namespace quadrille
