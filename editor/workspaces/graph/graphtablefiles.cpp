// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphtablefiles.h"

#include "model/project/steps/graphtables.h"
#include "model/project/store/dataitem.h"

namespace quadrille {

std::vector<std::filesystem::path> writeGraphTables(const CharacterGraph& character,
                                                    const MeasuredGraphs& measured,
                                                    const std::vector<GraphComparison>& comparison,
                                                    const std::filesystem::path& folder, WriteGuard& guard,
                                                    const Progress& progress)
{
    const GraphPair& graphs = *measured.graphs;
    std::vector<std::filesystem::path> files;
    // Each is written as soon as it is made: those of large graphs take much.
    const auto write = [&](DataTable table) {
        files.push_back(folder / (table.name + ".csv"));
        DataItem item;
        item.name = table.name;
        item.content = std::move(table);
        writeData(item, files.back(), &guard);
    };
    auto costs = character.edgeCosts({&graphs.essential, &graphs.motion}, progress.part(0, 0.9));
    const std::vector<std::string>& sequences = character.work().sequences;
    write(edgeTable("essential-graph-edges", "The Essential graph: all edges on shortest paths.",
                    graphs.essential, std::move(costs[0]), character.layout(), sequences));
    write(edgeTable("motion-graph-edges", "The motion graph: local minima of the transition cost.",
                    graphs.motion, std::move(costs[1]), character.layout(), sequences));
    TableBuilder statistics = statisticsTable("graph-statistics", "Both graphs at the project's alpha.");
    addStatistics(statistics, "essential", graphs.alpha, measured.essential);
    addStatistics(statistics, "motion", graphs.alpha, measured.motion);
    write(std::move(statistics).table());
    TableBuilder components = componentTable("graph-components");
    for (const auto& [name, graph] :
         {std::pair("essential", &measured.essential), std::pair("motion", &measured.motion)})
        addComponents(components, name, graphs.alpha, graph->connectivity, character.layout(), sequences);
    write(std::move(components).table());
    if (!comparison.empty()) {
        TableBuilder sweep = statisticsTable("graph-comparison", "Both graphs over several alphas.");
        for (const GraphComparison& row : comparison) {
            addStatistics(sweep, "essential", row.alpha, row.essential);
            addStatistics(sweep, "motion", row.alpha, row.motion);
        }
        write(std::move(sweep).table());
    }
    return files;
}

} // namespace quadrille
