// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/selection.h"

#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// How far the model of one part of the body is learned.
struct PartProgress
{
    std::string part;
    std::vector<double> objective;         ///< of each iteration that is known
    GpdmState state;                       ///< latents and kernels as far as they are
    std::vector<std::string> activeBounds; ///< hyperparameters that stayed at a bound
    std::optional<GpdmStop> stop;          ///< why learning ended; nothing while it goes on
    /// Mean distance of a vertex from the training poses, metres; and that of as many principal components.
    /// Nothing before it is known.
    std::optional<double> error;
    std::optional<double> pcaError;
};

/// A variation that was drawn.
struct DrawnVariation
{
    int number = 0;                 ///< of its clip, “variations/NAME/3”, from 1
    int inSet = 0;                  ///< among those of one SamplesEntry, from 1
    bool isDiscarded = false;       ///< by the user
    MeshSequence sequence;          ///< as it is played; without frames where it could not be drawn
    std::vector<RowMatrix> latents; ///< of each part, on the reference's frames
    VariationQuality quality;
};

/// What was drawn of one SamplesEntry.
struct DrawnSet
{
    std::vector<DrawnVariation> variations;
    int rejected = 0;                          ///< that were not good enough, and drawn again
    std::array<int, variationFaults> faults{}; ///< of these, how many had each of the faults
    /// How far they are apart as a share of how far takes of the same movement are, mean over the parts.
    double spread = 0;
    bool isSpreadGuess = false; ///< a take is alone of its movement
};

} // namespace quadrille
