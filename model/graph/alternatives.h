// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/transitioncosts.h"
#include "model/transition/framepair.h"

namespace quadrille {

struct AlternativeSettings
{
    int reach = 12; ///< frames of the same sequence before and after a source that are considered as well
    /// Frames by which two alternatives to the same sequence differ in what they skip, at least: those that
    /// differ less are one transition, taken earlier or later.
    int apart = 4;
    int most = 10; ///< how many are wanted
};

/// Other transitions that could be taken instead of one: those of least weight (see TransitionCosts::weight)
/// that leave its sequence about where it does, each by itself and none like the one itself, without those
/// inside one sequence that are dearer than playing on.
/// \return the cheapest first (of two alike that of the earlier source, then destination).
/// Cost: O(reach · frames · log frames).
std::vector<FramePair> alternatives(const TransitionCosts& costs, double alpha, const FramePair& chosen,
                                    const AlternativeSettings& settings = {});

/// The transitions of least weight from one sequence to another (or to itself), each by itself: of those that
/// leave and arrive within `apart` frames of each other the cheapest. Without those inside one sequence that
/// are dearer than playing on.
/// \param settings  `reach` does not count. \return the cheapest first (of two alike that of the earlier
/// source, then destination). Cost: O(cells · log cells).
std::vector<FramePair> bestTransitions(const TransitionCosts& costs, double alpha, int from, int to,
                                       const AlternativeSettings& settings = {});

} // namespace quadrille
