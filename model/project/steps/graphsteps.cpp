// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/findentry.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/charactergraph.h"
#include "model/project/steps/graphtables.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/finishing/footdrift.h"
#include "model/synthesis/quality/liveliness.h"
#include "model/transition/posedistance.h"
#include "model/transition/transitiontable.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace quadrille {

namespace {

/// What the steps that follow need to know of the frames.
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
auto bytesOfTables(const CharacterInputs& work, double tables)
{
    return [work, tables](const Progress& progress) {
        const double frames = work.open(progress).frameCount();
        return static_cast<std::uint64_t>(tables * frames * frames * static_cast<double>(sizeof(float)));
    };
}

BuildStep distanceStep(const CharacterInputs& work, const std::string& name, PoseDistanceSettings settings)
{
    const bool isSurface = settings.metric == PoseMetric::Surface;
    BuildStep step = work.step(name);
    step.version = isSurface ? 1 : 2;
    step.settings =
        work.settings + nlohmann::json({isSurface ? "surface" : "euclidean", settings.stretchWeight}).dump();
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = clipInputs(work.opener->project(), work.sequences);
    if (step.inputs.empty()) // else frames are not known before
        step.bytes = bytesOfTables(work, 1);
    const auto metres = static_cast<float>(work.opener->project().settings.axes.metresPerUnit);
    step.compute = [=](const StepContext&, const Progress& progress) {
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
        if (name == graphstep::poseDistance)
            addLayout(result, distances);
        return result;
    };
    return step;
}

BuildStep transitionStep(const CharacterInputs& work, const BuildStep& distances)
{
    const TransitionSettings settings = transitionSettings(work.graph, work.opener->project().settings.fps);
    BuildStep step = work.step(graphstep::transitions);
    step.version = 2;
    const StepWeights weights = work.graph.steps;
    const double fps = settings.fps;
    const UpAxis up = work.opener->project().settings.axes.up;
    step.settings = nlohmann::json({settings.shortest(), settings.longest(), settings.shortensInShortTakes,
                                    settings.slope, weights.contacts, weights.velocity, fps,
                                    settings.cost == TransitionCost::Sum ? "sum" : "mean",
                                    settings.length == TransitionLength::Path ? "path" : "windows"})
                        .dump();
    step.inputs = {distances.name};
    if (!weights.isNothing())
        step.inputs.push_back(work.stepName(graphstep::rootPoses));
    if (distances.bytes)
        step.bytes = bytesOfTables(work, 2.5);
    step.compute = [=, inputs = step.inputs](const StepContext& context, const Progress& progress) {
        auto poses = context.resultOf(inputs.front());
        const FrameLayout layout = layoutOf(*poses);
        const std::string unit = poses->arrays.front().unit;
        Table<float> steps = takeTable<float>(std::move(poses), graphstep::poseDistance);
        if (!weights.isNothing()) {
            const RootPoses roots = rootPosesOf(context.resultOf(inputs[1]), up);
            addStepCosts(steps, StepDifferences(roots, layout, fps), weights);
        }
        const float greatest = steps.size() > 0 ? steps.maxCoeff() : 0.0F;
        TransitionTable table = transitionTable(steps, layout, settings, progress);
        steps.resize(0, 0);
        Result result;
        result.arrays = {matrixOf("transition-cost",
                                  "D, the cost of the best transition from a frame (row) to another.", unit,
                                  std::move(table.cost)),
                         matrixOf("transition-length", "L, the frames that this transition lasts.", "frame",
                                  std::move(table.length)),
                         matrixOf("transition-windows", "Frames of its source and destination window.",
                                  "frame", std::move(table.windows)),
                         columnOf("greatest-step", unit, std::vector{greatest})};
        result.arrays[2].shape = {layout.frameCount(), layout.frameCount(), 2};
        result.arrays[3].description = "The greatest cost of showing two frames together.";
        return result;
    };
    return step;
}

/// What costs know of feet beside the frames that are blended.
BuildStep driftStep(const CharacterInputs& work)
{
    BuildStep step = work.step(graphstep::drifts);
    step.version = 2;
    const double fps = work.opener->project().settings.fps;
    const UpAxis up = work.opener->project().settings.axes.up;
    step.settings = nlohmann::json({fps}).dump();
    step.inputs = {work.stepName(graphstep::poseDistance), work.stepName(graphstep::rootPoses),
                   work.stepName(graphstep::transitions)};
    step.compute = [=, inputs = step.inputs](const StepContext& context, const Progress& progress) {
        const FrameLayout layout = layoutOf(*context.resultOf(inputs[0]));
        const RootPoses roots = rootPosesOf(context.resultOf(inputs[1]), up);
        Result result;
        result.arrays = {matrixOf(
            "transition-drift",
            "How far the blend of the best transition from a frame (row) to another drags a foot "
            "that stands.",
            "body heights",
            footDrifts(roots, layout, transitionWindowsOf(context.resultOf(inputs[2])), fps, progress))};
        return result;
    };
    return step;
}

/// What the parts of the cost of an edge are made of beside paths.
struct EdgeCost
{
    KnownTransition transition;
    float drift = 0;
    float cost = 0;
};

/// The parts of the costs of some transitions, from the results that the graphs are made of.
class TransitionParts
{
public:
    /// \param pairs  sorted by source, then destination.
    TransitionParts(const CharacterInputs& work, const TransitionCosts& costs, std::vector<FramePair> pairs,
                    const StepContext& context)
        : m_contactWeight(work.graph.steps.contacts), m_pairs(std::move(pairs)), m_edges(m_pairs.size())
    {
        const ProjectSettings& settings = work.opener->project().settings;
        const auto resultOf = [&](const char* step) { return context.resultOf(work.stepName(step)); };
        const auto set = [this](const auto& setOne) {
            for (std::size_t e = 0; e < m_edges.size(); ++e)
                setOne(m_edges[e], m_pairs[e]);
        };
        // One table after the other: all of them at once take too much room.
        set([&](EdgeCost& edge, const FramePair& pair) {
            edge.cost = costs.cost()(pair.source, pair.destination);
        });
        {
            const TransitionTable table = transitionTableOf(resultOf(graphstep::transitions));
            set([&](EdgeCost& edge, const FramePair& pair) { edge.transition = table.at(pair); });
        }
        if (knowsDrifts(work.graph)) {
            const SharedTable<float> drifts =
                sharedTableOf<float>(resultOf(graphstep::drifts)->arrays.front());
            set([&](EdgeCost& edge, const FramePair& pair) {
                edge.drift = (*drifts)(pair.source, pair.destination);
            });
        }
        m_distances = sharedTableOf<float>(resultOf(graphstep::poseDistance)->arrays.front());
        m_roots = rootPosesOf(resultOf(graphstep::rootPoses), settings.axes.up);
        // Each is asked for by many transitions.
        m_steps = *m_distances;
        addStepCosts(m_steps, StepDifferences(m_roots, costs.layout(), settings.fps), work.graph.steps);
        m_step = [this](NodeIndex i, NodeIndex j) { return m_steps(i, j); };
        m_paths.emplace(m_steps, costs.layout(), transitionSettings(work.graph, settings.fps));
    }
    TransitionParts(const TransitionParts&) = delete;
    TransitionParts& operator=(const TransitionParts&) = delete;

    CostParts of(const FramePair& pair) const
    {
        const auto found = std::lower_bound(
            m_pairs.begin(), m_pairs.end(), pair, [](const FramePair& a, const FramePair& b) {
                return a.source != b.source ? a.source < b.source : a.destination < b.destination;
            });
        const EdgeCost& edge = m_edges[static_cast<std::size_t>(found - m_pairs.begin())];
        const auto transition = m_paths->of(edge.transition, pair);
        const CostSplit split{.distances = *m_distances,
                              .step = m_step,
                              .stances = m_roots.stances,
                              .contactWeight = m_contactWeight};
        return transition ? split.of(*transition, edge.drift, edge.cost) : CostParts();
    }

private:
    double m_contactWeight;
    std::vector<FramePair> m_pairs;
    std::vector<EdgeCost> m_edges;
    SharedTable<float> m_distances;
    RootPoses m_roots;
    Table<float> m_steps;
    CostSplit::StepOf m_step;
    std::optional<WarpPaths> m_paths;
};

/// The transitions of one graph or another, sorted.
std::vector<FramePair> transitionsOf(const Digraph& a, const Digraph& b)
{
    std::vector<FramePair> pairs;
    for (const Digraph* graph : {&a, &b}) {
        for (const Edge& edge : graph->edges())
            if (edge.kind == EdgeKind::Transition)
                pairs.push_back({edge.from, edge.to});
    }
    std::sort(pairs.begin(), pairs.end(), [](const FramePair& one, const FramePair& other) {
        return std::pair(one.source, one.destination) < std::pair(other.source, other.destination);
    });
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

BuildStep graphStep(const CharacterInputs& work)
{
    BuildStep step = work.step(graphstep::graphs);
    step.version = 4;
    step.settings = nlohmann::json({work.graph.alpha, costSettings(work.graph), work.sequences,
                                    static_cast<int>(work.graph.smoothing)})
                        .dump();
    step.inputs = costInputs(work);
    step.compute = [work, graph = work.graph, sequences = work.sequences](const StepContext& context,
                                                                          const Progress& progress) {
        const auto measured = graphsAt(work, graph.alpha, context, progress);
        const GraphPair& graphs = *measured->graphs;
        const auto costs = costsOf(work, context);
        TableBuilder statistics = statisticsTable("graph-statistics", "Both graphs at the project's alpha.");
        addStatistics(statistics, "essential", graph.alpha, measured->essential);
        addStatistics(statistics, "motion", graph.alpha, measured->motion);
        TableBuilder components = componentTable("graph-components");
        addComponents(components, "essential", graph.alpha, measured->essential.connectivity, costs->layout(),
                      sequences);
        addComponents(components, "motion", graph.alpha, measured->motion.connectivity, costs->layout(),
                      sequences);
        Result result;
        result.tables = {
            graphTable("motion-graph", "The motion graph; motion-graph-edges tells more.", graphs.motion),
            graphTable("essential-graph", "The Essential graph; essential-graph-edges tells more.",
                       graphs.essential),
            std::move(statistics).table(), std::move(components).table()};
        return result;
    };
    return step;
}

/// A step of its own: the parts of many costs take longer than the graphs, which others wait for.
BuildStep edgeStep(const CharacterInputs& work)
{
    BuildStep step = work.step(graphstep::edges);
    step.inputs = costInputs(work);
    step.inputs.push_back(work.stepName(graphstep::rootPoses));
    step.inputs.push_back(work.stepName(graphstep::graphs));
    step.settings = costSettings(work.graph).dump();
    step.compute = [work, graphs = step.inputs.back()](const StepContext& context, const Progress& progress) {
        const auto shared = costsOf(work, context);
        const TransitionCosts& costs = *shared;
        auto both = context.resultOf(graphs);
        const NodeIndex frames = costs.layout().frameCount();
        const Digraph motion = storedGraph(*both, "motion-graph", frames);
        const Digraph essential = storedGraph(*both, "essential-graph", frames);
        both.reset();
        std::vector<CostParts> motionParts;
        std::vector<CostParts> essentialParts;
        { // whose tables take as much room as those that follow
            const TransitionParts parts(work, costs, transitionsOf(motion, essential), context);
            const auto partsOf = [&](const FramePair& pair) { return parts.of(pair); };
            motionParts = partsOfEdges(motion, partsOf, progress.part(0, 0.1));
            essentialParts = partsOfEdges(essential, partsOf, progress.part(0.1, 1));
        }
        const EdgeNaming naming{costs, work.sequences};
        Result result;
        result.tables = {
            edgeTable("motion-graph-edges", "The motion graph: local minima of the transition cost.", motion,
                      motionParts, naming),
            edgeTable("essential-graph-edges", "The Essential graph: all edges on shortest paths.", essential,
                      essentialParts, naming)};
        return result;
    };
    return step;
}

/// What costs are scaled by on demand.
BuildStep livelinessStep(const CharacterInputs& work)
{
    BuildStep step = work.step(graphstep::liveliness);
    step.settings = work.settings;
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = clipInputs(work.opener->project(), work.sequences);
    step.compute = [work, up = work.opener->project().settings.axes.up](const StepContext&,
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
    return step;
}

/// Where the frames stand and how they are turned, for walks.
BuildStep rootPosesStep(const CharacterInputs& work)
{
    const UpAxis up = work.opener->project().settings.axes.up;
    BuildStep step = work.step(graphstep::rootPoses);
    step.version = 5;
    step.settings = work.settings;
    for (const std::string& name : work.sequences)
        step.settings += contactSettings(*findSequence(work.opener->project(), name));
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = clipInputs(work.opener->project(), work.sequences);
    step.compute = [work, up](const StepContext&, const Progress& progress) {
        const CharacterFrames frames = work.open(progress.part(0, 0.05));
        RootPoses roots = rootPoses(frames, up, progress.part(0.05, 0.8));
        roots.supports = findSupports(frames, up, progress.part(0.8, 0.9));
        constexpr std::size_t enough = 48; // vertices that stand
        thinSupports(roots.supports, enough);
        roots.stances = findStances(frames, up, progress.part(0.9, 1));
        return rootPosesResult(roots, unitText(work.opener->project().settings.axes.metresPerUnit));
    };
    return step;
}

} // namespace

std::vector<BuildStep> makeGraphSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const GraphEntry& graph : graphsOf(making.opener->project())) {
        const CharacterInputs work = characterWork(making.opener, graph);
        if (work.sequences.empty())
            continue;
        const BuildStep distances = distanceStep(work, graphstep::poseDistance, graph.pose);
        const BuildStep transitions = transitionStep(work, distances);
        steps.push_back(distances);
        steps.push_back(distanceStep(work, graphstep::euclideanDistance, {.metric = PoseMetric::Euclidean}));
        steps.push_back(rootPosesStep(work));
        steps.push_back(transitions);
        if (knowsDrifts(graph))
            steps.push_back(driftStep(work));
        if (graph.costScale == CostScale::Liveliness)
            steps.push_back(livelinessStep(work));
        steps.push_back(graphStep(work));
        steps.push_back(edgeStep(work));
    }
    return steps;
}

} // namespace quadrille
