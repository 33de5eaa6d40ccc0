// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/latentblend.h"
#include "model/variation/parts/bodyparts.h"
#include "model/variation/sampling.h"
#include "model/variation/training.h"

#include <span>
#include <vector>

namespace quadrille {

/// How far blends of one part that were interpolated in latent space are from the true, non-linear blend of
/// the same weights (CVS Fig. 7b): mean vertex distance of each reference frame, metres.
struct BlendErrors
{
    std::vector<double> fromTakes;  ///< interpolated between the captured takes
    std::vector<double> fromNearby; ///< interpolated between the learned trajectories around the weights

    double meanFromTakes() const;
    double meanFromNearby() const;
};

/// \param takes, nearby  learned trajectories of one model: of the captured takes, and those around the
/// weights. \param truth  blendedTake of the takes with these shares.
BlendErrors blendErrors(const PoseReconstruction& reconstruction, std::span<const LatentShare> takes,
                        std::span<const LatentShare> nearby, const AlignedTake& truth, const BodyPart& part);

} // namespace quadrille
