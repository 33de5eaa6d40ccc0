// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/graph/shortestpath.h"
#include "model/project/characterstages.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitiontable.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// What the stages that follow need to know of the frames.
void addLayout(Result& result, const PoseDistances& distances)
{
    std::vector<std::int64_t> lengths;
    lengths.reserve(static_cast<std::size_t>(distances.layout.sequenceCount()));
    for (int s = 0; s < distances.layout.sequenceCount(); ++s)
        lengths.push_back(distances.layout.countOf(s));
    result.arrays.push_back(columnOf("sequence-lengths", "frame", std::move(lengths)));
    result.arrays.back().description = "Frames of each sequence, in the order of the project.";
    result.arrays.push_back(
        columnOf("triangles", "", std::vector{distances.trianglesUsed, distances.trianglesLeftOut}));
    result.arrays.back().description = "Triangles used, and those left out because they have no area.";
}

ResultStage distanceStage(const CharacterWork& work, const std::string& name, PoseDistanceSettings settings)
{
    ResultStage stage = work.stage(name);
    stage.settings =
        work.settings + nlohmann::json({settings.metric == PoseMetric::Surface ? "surface" : "euclidean",
                                        settings.stretchWeight})
                            .dump();
    stage.files = [work](const Progress& progress) { return work.files(progress); };
    stage.compute = [work, name, settings](const StageContext&, const Progress& progress) {
        const bool isSurface = settings.metric == PoseMetric::Surface;
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        const PoseDistances distances = poseDistances(frames, settings, progress.part(0.05, 1));
        Result result;
        result.arrays = {
            matrixOf(name,
                     isSurface ? "Surface distance between the poses of all frames, rigid motion removed."
                               : "Mean distance of the vertices between all frames, rigid motion removed.",
                     isSurface ? "rad" : "m", distances.distances)};
        if (name == graphstage::poseDistance)
            addLayout(result, distances);
        return result;
    };
    return stage;
}

ResultStage transitionStage(const CharacterWork& work, const ResultStage& distances)
{
    const TransitionSettings settings = transitionSettings(work.graph, work.opener->project().settings.fps);
    ResultStage stage = work.stage(graphstage::transitions);
    stage.settings = nlohmann::json({settings.shortest(), settings.longest(), settings.slope,
                                     settings.cost == TransitionCost::Sum ? "sum" : "mean"})
                         .dump();
    stage.inputs = {distances.name};
    stage.compute = [settings, input = distances.name](const StageContext& context,
                                                       const Progress& progress) {
        const Result poses = context.resultOf(input);
        const TransitionTable table =
            transitionTable(tableOf<float>(poses.arrays.front()), layoutOf(poses), settings, progress);
        constexpr float none = TransitionTable::none;
        const auto frames = [&](const Table<std::uint16_t>& counts) -> Table<float> {
            return (counts == 0).select(none, counts.cast<float>());
        };
        const auto n = static_cast<std::size_t>(table.cost.size());
        const Table<float> source = frames(table.sourceWindow);
        const Table<float> destination = frames(table.destinationWindow);
        std::vector<float> windows(2 * n);
        for (std::size_t pair = 0; pair < n; ++pair) {
            windows[2 * pair] = source.data()[pair];
            windows[2 * pair + 1] = destination.data()[pair];
        }
        Result result;
        result.arrays = {matrixOf("transition-cost",
                                  "D, the cost of the best transition from a frame (row) to another.",
                                  poses.arrays.front().unit, table.cost),
                         matrixOf("transition-length", "L, the frames that this transition lasts.", "frame",
                                  frames(table.length)),
                         DataArray{.name = "transition-windows",
                                   .description = "Frames of its source and destination window.",
                                   .unit = "frame",
                                   .shape = {table.cost.rows(), table.cost.cols(), 2},
                                   .values = std::move(windows)}};
        return result;
    };
    return stage;
}

DataTable edgeTable(const char* name, const char* description, const Digraph& graph,
                    const TransitionCosts& costs)
{
    std::vector<std::int64_t> from;
    std::vector<std::int64_t> to;
    std::vector<double> weight;
    std::vector<std::string> kind;
    std::vector<double> cost;
    std::vector<std::int64_t> length;
    for (const Edge& edge : graph.edges()) {
        const bool isOriginal = edge.kind == EdgeKind::Original;
        from.push_back(edge.from);
        to.push_back(edge.to);
        weight.push_back(edge.weight);
        kind.emplace_back(isOriginal ? "original" : "transition");
        cost.push_back(isOriginal ? 0.0 : static_cast<double>(costs.cost()(edge.from, edge.to)));
        length.push_back(isOriginal ? 1 : costs.length()(edge.from, edge.to));
    }
    return {name,
            description,
            {columnOf("i", "", std::move(from)), columnOf("j", "", std::move(to)),
             columnOf("weight", "", std::move(weight)), columnOf("kind", "", std::move(kind)),
             columnOf("cost", "", std::move(cost)), columnOf("length", "frame", std::move(length))}};
}

/// Rows of statistics, column by column.
class StatisticsTable
{
public:
    void add(const std::string& graph, double alpha, const GraphStatistics& statistics)
    {
        m_graph.push_back(graph);
        m_alpha.push_back(alpha);
        m_nodes.push_back(statistics.nodes);
        m_edges.push_back(statistics.edges);
        m_transitions.push_back(statistics.transitions);
        m_density.push_back(statistics.density);
        m_mean.push_back(statistics.pathCosts.mean);
        m_deviation.push_back(statistics.pathCosts.standardDeviation);
        m_unreachable.push_back(statistics.pathCosts.unreachablePairs);
        m_components.push_back(static_cast<std::int64_t>(statistics.connectivity.components.size()));
    }
    DataTable table(std::string name, std::string description) &&
    {
        return {std::move(name),
                std::move(description),
                {columnOf("graph", "", std::move(m_graph)), columnOf("alpha", "", std::move(m_alpha)),
                 columnOf("nodes", "", std::move(m_nodes)), columnOf("edges", "", std::move(m_edges)),
                 columnOf("transitions", "", std::move(m_transitions)),
                 columnOf("density", "", std::move(m_density)), columnOf("mean-cost", "", std::move(m_mean)),
                 columnOf("cost-deviation", "", std::move(m_deviation)),
                 columnOf("unreachable-pairs", "", std::move(m_unreachable)),
                 columnOf("components", "", std::move(m_components))}};
    }

private:
    std::vector<std::string> m_graph;
    std::vector<double> m_alpha;
    std::vector<std::int64_t> m_nodes;
    std::vector<std::int64_t> m_edges;
    std::vector<std::int64_t> m_transitions;
    std::vector<double> m_density;
    std::vector<double> m_mean;
    std::vector<double> m_deviation;
    std::vector<std::int64_t> m_unreachable;
    std::vector<std::int64_t> m_components;
};

ResultStage graphStage(const CharacterWork& work, const ResultStage& distances,
                       const ResultStage& transitions)
{
    ResultStage stage = work.stage(graphstage::graphs);
    stage.settings = nlohmann::json({work.graph.alpha, work.graph.greatestDistance.value_or(0)}).dump();
    stage.inputs = {distances.name, transitions.name};
    stage.compute = [graph = work.graph, inputs = stage.inputs](const StageContext& context,
                                                                const Progress& progress) {
        const TransitionCosts costs =
            costsOf(graph, context.resultOf(inputs[0]), context.resultOf(inputs[1]));
        const auto minima = costMinima(costs, CostSmoothing::None, progress.part(0, 0.05));
        const Digraph motion = motionGraph(costs, minima, graph.alpha);
        const EssentialGraph essential = essentialGraph(costs, graph.alpha, progress.part(0.05, 0.6));
        StatisticsTable statistics;
        statistics.add("essential", graph.alpha, graphStatistics(essential.graph, essential.pathCosts));
        statistics.add("motion", graph.alpha,
                       graphStatistics(motion, shortestPathCosts(motion, progress.part(0.6, 1))));
        Result result;
        result.tables = {
            edgeTable("motion-graph-edges", "The motion graph: local minima of the transition cost.", motion,
                      costs),
            edgeTable("essential-graph-edges", "The Essential graph: all edges on shortest paths.",
                      essential.graph, costs),
            std::move(statistics).table("graph-statistics", "Both graphs at the project's alpha.")};
        return result;
    };
    return stage;
}

} // namespace

TransitionSettings transitionSettings(const GraphEntry& entry, double fps)
{
    TransitionSettings settings{.fps = fps, .slope = entry.slope, .cost = entry.cost};
    if (entry.durations) {
        constexpr double rounding = 1e-9;
        settings.shortestWindow =
            std::max(1, static_cast<int>(std::ceil(fps * entry.durations->first - rounding)));
        settings.longestWindow = static_cast<int>(std::floor(fps * entry.durations->second + rounding));
    }
    return settings;
}

std::vector<ResultStage> makeGraphStages(const StageMaking& making)
{
    std::vector<ResultStage> stages;
    for (const GraphEntry& graph : making.opener->project().graphs) {
        const CharacterWork work = characterWork(making.opener, graph);
        if (work.sequences.empty())
            continue;
        const ResultStage distances = distanceStage(work, graphstage::poseDistance, graph.pose);
        const ResultStage transitions = transitionStage(work, distances);
        stages.push_back(distances);
        stages.push_back(
            distanceStage(work, graphstage::euclideanDistance, {.metric = PoseMetric::Euclidean}));
        stages.push_back(transitions);
        stages.push_back(graphStage(work, distances, transitions));
    }
    return stages;
}

} // namespace quadrille
