// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/procrustes.h"
#include "model/variation/gpdm/coefficients.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/parts/bodyparts.h"
#include "model/variation/timewarp.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// What frames are laid onto by Procrustes.
struct AlignmentTemplate
{
    std::vector<Vec3f> pose;         ///< the centroid of its anchor is the origin, metres
    std::vector<VertexIndex> anchor; ///< vertices that decide; all when empty

    /// The motion that brings a pose onto the template. \pre It has as many vertices.
    RigidMotion onto(Positions other) const;
};

/// A take on the reference's frames, its poses laid onto the template frame.
struct AlignedTake
{
    std::string name;
    TakeWarp warp;
    /// Reference frames × vertices, metres, Procrustes-aligned to the template.
    std::vector<Vec3f> poses;
    /// Of each reference frame the motion from the template's place to where it was captured.
    std::vector<RigidMotion> placements;
    /// Of each kind (MovementSettings::coefficients) reference frames × values; may be empty.
    std::vector<RowMatrix> coefficients;
    /// Labels that most of its frames have, sorted.
    std::vector<std::string> labels;
    /// That the poses lie on; blends of two such takes are laid onto it, too. Null where poses lie anywhere.
    std::shared_ptr<const AlignmentTemplate> laidOnto;

    /// Pose of a reference frame. \pre frame < placements.size().
    Positions pose(std::size_t frame) const;
    /// Poses of all reference frames, views of `poses`.
    std::vector<Positions> allPoses() const;
};

/// Displacement of a frame relative to the one before, in its frame: translation, metres, then exponential
/// map of the rotation, radians.
using Displacement = std::array<double, 6>;

/// Of each frame; the first equals the second. \pre At least two placements.
std::vector<Displacement> displacementsOf(std::span<const RigidMotion> placements);
/// The placement one displacement further.
RigidMotion moved(const RigidMotion& place, const Displacement& displacement);
/// The placements that have these displacements, from a first one. Undoes displacementsOf.
std::vector<RigidMotion> integrated(std::span<const Displacement> displacements, const RigidMotion& first);

/// What a model of one part is learned from: the rows of all takes, one after the other.
struct PartTraining
{
    RowMatrix rows; ///< frames × coordinates, centred
    Eigen::RowVectorXd mean;
    std::vector<RowSpan> spans; ///< of the takes
    /// What follows the coordinates of the vertices: of the root its displacements, then all coefficients; of
    /// other parts nothing.
    std::vector<BlockColumns> blocks;
};

/// Name of the block of displacements.
inline constexpr auto displacementBlock = "displacements";

/// The training rows of one part: three coordinates of each of its vertices in their
/// order, and the blocks of values for the root. A block that does not vary, or beside vertices that do not
/// move, has the scale 1. Displacements are those of a frame of the take, not of the reference: a variation
/// that is played quickly where others are slow would else go as much too far.
/// \param displacementShare  total variance of the displacements, in mean variances of a coordinate.
/// \param kinds  of the takes' coefficients.
/// \pre All takes have as many frames, at least two, and as many coefficients of each kind.
/// \throws Error BadArgument (no takes, a share that is not positive).
PartTraining partTraining(std::span<const AlignedTake> takes, const BodyPart& part,
                          double displacementShare = 6, std::span<const CoefficientKind> kinds = {});

/// The vertices that a pose vector (mean added) means, in BodyPart::vertices' order, metres.
/// \pre The vector has three coordinates of each.
void partPose(std::span<const double> poseVector, MutablePositions out);
/// The displacement from one reference frame to the next of each pose vector of the root (mean added).
/// \param warp  of the take that is varied, or of the blend. \pre The training is of the root.
std::vector<Displacement> partDisplacements(const Eigen::Ref<const RowMatrix>& poseVectors,
                                            const PartTraining& training, const TakeWarp& warp);

} // namespace quadrille
