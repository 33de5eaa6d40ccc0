// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poseframes.h"
#include "model/transfer/deformationfield.h"
#include "model/transfer/surroundings.h"

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace quadrille {

/// Follows marked triangles of a template, or what lies about them, from frame to frame (SCANS §4). A
/// rotation is two quaternions: in the first frame signs are chosen so that marks which turn alike have like
/// ones, later so that each goes on from where it was. So a part may turn by up to 360 degrees against the
/// body, and the body as often as it likes.
class MarkTracker
{
public:
    /// \param patches  what tells how the marks turn. \param reference  all vertices, metres. Triangles
    /// without an area in it, or later, tell nothing; marks without others turn with the body.
    MarkTracker(MarkPatches patches, Positions reference);

    /// The rotations in the next frame, by the polar factor of each triangle's deformation, and their means
    /// over patches. \param frame  all vertices. Cost: O(triangles of patches); in the first frame O(marks²)
    /// for up to 1,000 of them.
    MarkDeformations next(Positions frame);

private:
    void chooseSigns(MarkDeformations& now) const;
    void continueSigns(MarkDeformations& now) const;

    MarkPatches m_patches;
    PoseFrames m_reference;
    std::vector<Eigen::Quaterniond> m_before;
    Eigen::Quaterniond m_rootBefore = Eigen::Quaterniond::Identity();
};

} // namespace quadrille
