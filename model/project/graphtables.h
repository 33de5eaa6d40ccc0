// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/statistics.h"
#include "model/graph/transitioncosts.h"
#include "model/project/tablebuilder.h"

#include <string>
#include <vector>

namespace quadrille {

DataTable edgeTable(const char* name, const char* description, const Digraph& graph,
                    const TransitionCosts& costs);

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
