// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/synthesis/clips/clip.h"
#include "model/variation/training.h"

#include <span>
#include <vector>

namespace quadrille {

/// A placement between two: rotations by slerp, translations linearly.
RigidMotion interpolated(const RigidMotion& a, const RigidMotion& b, double share);

/// Where up points, seen from a placement: its tilt, without its heading.
Vec3d upSeenFrom(const RigidMotion& place, const Vec3d& up);

/// A placement turned, the shortest way, so that up is seen from it where it is wanted.
/// \param share  of the way: 0 … 1.
RigidMotion leanedTo(const Vec3d& wantedUp, const RigidMotion& place, const Vec3d& up, double share = 1);

struct PathSettings
{
    UpAxis up = UpAxis::Y;
    double fps = 25; ///< of the reference frames
    /// Errors of single displacements add up: what height and tilt differ from those of the take is forgotten
    /// by half in this time, seconds; at once where it is 0. Way and heading on the ground are free.
    double driftHalfLife = 0.25;
};

/// The path on the ground that displacements lead along, from where the take began.
/// \param guide  placements of the take that is varied (of a blend: blendedPlacements). With its own
/// displacements it comes out as it is.
/// \pre As many displacements as placements.
std::vector<RigidMotion> pathOnGround(std::span<const Displacement> displacements,
                                      std::span<const RigidMotion> guide, const PathSettings& settings = {});

/// Poses of reference frames played in the timing of a take and put where they belong: one frame for each of
/// the take's (see FramesAround).
/// \param poses  reference frames × vertices, in the template's place, metres.
/// \param placements  of each reference frame.
/// \return frames of the warp × vertices, metres. Parallel over the frames. \throws Error Cancelled.
std::vector<Vec3f> played(std::span<const Vec3f> poses, std::span<const RigidMotion> placements,
                          const TakeWarp& warp, const Progress& progress = {});

/// Where the frames of a variation of a take come from: each from the captured frame at its time.
/// \param firstNode  of the take's sequence in its character.
std::vector<FrameProvenance> variationOrigins(const TakeWarp& warp, NodeIndex firstNode);

/// A captured take in a blend.
struct OriginTake
{
    WarpShare part;
    NodeIndex firstNode = 0; ///< of its sequence in its character
};

/// Where the frames of a variation of a blend come from: each from the captured frames of two takes at its
/// phase. Of more takes the two with the largest shares count, in their order.
/// \pre Some takes, their shares greater than 0.
std::vector<FrameProvenance> variationOrigins(std::span<const OriginTake> takes);

} // namespace quadrille
