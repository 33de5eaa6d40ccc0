// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/stances.h"
#include "model/transition/warppath.h"

#include <functional>

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
    /// What two frames differ in.
    using StepOf = std::function<float(NodeIndex, NodeIndex)>;

    TableView<float> distances; ///< of poses
    /// What transitions were sought by. \pre Safe from several threads.
    const StepOf& step;
    const Stances& stances;
    double contactWeight = 0;

    /// Adds up to the cost of the transition. Safe from several threads. \param transition  with its path.
    /// \param drift  of footDrifts; 0 where costs do not know it. \param cost  as TransitionCosts has it.
    /// Cost: O(l_max).
    CostParts of(const Transition& transition, float drift, float cost) const;
};

} // namespace quadrille
