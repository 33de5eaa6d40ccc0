// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/blendtiming.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/transition/warppath.h"

#include <optional>
#include <vector>

namespace quadrille {

/// How the two windows of a transition are laid over each other.
enum class BlendAlignment
{
    EveryStep, ///< anew at every step, about the up axis and over the ground (SMCAS Alg. 1)
    MidWindow, ///< once, at the middle of the windows, for comparison (SMCAS Fig. 11–12)
    None,      ///< once, at the first frames' centres without a turn, for comparison
};

/// How the weight of the destination rises along a transition.
enum class BlendEasing
{
    Linear, ///< evenly, λ = t/(L−1) (SMCAS Alg. 1)
    Smooth, ///< 3λ² − 2λ³ of that: sets in and ends gently, so that vertices do not jerk there
};

/// How the poses of a transition are weighted and laid over the ground; the defaults are the paper's.
struct BlendSettings
{
    BlendAlignment alignment = BlendAlignment::EveryStep;
    BlendTiming timing = BlendTiming::Cells;
    BlendEasing easing = BlendEasing::Linear;
    std::optional<double> constantWeight; ///< λ of all steps, for comparison (SMCAS Fig. 11)
    bool operator==(const BlendSettings&) const = default;

    /// What shows least: no hitch of time, no jerk. Feet that stand are for the correction of contacts.
    static BlendSettings gentle() { return {.timing = BlendTiming::Smooth, .easing = BlendEasing::Smooth}; }
};

/// How a transition moves over the ground, in the coordinates in which its source sequence lies before it.
struct TransitionMotion
{
    /// One step for each cell of the path: a frame of the result.
    struct Step
    {
        BlendTimes times;              ///< of the poses that are blended
        double lambda = 0;             ///< weight of the destination, 0 … 1
        GroundMotion placeSource;      ///< of the source frame as captured
        GroundMotion placeDestination; ///< of the destination frame as captured
        Vec3d centre = Vec3d::Zero();  ///< mean of the vertices of the blended pose
    };
    std::vector<Step> steps;

    /// Places the destination sequence as captured so that it goes on from the last step.
    const GroundMotion& exit() const { return steps.back().placeDestination; }
};

/// Moves both windows of a transition along its path (SMCAS Alg. 1): the centre goes on
/// by both windows' displacements between consecutive cells, weighted by λ, and not at all where the warp
/// repeats a frame; the height is blended. A transition of one cell has λ = 0.
TransitionMotion transitionMotion(const RootPoses& roots, const Transition& transition,
                                  const BlendSettings& settings = {});

} // namespace quadrille
