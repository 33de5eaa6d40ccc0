// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"
#include "model/transfer/deformationfield.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// A triangle of a template and the one of a target that moves as it does.
struct TrianglePair
{
    TriangleIndex onTemplate;
    TriangleIndex onTarget;

    bool operator==(const TrianglePair&) const = default;
};

/// One pose of a mesh, metres.
struct PosedMesh
{
    std::shared_ptr<const Topology> topology;
    std::vector<Vec3f> positions;
};

struct TransferSettings
{
    FieldKind field = FieldKind::Quaternions;
    UpAxis up = UpAxis::Y;
    /// Limbs that the target holds in another way than the template's reference pose are brought there; else
    /// they keep the difference.
    bool correctsPose = true;
    /// How the template's skin stretches about the marks is carried as well; rotations only, as published,
    /// where not.
    bool carriesStretch = true;
    /// Marks turn as what lies about them on the template, and what lies about them on the target turns with
    /// them; single triangles, as published, where not.
    bool marksSurroundings = true;
    /// Of the template's way over the ground and of its height above it; what the target's steps and size ask
    /// for when empty.
    std::optional<double> scale;
};

/// A performance on another mesh, and how well it went.
struct Transferred
{
    std::vector<Vec3f> positions; ///< frames × vertices of the target, metres
    double scale = 1;             ///< that the way was made with
    double turn = 0;              ///< of the target about the up axis beforehand, radians
    std::vector<double> volume;   ///< of each frame, shares of the target's at rest; empty where it has none
    std::vector<double> markErrors; ///< of each frame: mean angle that marked triangles miss, radians
};

/// Of the corners of a triangle in a pose.
Vec3d middleOf(const Triangle& triangle, Positions pose);
/// Of unit length; zero where the triangle has no area.
Vec3d normalOf(const Triangle& triangle, Positions pose);

/// \throws Error TransferNoPairs, TransferTriangleOfTemplate and …OfTarget (there is no such triangle),
/// TransferTriangleTwice (one of the target in two pairs).
void checkPairs(const Topology& reference, const Topology& target, std::span<const TrianglePair> pairs);

/// The turn about the up axis that brings marked triangles of a target nearest to those of a template, their
/// middles at one place, radians.
double turnOntoTemplate(const PosedMesh& reference, const PosedMesh& target,
                        std::span<const TrianglePair> pairs, UpAxis up);

/// A pose turned about the up axis through the origin, radians.
std::vector<Vec3f> turned(Positions pose, double angle, UpAxis up);

/// How unlike a pose of a template is to a target's: the root of the mean squared distance of the middles of
/// marked triangles, turned about the up axis, scaled and shifted best; shares of the target's extent.
double poseDifference(const Topology& mesh, Positions pose, const PosedMesh& target,
                      std::span<const TrianglePair> pairs, UpAxis up);

/// Transfers a performance onto another mesh (SCANS §4): the target, turned as the template, takes in each
/// frame the rotations of the marked triangles since the reference pose, beyond the paper after those that
/// bring its limbs into that pose (posecorrection.h), with the skin's stretches (stretchtracker.h) and for
/// what lies about the marks (surroundings.h); its way is the template's, scaled, see placement.h. \param
/// clip  of the template's mesh, metres; its contacts say when feet stand. \param reference  a pose of the
/// template, at best one that the target's is like. \param target  in its own pose. \throws Error as
/// checkPairs and SolidTarget, TransferTriangleFlat (one of the target has no area), Cancelled, and what
/// reading frames throws. \return the same for any number of threads. Cost: see TransferSolver; frames in
/// parallel.
Transferred transferClip(const MeshSequence& clip, const PosedMesh& reference, const PosedMesh& target,
                         std::span<const TrianglePair> pairs, const TransferSettings& settings = {},
                         const Progress& progress = {});

} // namespace quadrille
