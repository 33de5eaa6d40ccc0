// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationwork.h"

namespace quadrille {

/// The steps whose results tell what was drawn of an entry.
std::vector<std::string> drawnSteps(const VariationJob& job);

/// The variations as these steps made them. \throws Error ResultReplaced; as ResultStore::load; Cancelled.
std::shared_ptr<const std::vector<DrawnSet>> readDrawn(const VariationJob& job, const OpenedVariation& opened,
                                                       const FreshResults& results, const Progress& progress);

} // namespace quadrille
