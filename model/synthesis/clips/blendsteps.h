// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/stances.h"

namespace quadrille {

/// Lets feet take steps: where a blend carries a foot farther than longestCarry while it stands, as between
/// two poses whose feet stand apart by different widths, it leaves the ground for up to 0.4 seconds in the
/// middle of the frames of the blend in which it stands. Those two that are carried farthest step, one after
/// the other, each while another foot stands; where there is no time for both, one; where there is none for
/// it, no foot.
/// \param standing  of stancesBeforeSteps, changed in blends alone.
void addSteps(std::vector<std::uint32_t>& standing, const Clip& clip, const Stances& stances);

} // namespace quadrille
