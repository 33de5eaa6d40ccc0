// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationbasis.h"
#include "editor/documents/variationresults.h"
#include "editor/documents/variationwork.h"

namespace quadrille {

/// A variation with what it was made of.
struct VariationResults::Item : State
{
    std::optional<VariationBasis> basis; ///< of `opened` and `learned`
    std::shared_ptr<const OpenedVariation> opened;
    std::shared_ptr<const LearnedVariation> learned; ///< null before learning
    std::shared_ptr<const LearnedVariation> stopped; ///< to go on with where there is nothing better
    std::optional<VariationDrawing> drawing;         ///< of `drawn`
    int wantedAt = 0;                                ///< the greater the later; −1: of another project

    /// The phase where there is no work on it.
    ResultPhase restingPhase() const { return learned == nullptr ? ResultPhase::Idle : ResultPhase::Ready; }
};

} // namespace quadrille
