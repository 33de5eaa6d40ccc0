// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/walks/walkgraph.h"

namespace quadrille {

/// A walk that shows keys, and when.
struct KeyWalk
{
    WalkRoute route;
    std::vector<std::int64_t> times; ///< output frame of each key
    double edges = 0;                ///< sum of the weights
    double timing = 0;               ///< β · sum of the timing errors
    bool optimal = false;            ///< of each pair, or over all keys
    double bound = 0;                ///< no walk that shows the keys costs less, over all of them
    std::int64_t expansions = 0;
};

/// Walks from key to key (SMCAS §4.3.2): each leg has the least cost of weights and timing error; the time
/// that the next one should take is shifted by the error that is left (dynamic programme over frame and time,
/// exact).
/// \param starts  where the walk may begin. \param keys  times ascend.
/// \param budget  where it, or two gigabytes, run out, the best of the walks with the bounds stands for a
/// leg. \throws Error WalkKeyUnreachable, WalkKeyUntimely, Cancelled.
KeyWalk walkFromKeyToKey(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                         const std::vector<PoseKey>& keys, double beta, std::int64_t budget,
                         const Progress& progress = {});

/// The walk of the least cost over all keys together. \throws as walkFromKeyToKey.
KeyWalk walkOverAllKeys(const WalkGraph& graph, const std::vector<NodeIndex>& starts,
                        const std::vector<PoseKey>& keys, double beta, std::int64_t budget,
                        const Progress& progress = {});

} // namespace quadrille
