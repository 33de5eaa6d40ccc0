// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/stances.h"

namespace quadrille {

/// Lets feet take steps: where a blend carries a foot that stands throughout it farther than longestCarry, as
/// between two poses whose feet stand apart by different widths, it leaves the ground in the middle of the
/// blend for up to 0.4 seconds. Those that are carried farthest step, at most two and one after the other,
/// each while another foot stands; where a blend is too short for that, they do not.
/// \param standing  of stancesBeforeSteps, changed in blends alone.
void addSteps(std::vector<std::uint32_t>& standing, const Clip& clip, const Stances& stances);

} // namespace quadrille
