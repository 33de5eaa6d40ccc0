// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/motionspace.h"

namespace quadrille {

/// A pose of a space by the hybrid non-linear blend (IA4D eq. 3): the linear blend of the takes, and the
/// displacements of the nearest references. It is the piecewise linear blend of the references around the
/// place, as nodes are blends of takes themselves. Between frames poses go along cubics, displacements
/// straight.
/// \param phase  in frames: from 0 to frameCount() where the space is cyclic, else to frameCount() − 1.
/// \param out  of all vertices, metres. Allocates nothing. Safe from any thread.
/// Cost: O(vertices · takes that partake).
void blendedPose(const MotionSpace& space, double phase, const NodeWeights& weights, MutablePositions out);

/// How the blend goes on from a frame: shares of the takes' steps.
GroundMotion blendedStep(const MotionSpace& space, std::size_t frame, const NodeWeights& weights);
/// How long it is on the way from a frame to the next one, seconds.
double blendedSeconds(const MotionSpace& space, std::size_t frame, const NodeWeights& weights);

/// All of it at one place.
struct BlendedMovement
{
    std::vector<Vec3f> poses; ///< frames × vertices
    std::vector<GroundMotion> steps;
    std::vector<double> seconds;

    PerformedMovement performed(const MotionSpace& space) const;
};

BlendedMovement blendedMovement(const MotionSpace& space, const NodeWeights& weights);

} // namespace quadrille
