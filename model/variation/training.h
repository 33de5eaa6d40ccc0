// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/procrustes.h"
#include "model/sequence/meshsequence.h"
#include "model/variation/bodyparts.h"
#include "model/variation/gpdm.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// How a take runs against the reference: the same phase of the movement at the same place.
struct TakeWarp
{
    FrameRange frames; ///< of the take that are used: one cycle of it, or all
    /// Of each reference frame its position in the take, in frames of the take (fractional), ascending.
    std::vector<double> positions;
    /// Of each frame used its position on the reference, 0 … reference frames − 1, ascending: samples are
    /// played back by it in the timing of the take.
    std::vector<double> playback;

    bool operator==(const TakeWarp&) const = default;
};

/// A take on the reference's frames, its poses laid onto the template frame.
struct AlignedTake
{
    std::string name;
    TakeWarp warp;
    std::vector<Vec3f> poses; ///< reference frames × vertices, metres, Procrustes-aligned to the template
    /// Of each reference frame the motion from the template's place to where it was captured.
    std::vector<RigidMotion> placements;
};

/// Displacement of a frame relative to the one before, in its frame: translation, metres, then exponential
/// map of the rotation, radians.
using Displacement = std::array<double, 6>;

/// Of each frame; the first equals the second.
std::vector<Displacement> displacementsOf(std::span<const RigidMotion> placements);
/// The placements that have these displacements, from a first one. Undoes displacementsOf.
std::vector<RigidMotion> integrated(std::span<const Displacement> displacements, const RigidMotion& first);

/// What a model of one part is learned from: the rows of all takes, one after the other.
struct PartTraining
{
    RowMatrix rows; ///< frames × coordinates, centred
    Eigen::RowVectorXd mean;
    std::vector<RowSpan> spans; ///< of the takes
    /// The last six coordinates are displacements times this; 0: the part has none.
    double displacementScale = 0;
};

/// The training rows of one part (ALGORITHMS section 8): three coordinates of each of its vertices in their
/// order, and the displacements for the root.
/// \param displacementShare  total variance of the displacements, in mean variances of a coordinate.
/// \pre All takes have as many frames.
PartTraining partTraining(std::span<const AlignedTake> takes, const BodyPart& part,
                          double displacementShare = 6);

} // namespace quadrille
