// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/projectresults.h"
#include "model/project/store/dataitem.h"

#include <cstddef>
#include <vector>

namespace quadrille {

/// What the results of a project hold of one of its evaluations.
struct OpenedEvaluation
{
    enum class State
    {
        Impossible, ///< nothing can be computed: there are no takes, or no variations, that it could be about
        Stale,      ///< not computed yet, or of other inputs
        Fresh
    };
    State state = State::Impossible;
    std::vector<DataItem> tables; ///< where it is fresh; of several characters one after the other
};

/// Looks for the results of all evaluations of a project, in their order; computes nothing.
/// \throws Error Cancelled, of opening sequences.
std::vector<OpenedEvaluation> openEvaluations(const WorkingProject& working, const Progress& progress = {});

/// Brings the results of one evaluation up to date first, with all that it needs.
/// \param index  into Project::evaluations.
/// \throws Error of the step that failed, of opening sequences, Cancelled.
OpenedEvaluation computeEvaluation(const WorkingProject& working, std::size_t index,
                                   const Progress& progress = {});

} // namespace quadrille
