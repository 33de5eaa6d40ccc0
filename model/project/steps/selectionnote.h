// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/variationentry.h"
#include "model/variation/selection.h"

#include <optional>
#include <string>

namespace quadrille {

/// What to tell about the candidates of a set of samples, in English sentences: how many were rejected and
/// why, and whether too few are left; nothing where all were good.
struct SelectionNote
{
    std::string text;
    bool isShort = false; ///< fewer variations than were asked for
};
std::optional<SelectionNote> noteOn(const SamplesEntry& samples, const VariationSelection& selection);

/// That takes of locomotion are used whole because no cycle was found in them, in one English sentence;
/// nothing where all have one, or none is looked for.
std::optional<std::string> noteOnCycles(const Movement& movement);

} // namespace quadrille
