// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphtablefiles.h"

#include "model/project/steps/graphtables.h"
#include "model/project/store/dataitem.h"

namespace quadrille {

namespace {

GraphStatistics statisticsOf(const Digraph& graph, const PathCostSummary& costs,
                             const Connectivity& connectivity)
{
    return {.nodes = graph.nodeCount(),
            .edges = static_cast<std::int64_t>(graph.edges().size()),
            .transitions = graph.count(EdgeKind::Transition),
            .density = graph.density(),
            .pathCosts = costs,
            .connectivity = connectivity};
}

} // namespace

std::vector<std::filesystem::path> writeGraphTables(const CharacterGraph& character,
                                                    const ExploredPaths& paths,
                                                    const std::vector<GraphComparison>& comparison,
                                                    const std::filesystem::path& folder, WriteGuard& guard,
                                                    const Progress& progress)
{
    const ExploredGraphs& graphs = *paths.graphs;
    const GraphStatistics essential =
        statisticsOf(graphs.essential, paths.essentialCosts, paths.essentialConnectivity);
    const GraphStatistics motion = statisticsOf(graphs.motion, paths.motionCosts, paths.motionConnectivity);
    std::vector<DataTable> tables;
    const EdgeNaming naming{character.costs(), [&](const FramePair& pair) { return character.partsOf(pair); },
                            character.work().sequences};
    tables.push_back(edgeTable("essential-graph-edges", "The Essential graph: all edges on shortest paths.",
                               graphs.essential, naming, progress.part(0, 0.8)));
    tables.push_back(edgeTable("motion-graph-edges", "The motion graph: local minima of the transition cost.",
                               graphs.motion, naming, progress.part(0.8, 0.9)));
    TableBuilder statistics = statisticsTable("graph-statistics", "Both graphs at the project's alpha.");
    addStatistics(statistics, "essential", graphs.alpha, essential);
    addStatistics(statistics, "motion", graphs.alpha, motion);
    tables.push_back(std::move(statistics).table());
    TableBuilder components = componentTable("graph-components");
    for (const auto& [name, connectivity] : {std::pair("essential", &paths.essentialConnectivity),
                                             std::pair("motion", &paths.motionConnectivity)})
        addComponents(components, name, graphs.alpha, *connectivity, character.layout(),
                      character.work().sequences);
    tables.push_back(std::move(components).table());
    if (!comparison.empty()) {
        TableBuilder sweep = statisticsTable("graph-comparison", "Both graphs over several alphas.");
        for (const GraphComparison& row : comparison) {
            addStatistics(sweep, "essential", row.alpha, row.essential);
            addStatistics(sweep, "motion", row.alpha, row.motion);
        }
        tables.push_back(std::move(sweep).table());
    }
    std::vector<std::filesystem::path> files;
    for (DataTable& table : tables) {
        files.push_back(folder / (table.name + ".csv"));
        DataItem item;
        item.name = table.name;
        item.content = std::move(table);
        writeData(item, files.back(), &guard);
    }
    return files;
}

} // namespace quadrille
