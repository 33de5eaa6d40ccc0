// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/bodyparts.h"
#include "model/variation/sampling.h"
#include "model/variation/training.h"

#include <span>
#include <vector>

namespace quadrille {

/// A learned trajectory of a take, or of a blend of two takes that was learned with them.
struct LearnedBlend
{
    double weight = 0; ///< of the second take: 0 and 1 are the takes themselves
    RowMatrix latents; ///< reference frames × dimensions
};

/// How far blends of one part that were interpolated in latent space are from the true, non-linear blend of
/// the same weight (CVS Fig. 7b): mean vertex distance of each reference frame, metres.
struct BlendErrors
{
    std::vector<double> fromTakes;  ///< interpolated between the two takes
    std::vector<double> fromNearby; ///< interpolated between the learned trajectories next to the weight

    double meanFromTakes() const;
    double meanFromNearby() const;
};

/// \param learned  ascending by weight, the first 0 and the last 1, of one model.
/// \param truth  blendedTake of the two takes with this weight.
/// \throws Error BadArgument (weight outside 0 … 1, learned trajectories that do not reach from 0 to 1).
BlendErrors blendErrors(const PoseReconstruction& reconstruction, std::span<const LearnedBlend> learned,
                        double weight, const AlignedTake& truth, const BodyPart& part);

} // namespace quadrille
