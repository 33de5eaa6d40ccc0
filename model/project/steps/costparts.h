// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/transitioncosts.h"
#include "model/synthesis/stances.h"
#include "model/transition/warppath.h"

namespace quadrille {

/// The cost of a transition in parts, in the unit of the pose distances.
struct CostParts
{
    double pose = 0;     ///< distances between the poses that are blended
    double contacts = 0; ///< feet that stand in one of two blended frames only, or are dragged
    double velocity = 0; ///< body and feet that move otherwise

    double sum() const { return pose + contacts + velocity; }
};

/// What the costs of transitions are made of; from the same tables as they are themselves.
struct CostSplit
{
    const Table<float>& distances; ///< of poses
    const Table<float>& steps;     ///< what transitions were sought by
    const Stances& stances;
    double contactWeight = 0;
    const Table<float>& drifts; ///< of footDrifts; empty: the costs do not know them
    const WarpPaths& paths;     ///< of the steps
    const TransitionTable& transitions;
    const TransitionCosts& costs;

    /// Adds up to the cost of the transition; zeros where there is none. Safe from several threads.
    /// Cost: O(l_max²).
    CostParts of(const FramePair& pair) const;
};

} // namespace quadrille
