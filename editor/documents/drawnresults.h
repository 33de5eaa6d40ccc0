// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationwork.h"

namespace quadrille {

/// The steps whose results tell what was drawn of an entry. These are the samples of each part, the selection
/// among them, then the clip of each variation. \pre The project has the variation.
std::vector<std::string> drawnSteps(const VariationJob& job);

/// The variations as these steps made them. No frame of a clip is made yet. \throws Error ResultReplaced; as
/// ResultStore::load; Cancelled. \param opened  its takes give textures and contacts. \param results  have
/// all of drawnSteps().
std::shared_ptr<const std::vector<DrawnSet>> readDrawn(const VariationJob& job, const OpenedVariation& opened,
                                                       const FreshResults& results, const Progress& progress);

} // namespace quadrille
