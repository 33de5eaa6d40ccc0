// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"
#include "model/core/table.h"
#include "model/transition/framelayout.h"
#include "model/transition/transitionsettings.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// How a transition joins its two sequences (SMCAS Fig. 5).
enum class TransitionKind
{
    Linear,         ///< windows of l_min frames that advance together
    Warped,         ///< dynamic time warping of these windows
    VaryingLengths, ///< dynamic time warping, windows of l_min … l_max frames
};

struct MeanAndDeviation
{
    double mean = 0;
    double deviation = 0; ///< standard deviation over all pairs
};

/// A row of the tables of SMCAS Fig. 7.
struct TransitionVariant
{
    TransitionKind kind = TransitionKind::Linear;
    int slope = 0; ///< 0 for linear transitions
    /// D over the largest D of a linear transition.
    MeanAndDeviation surface;
    /// Mean pose distance of the cells of the path, in the unit of the distances.
    MeanAndDeviation surfacePerFrame;
    /// Acceleration cost over the largest of a linear transition; zeros without accelerations.
    MeanAndDeviation acceleration;
    MeanAndDeviation length; ///< L, frames
};

/// Linear transitions, warped ones and those of varying lengths for every slope, over the pairs for which all
/// of them exist.
struct TransitionComparison
{
    std::int64_t pairs = 0;
    double largestLinearCost = 0;         ///< in the unit of the distances
    double largestLinearAcceleration = 0; ///< m/s²
    std::vector<TransitionVariant> variants;
};

/// Compares the kinds of transitions as SMCAS Fig. 7 does. Surface costs fall from
/// kind to kind by construction; accelerations do not. \param settings  their slope is not used. \param
/// accelerations  of accelerationDifferences; empty: they are not compared, which saves finding the paths of
/// all transitions. \throws Error as transitionTable. Cost: O(frames² · l_max²) for each of 4 slopes.
TransitionComparison compareTransitions(TableView<float> distances, const FrameLayout& layout,
                                        const TransitionSettings& settings, TableView<float> accelerations,
                                        const Progress& progress = {},
                                        const Executor& executor = localExecutor());

} // namespace quadrille
