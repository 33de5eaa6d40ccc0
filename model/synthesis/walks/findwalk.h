// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/transitioncosts.h"
#include "model/synthesis/walks/movemotions.h"
#include "model/synthesis/walks/searchsettings.h"
#include "model/synthesis/walks/walksolution.h"

#include <functional>

namespace quadrille {

/// What walks are made from; refers to what it names.
struct WalkMaterial
{
    const Digraph& graph;         ///< the Essential graph, or another of the same frames
    const TransitionCosts& costs; ///< for how long transitions last
    double alpha = usualAlpha;    ///< that of the graph
    WalkMotion motion;            ///< needed where there is a path
    /// Which frames are locomotion, for SearchSettings::prefersLocomotion; empty: nobody knows.
    std::vector<bool> locomotion = {};
    /// In which frames the figure is in the air, for SearchSettings::flightWeight; walks along a path neither
    /// begin nor end there, unless a start is given; walks of keys alone do not begin there, unless the first
    /// key lies there; empty: nobody knows.
    std::vector<bool> inAir = {};
    /// How fast the body gets on around each frame, body heights a second, for SearchSettings::paceWeight;
    /// empty: nobody knows.
    std::vector<double> paces = {};
};

/// Receives each walk that is better than those before it, on the thread that searches.
using SolutionCallback = std::function<void(const WalkSolution&)>;

/// Seeks the walk of least cost that meets all constraints (SMCAS §4.3).
/// Keys alone: exact, from key to key or over all of them; where that leaves takes too soon
/// (SearchSettings::leastRun), as without a path. Without a path: exact where the budget is enough. With a
/// path: as good as the budget lets it. The same budget gives the same walk, whatever the machine.
/// \throws Error Walk…, BadArgument (values that no constraint can have), Cancelled: see checkConstraints.
WalkSolution findWalk(const WalkMaterial& material, const WalkConstraints& constraints,
                      const SearchSettings& settings, const Progress& progress = {},
                      const SolutionCallback& found = {});

/// Whether constraints make sense for a character, before any search.
/// \throws Error BadArgument (NaN, a negative number, a frame that does not exist, no constraint at all, …),
/// WalkKeyOrder, WalkFramesMissing, WalkPathShort, WalkSpanOutside, WalkObstacleAtStart.
void checkConstraints(const WalkConstraints& constraints, const SearchSettings& settings,
                      const FrameLayout& layout, UpAxis up);

} // namespace quadrille
