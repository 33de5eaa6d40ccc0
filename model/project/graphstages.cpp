// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/graph/shortestpath.h"
#include "model/project/charactergraph.h"
#include "model/project/graphtables.h"
#include "model/project/lengthunit.h"
#include "model/project/sequencesettings.h"
#include "model/synthesis/footdrift.h"
#include "model/synthesis/liveliness.h"
#include "model/synthesis/stepcosts.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitiontable.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

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

/// Of so many tables of all pairs of frames.
auto bytesOfTables(const CharacterWork& work, double tables)
{
    return [work, tables](const Progress& progress) {
        const double frames = work.open(progress).frameCount();
        return static_cast<std::uint64_t>(tables * frames * frames * static_cast<double>(sizeof(float)));
    };
}

ResultStage distanceStage(const CharacterWork& work, const std::string& name, PoseDistanceSettings settings)
{
    const bool isSurface = settings.metric == PoseMetric::Surface;
    ResultStage stage = work.stage(name);
    stage.version = isSurface ? 1 : 2;
    stage.settings =
        work.settings + nlohmann::json({isSurface ? "surface" : "euclidean", settings.stretchWeight}).dump();
    stage.files = [work](const Progress& progress) { return work.files(progress); };
    stage.inputs = clipInputs(work.opener->project(), work.sequences);
    if (stage.inputs.empty()) // else frames are not known before
        stage.bytes = bytesOfTables(work, 1);
    const auto metres = static_cast<float>(work.opener->project().settings.axes.metresPerUnit);
    stage.compute = [=](const StageContext&, const Progress& progress) {
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        PoseDistances distances = poseDistances(frames, settings, progress.part(0.05, 1));
        if (!isSurface)
            distances.distances *= metres;
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
    const StepWeights weights = work.graph.steps;
    const double fps = settings.fps;
    const UpAxis up = work.opener->project().settings.axes.up;
    stage.settings = nlohmann::json({settings.shortest(), settings.longest(), settings.shortensInShortTakes,
                                     settings.slope, weights.contacts, weights.velocity, fps,
                                     settings.cost == TransitionCost::Sum ? "sum" : "mean",
                                     settings.length == TransitionLength::Path ? "path" : "windows"})
                         .dump();
    stage.inputs = {distances.name};
    if (!weights.isNothing())
        stage.inputs.push_back(work.stageName(graphstage::rootPoses));
    if (distances.bytes)
        stage.bytes = bytesOfTables(work, 4);
    stage.compute = [=, inputs = stage.inputs](const StageContext& context, const Progress& progress) {
        const Result poses = context.resultOf(inputs.front());
        Table<float> steps = tableOf<float>(poses.arrays.front());
        if (!weights.isNothing())
            steps = weightedSteps(
                steps, stepCosts(rootPosesOf(context.resultOf(inputs[1]), up), layoutOf(poses), fps),
                weights);
        const TransitionTable table = transitionTable(steps, layoutOf(poses), settings, progress);
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

/// What costs know of feet beside the frames that are blended.
ResultStage driftStage(const CharacterWork& work)
{
    ResultStage stage = work.stage(graphstage::drifts);
    stage.version = 2;
    const double fps = work.opener->project().settings.fps;
    const UpAxis up = work.opener->project().settings.axes.up;
    stage.settings = nlohmann::json({fps}).dump();
    stage.inputs = {work.stageName(graphstage::poseDistance), work.stageName(graphstage::rootPoses),
                    work.stageName(graphstage::transitions)};
    stage.compute = [=, inputs = stage.inputs](const StageContext& context, const Progress& progress) {
        const FrameLayout layout = layoutOf(context.resultOf(inputs[0]));
        const RootPoses roots = rootPosesOf(context.resultOf(inputs[1]), up);
        Result result;
        result.arrays = {matrixOf(
            "transition-drift",
            "How far the blend of the best transition from a frame (row) to another drags a foot "
            "that stands.",
            "body heights",
            footDrifts(roots, layout, transitionTableOf(context.resultOf(inputs[2])), fps, progress))};
        return result;
    };
    return stage;
}

/// The parts of costs, from the results that the graphs are made of.
class TransitionParts
{
public:
    TransitionParts(const CharacterWork& work, const TransitionCosts& costs, const StageContext& context)
        : m_costs(costs), m_contactWeight(work.graph.steps.contacts)
    {
        const ProjectSettings& settings = work.opener->project().settings;
        const auto resultOf = [&](const char* stage) { return context.resultOf(work.stageName(stage)); };
        m_distances = tableOf<float>(resultOf(graphstage::poseDistance).arrays.front());
        m_transitions = transitionTableOf(resultOf(graphstage::transitions));
        const RootPoses roots = rootPosesOf(resultOf(graphstage::rootPoses), settings.axes.up);
        m_steps =
            weightedSteps(m_distances, stepCosts(roots, costs.layout(), settings.fps), work.graph.steps);
        m_stances = roots.stances;
        if (knowsDrifts(work.graph))
            m_drifts = tableOf<float>(resultOf(graphstage::drifts).arrays.front());
        m_paths.emplace(m_steps, costs.layout(), transitionSettings(work.graph, settings.fps));
    }

    CostParts of(const FramePair& pair) const
    {
        const CostSplit split{.distances = m_distances,
                              .steps = m_steps,
                              .stances = m_stances,
                              .contactWeight = m_contactWeight,
                              .drifts = m_drifts,
                              .paths = *m_paths,
                              .transitions = m_transitions,
                              .costs = m_costs};
        return split.of(pair);
    }

private:
    const TransitionCosts& m_costs;
    double m_contactWeight;
    Table<float> m_distances;
    Table<float> m_steps;
    Table<float> m_drifts;
    Stances m_stances;
    TransitionTable m_transitions;
    std::optional<WarpPaths> m_paths;
};

ResultStage graphStage(const CharacterWork& work)
{
    ResultStage stage = work.stage(graphstage::graphs);
    stage.version = 3;
    stage.settings = nlohmann::json({work.graph.alpha, costSettings(work.graph), work.sequences,
                                     static_cast<int>(work.graph.smoothing)})
                         .dump();
    stage.inputs = costInputs(work);
    stage.compute = [work, graph = work.graph, sequences = work.sequences](const StageContext& context,
                                                                           const Progress& progress) {
        const TransitionCosts costs = costsOf(work, context);
        const auto minima = costMinima(costs, graph.smoothing, progress.part(0, 0.05));
        const Digraph motion = motionGraph(costs, minima, graph.alpha);
        const EssentialGraph essential = essentialGraph(costs, graph.alpha, progress.part(0.05, 0.6));
        const GraphStatistics ofEssential = graphStatistics(essential.graph, essential.pathCosts);
        const GraphStatistics ofMotion =
            graphStatistics(motion, shortestPathCosts(motion, progress.part(0.6, 1)));
        TableBuilder statistics = statisticsTable("graph-statistics", "Both graphs at the project's alpha.");
        addStatistics(statistics, "essential", graph.alpha, ofEssential);
        addStatistics(statistics, "motion", graph.alpha, ofMotion);
        TableBuilder components = componentTable("graph-components");
        addComponents(components, "essential", graph.alpha, ofEssential.connectivity, costs.layout(),
                      sequences);
        addComponents(components, "motion", graph.alpha, ofMotion.connectivity, costs.layout(), sequences);
        Result result;
        result.tables = {
            graphTable("motion-graph", "The motion graph; motion-graph-edges tells more.", motion),
            graphTable("essential-graph", "The Essential graph; essential-graph-edges tells more.",
                       essential.graph),
            std::move(statistics).table(), std::move(components).table()};
        return result;
    };
    return stage;
}

/// A stage of its own: the parts of many costs take longer than the graphs, which others wait for.
ResultStage edgeStage(const CharacterWork& work)
{
    ResultStage stage = work.stage(graphstage::edges);
    stage.inputs = costInputs(work);
    stage.inputs.push_back(work.stageName(graphstage::rootPoses));
    stage.inputs.push_back(work.stageName(graphstage::graphs));
    stage.settings = costSettings(work.graph).dump();
    stage.compute = [work, graphs = stage.inputs.back()](const StageContext& context,
                                                         const Progress& progress) {
        const TransitionCosts costs = costsOf(work, context);
        const TransitionParts parts(work, costs, context);
        const EdgeNaming naming{costs, [&](const FramePair& pair) { return parts.of(pair); }, work.sequences};
        const Result both = context.resultOf(graphs);
        const NodeIndex frames = costs.layout().frameCount();
        Result result;
        result.tables = {
            edgeTable("motion-graph-edges", "The motion graph: local minima of the transition cost.",
                      storedGraph(both, "motion-graph", frames), naming, progress.part(0, 0.1)),
            edgeTable("essential-graph-edges", "The Essential graph: all edges on shortest paths.",
                      storedGraph(both, "essential-graph", frames), naming, progress.part(0.1, 1))};
        return result;
    };
    return stage;
}

/// What costs are scaled by on demand.
ResultStage livelinessStage(const CharacterWork& work)
{
    ResultStage stage = work.stage(graphstage::liveliness);
    stage.settings = work.settings;
    stage.files = [work](const Progress& progress) { return work.files(progress); };
    stage.inputs = clipInputs(work.opener->project(), work.sequences);
    stage.compute = [work, up = work.opener->project().settings.axes.up](const StageContext&,
                                                                         const Progress& progress) {
        const CharacterFrames frames = work.open(progress.part(0, 0.2));
        const Table<double> liveliness =
            livelinessOf(frameMeasures(frames, {}, up, progress.part(0.2, 1)), frames.layout());
        Result result;
        result.arrays = {matrixOf("liveliness",
                                  "How fast vertices speed up and slow down in each pair of sequences, 95th "
                                  "percentile of the frames.",
                                  unitText(work.opener->project().settings.axes.metresPerUnit) + "/s²",
                                  Table<float>(liveliness.cast<float>()))};
        return result;
    };
    return stage;
}

/// Where the frames stand and how they are turned, for walks.
ResultStage rootPosesStage(const CharacterWork& work)
{
    const UpAxis up = work.opener->project().settings.axes.up;
    ResultStage stage = work.stage(graphstage::rootPoses);
    stage.version = 5;
    stage.settings = work.settings;
    for (const std::string& name : work.sequences)
        stage.settings += contactSettings(*findSequence(work.opener->project(), name));
    stage.files = [work](const Progress& progress) { return work.files(progress); };
    stage.inputs = clipInputs(work.opener->project(), work.sequences);
    stage.compute = [work, up](const StageContext&, const Progress& progress) {
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        RootPoses roots = rootPoses(frames, up, progress.part(0.05, 0.8));
        roots.supports = findSupports(frames, up, progress.part(0.8, 0.9));
        constexpr std::size_t enough = 48; // vertices that stand
        thinSupports(roots.supports, enough);
        roots.stances = findStances(frames, up, progress.part(0.9, 1));
        return rootPosesResult(roots, unitText(work.opener->project().settings.axes.metresPerUnit));
    };
    return stage;
}

} // namespace

GraphEntry GraphEntry::paper()
{
    GraphEntry entry;
    entry.cost = TransitionCost::Sum;
    entry.costScale = CostScale::None;
    entry.length = TransitionLength::Path;
    entry.steps = {};
    entry.durations = {1.0 / 3, 2.0};
    return entry;
}

TransitionSettings transitionSettings(const GraphEntry& entry, double fps)
{
    TransitionSettings settings{.fps = fps, .slope = entry.slope, .cost = entry.cost, .length = entry.length};
    constexpr double rounding = 1e-9;
    const auto [shortest, longest] = entry.durations.value_or(usualDurations);
    settings.shortestWindow = std::max(1, static_cast<int>(std::ceil(fps * shortest - rounding)));
    settings.longestWindow =
        std::max(settings.shortest(), static_cast<int>(std::floor(fps * longest + rounding)));
    settings.shortensInShortTakes = !entry.durations;
    return settings;
}

std::vector<ResultStage> makeGraphStages(const StageMaking& making)
{
    std::vector<ResultStage> stages;
    for (const GraphEntry& graph : graphsOf(making.opener->project())) {
        const CharacterWork work = characterWork(making.opener, graph);
        if (work.sequences.empty())
            continue;
        const ResultStage distances = distanceStage(work, graphstage::poseDistance, graph.pose);
        const ResultStage transitions = transitionStage(work, distances);
        stages.push_back(distances);
        stages.push_back(
            distanceStage(work, graphstage::euclideanDistance, {.metric = PoseMetric::Euclidean}));
        stages.push_back(rootPosesStage(work));
        stages.push_back(transitions);
        if (knowsDrifts(graph))
            stages.push_back(driftStage(work));
        if (graph.costScale == CostScale::Liveliness)
            stages.push_back(livelinessStage(work));
        stages.push_back(graphStage(work));
        stages.push_back(edgeStage(work));
    }
    return stages;
}

} // namespace quadrille
