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

/// What the costs of all edges of a graph are made of; nothing of original ones.
/// \param partsOf  asked from several threads. \throws Error Cancelled. Cost: O(edges · l_max²).
std::vector<CostParts> partsOfEdges(const Digraph& graph,
                                    const std::function<CostParts(const FramePair&)>& partsOf,
                                    const Progress& progress = {});

/// What names and describes the edges of a graph.
struct EdgeNaming
{
    const TransitionCosts& costs;
    const std::vector<std::string>& sequences; ///< names, in the order of the layout
};

/// All edges of a graph: both ends as frames among all of the character's, the weight, what it is made of,
/// and both ends by sequence and frame. \param parts  of all edges.
DataTable edgeTable(const char* name, const char* description, const Digraph& graph,
                    std::span<const CostParts> parts, const EdgeNaming& naming);

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
