// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/essentialgraph.h"
#include "model/graph/motiongraph.h"
#include "model/graph/statistics.h"

#include <array>

namespace quadrille {

/// How the graphs of a character are made.
struct GraphSettings
{
    double alpha = usualAlpha; ///< weight of a frame of duration against deformation, ≥ 0 (SMCAS §4.1.2)
    CostSmoothing smoothing = CostSmoothing::None; ///< of the motion graph
};

/// The values of α in SMCAS Fig. 9.
inline constexpr std::array<double, 6> figure9Alphas{0.01, 0.02, 0.03, 0.05, 0.1, 0.2};

/// One row of SMCAS Fig. 9, and what it cannot show: the same at equal density.
struct GraphComparison
{
    double alpha = 0;
    GraphStatistics essential;
    GraphStatistics motion;
    /// Both with as many edges as the one that has fewer: the other lost its heaviest transitions
    /// (`thinned`), and often the way to many frames with them.
    GraphStatistics essentialAtEqualDensity;
    GraphStatistics motionAtEqualDensity;
    /// Pairs of different frames with a path in both graphs at equal density, and the mean costs over these
    /// alone; 0 where there are none.
    std::int64_t commonPairs = 0;
    double essentialMeanOverCommonPairs = 0;
    double motionMeanOverCommonPairs = 0;
};

/// \param minima  the transitions of the motion graph, see costMinima.
/// \throws Error BadArgument (α), Cancelled.
GraphComparison compareGraphs(const TransitionCosts& costs, std::span<const FramePair> minima, double alpha,
                              const Progress& progress = {});

/// One comparison for each α, in their order.
/// \throws Error as compareGraphs.
std::vector<GraphComparison> sweepAlpha(const TransitionCosts& costs, std::span<const FramePair> minima,
                                        std::span<const double> alphas = figure9Alphas,
                                        const Progress& progress = {});

} // namespace quadrille
