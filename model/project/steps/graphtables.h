// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/statistics.h"
#include "model/project/steps/edgecosts.h"
#include "model/project/store/tablebuilder.h"

#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// A graph as other steps read it: both ends of each edge, its weight and kind.
DataTable graphTable(const char* name, const char* description, const Digraph& graph);

/// All edges of a graph: both ends as frames among all of the character's, the weight, what it is made of,
/// and both ends by sequence and frame. \param costs  of all edges. \param sequences  names, in the order of
/// the layout.
DataTable edgeTable(const char* name, const char* description, const Digraph& graph,
                    std::vector<EdgeCost> costs, const FrameLayout& layout,
                    const std::vector<std::string>& sequences);

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
