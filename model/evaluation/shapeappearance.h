// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/alignment.h"
#include "model/appearance/decode.h"
#include "model/appearance/poseappearance.h"
#include "model/appearance/texturequality.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// How far textures are from those that were captured.
struct ShapeErrors
{
    double textures = 0;    ///< root mean square of R, G and B by coefficients of Eigen textures, grey levels
    double warps = 0;       ///< the same of nodes by coefficients of Eigen warps, texels
    PictureQuality picture; ///< mean over the frames of which textures are compared
};

/// What is found for the poses of a take from those of the others.
struct LeftOutTake
{
    std::int64_t frames = 0;
    PoseScales scales;   ///< found among the others
    ShapeErrors nearest; ///< the texture of the captured frame with the nearest pose
    ShapeErrors mean;    ///< the mean of all coefficients, whatever the pose
    ShapeErrors learned; ///< coefficients regressed on poses
};

/// Poses, and what they show.
struct ShapeSubject
{
    PosePlaces places;
    std::vector<std::int64_t> takes;    ///< of each pose, from 0 on, in ascending order
    std::vector<std::int64_t> textures; ///< of each pose, rows of the model
    TextureSource source;
    std::int64_t pictures = 10; ///< of how many frames of each take, evenly spread, textures are compared
};

/// Leaves out one take after the other. The model itself is of all of them: what is judged is how its
/// coefficients are found, not the model. \pre There are two takes at least.
/// \throws Error Cancelled, and what reading textures throws.
std::vector<LeftOutTake> leftOutTakes(const ShapeSubject& subject, const AppearanceDecoder& decoder,
                                      const Progress& progress = {},
                                      const Executor& executor = localExecutor());

} // namespace quadrille
