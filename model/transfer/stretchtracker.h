// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poseframes.h"
#include "model/transfer/transferclip.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace quadrille {

/// How the skin of a template is stretched and pressed together about each mark: the polar factor S of what
/// happens to the triangles there (SMCAS eq. 1), which the rotations of SCANS leave out; bends need it to
/// keep their volume. A mean over the surface near the mark, as single triangles are noisy.
class StretchTracker
{
public:
    /// \param reference  the pose that stretches are counted from. \throws Error as SolidTarget. Cost: for
    /// each pair the surface distances up to the radius.
    StretchTracker(const PosedMesh& reference, std::span<const TrianglePair> pairs);

    /// \param frame  all vertices, metres. \return for each pair a symmetric matrix in the axes of the
    /// reference pose; the identity where the surface is as in that. Cost: O(triangles near marks).
    std::vector<Eigen::Matrix3d> next(Positions frame) const;

private:
    struct Near
    {
        std::size_t triangle = 0; ///< of m_triangles
        double weight = 0;
    };

    std::vector<Triangle> m_triangles; ///< of the template, near any mark
    PoseFrames m_reference;
    std::vector<std::vector<Near>> m_near; ///< of each pair
};

} // namespace quadrille
