// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/parts/bodyparts.h"
#include "model/variation/sampling.h"
#include "model/variation/training.h"

#include <span>

namespace quadrille {

/// The training rows of a part without its displacements, each pose moved so that what it shares with its
/// parent has the place that it has in the mean pose: stitching puts it there. Those of the root stay where
/// they are.
RowMatrix posesOnParent(const PartTraining& training, const BodyPart& part);

/// What a model makes of a latent trajectory.
struct PosedTrajectory
{
    RowMatrix coefficients; ///< of the training rows in the pose of each frame
    double uncertainty = 0; ///< the greatest variance of a pose, as a share of that of an unknown one
};

/// A guess of how far takes of a movement of which there is one are apart: this share of how far its frames
/// are.
inline constexpr double shareOfOneTake = 0.15;

/// Captured takes of one movement.
struct SpreadGroup
{
    double share = 1;           ///< of all groups
    std::vector<RowSpan> takes; ///< their rows, as many in each; at least one
};

/// How far apart poses of a part are, metres: in each frame the root mean square distance of a vertex from
/// its mean, of that the mean over the frames. Poses are sums of training poses, so that Y·Yᵀ is all that is
/// needed of them. Immutable; safe from any thread.
class PoseSpread
{
public:
    /// \param rows  centred training rows, three coordinates of each vertex first; of a part that is laid
    /// onto its parent those of posesOnParent. \param groups  of captured takes; their shares add up to 1.
    PoseSpread(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows,
               std::span<const SpreadGroup> groups, Eigen::Index vertices, const Progress& progress = {});
    /// \overload of one group.
    PoseSpread(const GpdmState& state, const Eigen::Ref<const RowMatrix>& rows,
               std::span<const RowSpan> takes, Eigen::Index vertices, const Progress& progress = {});

    PosedTrajectory posed(const RowMatrix& trajectory) const;
    /// Between trajectories of the same length, frame by frame, made larger by √(n/(n − 1)); 0 of fewer than
    /// two.
    double between(std::span<const PosedTrajectory> trajectories) const;
    /// How much the way of a vertex bends from frame to frame: the root mean square of second differences,
    /// metres; 0 of fewer than three frames.
    double bending(const PosedTrajectory& trajectory) const;
    /// Between the captured takes of a group, the mean over groups by their shares. Where there is one, or
    /// all are the same, shareOfOneTake of how far its frames are apart.
    double reference() const { return m_reference; }
    /// Whether the reference is such a guess, in any group.
    bool isGuess() const { return m_isGuess; }

private:
    double distanceSquares(const RowMatrix& coefficients) const;
    void addReference(const SpreadGroup& group);

    PoseReconstruction m_poses; ///< without coordinates: its coefficients and variances are what counts
    double m_priorVariance;
    RowMatrix m_gram; ///< of the vertices' coordinates
    Eigen::Index m_vertices;
    double m_reference = 0;
    bool m_isGuess = false;
};

} // namespace quadrille
