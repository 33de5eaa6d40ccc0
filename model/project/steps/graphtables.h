// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/graph/statistics.h"
#include "model/graph/transitioncosts.h"
#include "model/project/steps/costparts.h"
#include "model/project/store/tablebuilder.h"

#include <functional>
#include <string>
#include <vector>

namespace quadrille {

/// A graph as other steps read it: both ends of each edge, its weight and kind.
DataTable graphTable(const char* name, const char* description, const Digraph& graph);

/// What names and describes the edges of a graph.
struct EdgeNaming
{
    const TransitionCosts& costs;
    std::function<CostParts(const FramePair&)> partsOf; ///< asked from several threads
    const std::vector<std::string>& sequences;          ///< names, in the order of the layout
};

/// All edges of a graph: both ends as frames among all of the character's, the weight, what it is made of,
/// and both ends by sequence and frame.
/// \throws Error Cancelled. Cost: O(edges · l_max²).
DataTable edgeTable(const char* name, const char* description, const Digraph& graph, const EdgeNaming& naming,
                    const Progress& progress = {});

/// A table for addStatistics.
TableBuilder statisticsTable(std::string name, std::string description);
void addStatistics(TableBuilder& table, const std::string& graph, double alpha,
                   const GraphStatistics& statistics);

/// What can be reached from where, by name: frames in a row that are alike share a row. For addComponents.
TableBuilder componentTable(std::string name);
/// \param sequences  names, in the order of the layout.
void addComponents(TableBuilder& table, const std::string& graph, double alpha,
                   const Connectivity& connectivity, const FrameLayout& layout,
                   const std::vector<std::string>& sequences);

} // namespace quadrille
