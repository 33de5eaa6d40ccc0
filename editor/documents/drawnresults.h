// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationwork.h"
#include "model/project/steps/variationresults.h"

namespace quadrille {

/// What was drawn of an entry's sets of samples, as the results beside a project hold it.
struct DrawnDraft
{
    std::vector<LatentVariations> latents;
    std::vector<VariationSelection> selections;
};

/// What a selection says of a set, without its variations. \param spreads  of all parts.
DrawnSet drawnSetOf(const VariationSelection& selection, const std::vector<SampleSpread>& spreads);

/// The variations as a rebuild or the editor kept them. \pre `opened` is learned.
/// \return null where they are not there, or outdated. \throws Error as ResultStore::load, Cancelled.
std::shared_ptr<const std::vector<DrawnSet>> readDrawn(const VariationJob& job, const OpenedVariation& opened,
                                                       const Progress& progress);

/// Puts variations where a rebuild would put what it draws; does nothing where their models are not there.
/// \throws Error as ResultStore::save, Cancelled.
void keepDrawn(const VariationJob& job, const OpenedVariation& opened, const LearnedMovement& learned,
               const DrawnDraft& draft, const Progress& progress);

} // namespace quadrille
