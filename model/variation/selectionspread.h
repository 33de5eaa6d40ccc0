// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/selection.h"
#include "model/variation/variationspread.h"

namespace quadrille {

/// How far the accepted variations of a set are apart beside the captured takes, on the frames of the
/// reference, by the parts of the body.
/// \param latents  the candidates that were selected from. \param poses  as they were made, but for the seed.
/// \param seed  of the set. \throws Error Cancelled.
std::vector<PartSpread> selectionSpread(const LearnedMovement& learned,
                                        const std::vector<LatentVariation>& latents,
                                        const VariationSelection& selection, VariationPoses poses,
                                        std::uint64_t seed, const Progress& progress = {});

} // namespace quadrille
