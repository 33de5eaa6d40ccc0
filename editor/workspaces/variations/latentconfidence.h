// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/variation/gpdm/gpdm.h"

#include <array>
#include <vector>

namespace quadrille {

/// How sure a model is of its poses, at places of its latent space.
struct LatentConfidence
{
    /// Decimal logarithm of a coordinate's variance, m², at each place of each trajectory.
    std::vector<std::vector<double>> alongPaths;
    /// Places of a coarse grid where it is surer than in the middle of its range; the first three dimensions.
    std::vector<std::array<double, 3>> places;
    std::vector<double> atPlaces;
    double least = 0; ///< of all
    double greatest = 1;
};

/// Cost: O((n + places) · N²) for n frames of paths, N latents of the state and at most 14³ places.
/// \param paths  trajectories, frames × dimensions of the model. \throws Error Cancelled.
LatentConfidence confidenceOf(const GpdmState& state, const std::vector<RowMatrix>& paths,
                              const Progress& progress = {});

} // namespace quadrille
