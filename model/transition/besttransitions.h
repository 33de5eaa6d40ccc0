// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/transitiontable.h"
#include "model/transition/warppath.h"

#include <vector>

namespace quadrille {

/// Which sequences to join, and how many ways to propose.
struct AlternativesRequest
{
    int sourceSequence = 0;
    int destinationSequence = 0;
    int count = 10;
    /// Two proposals differ by at least so many frames in the source or in the destination.
    int spacing = 9;
};

/// The best ways from one sequence into another: local minima of the cost over the 8 pairs around, apart from
/// each other, cheapest first (ties: earlier source, then earlier destination frame). Fewer than asked for
/// where there are not so many minima. Inside one sequence, transitions that go forward no faster than
/// playing on are left out. \throws Error BadArgument where there is no such sequence, or count or spacing is
/// negative.
std::vector<FramePair> bestTransitions(const TransitionTable& table, const FrameLayout& layout,
                                       const AlternativesRequest& request);

} // namespace quadrille
