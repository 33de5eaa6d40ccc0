// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
//
// What others read of the results of a graph's steps.
#pragma once

#include "model/graph/costoverview.h"
#include "model/graph/measuredgraphs.h"
#include "model/project/steps/charactersteps.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/transition/transitiontable.h"

#include <memory>
#include <string>

namespace quadrille {

/// One of both graphs, "essential-graph" or "motion-graph", from the result of the step of graphs.
Digraph storedGraph(const Result& graphs, const std::string& name, NodeIndex nodeCount);

/// The Essential graph at the project's α, as the step of graphs left it; shared by all who want it.
std::shared_ptr<const Digraph> storedEssentialGraph(const CharacterInputs& work, const StepContext& context,
                                                    NodeIndex nodeCount);

/// \param unit  of costs.
Result costOverviewResult(CostOverview overview, const std::string& unit);
CostOverview costOverviewOf(const Result& result);

/// \param unit  of lengths.
Result rootPosesResult(RootPoses roots, const std::string& unit);
/// Shares the turns with the result.
RootPoses rootPosesOf(const Result& result, UpAxis up);
/// Shares the tables with the result, of the step of transitions.
TransitionTable transitionTableOf(const Result& result);
/// What transitions were sought by is at most so much.
float greatestStepOf(const Result& transitions);

/// Both graphs at the project's α, and what is known of them, as the step of graphs left them. Shared with
/// those who want them by graphsAt. \throws Error Cancelled. Cost: O(frames² + edges).
std::shared_ptr<const MeasuredGraphs> storedGraphs(const CharacterInputs& work, const StepContext& context,
                                                   const Progress& progress = {});

} // namespace quadrille
