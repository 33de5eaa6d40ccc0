// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/walks/findwalk.h"

#include <optional>

namespace quadrille {

/// The walk that junctions were decided on (Junctions::walk), changed where they say so and nowhere else.
/// Decisions take effect one after the other, what is banned first. A transition that is banned gives way to
/// others; one that is required takes the place of the nearest between its takes. Either may change the
/// transition before it or behind it along with it (see WalkExchanges). Of all that is possible the cheapest
/// walk is taken; all other transitions stay as they are. \return nothing where there is no such walk, where
/// none of these ways meets what is asked, or where the graph has changed since: then one is to be sought.
/// \throws Error as WalkGraph; Cancelled. Cost: O(ways · frames) for each decision that the walk does not
/// keep.
std::optional<WalkSolution> repairedWalk(const WalkMaterial& material, const WalkConstraints& constraints,
                                         const SearchSettings& settings, const Progress& progress = {});

} // namespace quadrille
