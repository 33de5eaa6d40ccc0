// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/surfacevolume.h"
#include "model/transfer/placement.h"
#include "model/transfer/posedsurface.h"
#include "model/transfer/transferclip.h"
#include "model/transfer/transfersolver.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// A transfer of which all is known but the poses themselves. Immutable; safe from any thread.
class PreparedTransfer
{
public:
    /// \param solid  of the target; made anew for another target only, whatever the pairs.
    /// \param clip, reference, target, pairs, settings  as for transferClip. \throws Error as that.
    /// Cost: one numeric factorisation; reads all frames of the clip, one after the other.
    PreparedTransfer(const MeshSequence& clip, const PosedMesh& reference, const PosedMesh& target,
                     std::shared_ptr<const TransferTarget> solid, std::span<const TrianglePair> pairs,
                     const TransferSettings& settings, const Progress& progress = {});

    std::size_t frames() const { return m_deformations.size(); }
    std::size_t vertices() const { return m_vertices; }
    const TemplateCourse& course() const { return m_course; }
    /// Of the target about the up axis beforehand, radians.
    double turn() const { return m_turn; }
    /// The ratio of the heights of target and template.
    double sizeRatio() const { return m_sizeRatio; }

    /// \param out  the target's vertices, metres, the middle of its marks at the origin.
    void pose(std::size_t frame, MutablePositions out, TransferSolver::Scratch& scratch) const
    {
        m_solver.pose(m_deformations[frame], out, scratch);
    }
    bool knowsVolume() const { return m_volumeAtRest != 0; }
    /// A share of that at rest. \pre knowsVolume().
    double volumeOf(Positions pose) const { return *m_volume.of(pose) / m_volumeAtRest; }
    /// The mean angle that marked triangles miss in a pose of a frame, radians.
    double markError(std::size_t frame, Positions pose) const;

private:
    void follow(const MeshSequence& clip, const PosedSurface& reference, std::span<const TrianglePair> pairs,
                const TransferSettings& settings, const Progress& progress);
    void turnBeforehand(const PosedSurface& reference, const PosedMesh& target,
                        std::span<const TrianglePair> pairs, const TransferSettings& settings);

    std::size_t m_vertices;
    double m_turn;
    double m_sizeRatio;
    TransferSolver m_solver;
    std::vector<MarkDeformations> m_deformations; ///< of each frame, from the target's own pose
    TemplateCourse m_course;
    SurfaceVolume m_volume;
    double m_volumeAtRest;
    std::vector<Triangle> m_triangles; ///< of the target that are marked
    PoseFrames m_rest;
};

} // namespace quadrille
