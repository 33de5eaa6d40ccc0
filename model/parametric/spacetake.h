// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/meshsequence.h"
#include "model/synthesis/clips/ground.h"
#include "model/variation/training.h"

#include <vector>

namespace quadrille {

/// A take on the frames of its space. A pose stands over the origin of the ground, with its own height and
/// tilt, and looks where the template does; steps say how it goes on from there.
struct SpaceTake
{
    std::string name;
    TakeWarp warp;
    std::vector<Vec3f> poses;        ///< frames × vertices, metres
    std::vector<GroundMotion> steps; ///< of each frame the motion to the next one, seen from the frame
    std::vector<double> seconds;     ///< from each frame to the next one

    Positions pose(std::size_t frame) const
    {
        const std::size_t vertices = poses.size() / steps.size();
        return Positions(poses).subspan(frame * vertices, vertices);
    }
};

/// How a take becomes one of a space.
struct SpaceTakeOptions
{
    UpAxis up = UpAxis::Y;
    bool isCyclic = false;
    double speed = 1; ///< in which it is played
};

/// Takes the ways over the ground out of an aligned take. Where the space is cyclic, what the frame after the
/// cycle differs from its first one by is taken out by cubics, in place over the whole cycle and in speed
/// over an eighth of it on either side: the movement goes through the seam without a jump or a kink. Where
/// the capture ends with the cycle, the frame after it is guessed by going on as before.
/// \param sequence  the whole take. \param aligned  that the warp is taken of.
/// \throws Error what reading frames throws, Cancelled.
SpaceTake makeSpaceTake(const MeshSequence& sequence, const AlignedTake& aligned,
                        const SpaceTakeOptions& options, const Progress& progress = {});

} // namespace quadrille
