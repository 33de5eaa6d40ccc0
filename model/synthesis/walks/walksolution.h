// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/ground.h"
#include "model/synthesis/walks/constraints.h"

namespace quadrille {

/// What a walk costs, in parts.
struct WalkCost
{
    double deviation = 0; ///< sum of the squared distances from the path over all output frames, m²
    double edges = 0;     ///< sum of edge weights, and the cost of each frame that actions left out
    double timing = 0;    ///< β · sum of the timing errors

    /// What is minimised: without a path, μ is 1.
    double total(double mu) const { return deviation + mu * edges + timing; }
    bool operator==(const WalkCost&) const = default;
};

/// A key, and when it is met.
struct KeyTime
{
    double wanted = 0;         ///< output frames from the start
    std::int64_t obtained = 0; ///< output frame
    bool operator==(const KeyTime&) const = default;
};

/// A walk that meets constraints.
struct WalkSolution
{
    Walk walk;
    GroundMotion start; ///< places the first frame of the walk as captured, in the coordinates of the roots
    WalkCost cost;
    double totalCost = 0;         ///< cost.total, with the μ that counted
    std::int64_t frameCount = 0;  ///< output frames
    std::vector<KeyTime> keys;    ///< as in the constraints
    double meanDeviation = 0;     ///< from the path over all output frames, metres
    double greatestDeviation = 0; ///< metres
    double pathLength = 0;        ///< metres of the path
    /// Output frames of each action, from its first captured frame to its last, and of each path span.
    std::vector<FrameRange> actions;
    std::vector<FrameRange> spans;
    /// From the first output frame that shows a key, an action or a path span to the last.
    FrameRange asked() const;
    std::int64_t expansions = 0; ///< until this walk was found; when a search ends, of the whole search
    /// It is proven that no walk of the graph costs less; or, with `eachLeg`, that no stretch from a key to
    /// the next does, begun where the one before it ends (as in the paper).
    bool optimal = false;
    bool eachLeg = false;
    /// It is proven that no walk of the graph that meets the constraints costs less; 0 where nothing is
    /// known.
    double bound = 0;

    bool operator==(const WalkSolution&) const = default;
};

} // namespace quadrille
