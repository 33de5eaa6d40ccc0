// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/freememory.h"
#include "model/core/mediacache.h"
#include "model/project/document/lengthunit.h"
#include "model/project/document/madeclips.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/charactergraph.h"
#include "model/project/steps/graphstepresults.h"
#include "model/project/steps/graphtables.h"
#include "model/project/steps/posesteps.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/finishing/footdrift.h"
#include "model/synthesis/quality/liveliness.h"
#include "model/transition/transitiontable.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace quadrille {

namespace {

/// Of frames that were compared only those used last stay: tables of all pairs need the room.
void makeRoomFor(std::uint64_t tables)
{
    MediaCache& cache = *MediaCache::shared();
    const std::size_t budget = cache.statistics().budget;
    if (tables < budget)
        return;
    cache.setBudget(budget / 8);
    cache.setBudget(budget);
    returnFreeMemory();
}

BuildStep transitionStep(const CharacterInputs& work, const BuildStep& distances)
{
    const TransitionSettings settings = transitionSettings(work.graph, work.opener->project().settings.fps);
    BuildStep step = work.step(graphstep::transitions);
    step.version = 2;
    const StepWeights weights = work.graph.steps;
    const double fps = settings.fps;
    const UpAxis up = work.opener->project().settings.axes.up;
    step.settings = jsonLine({settings.shortest(), settings.longest(), settings.shortensInShortTakes,
                              settings.slope, weights.contacts, weights.velocity, fps,
                              settings.cost == TransitionCost::Sum ? "sum" : "mean",
                              settings.length == TransitionLength::Path ? "path" : "windows"});
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
            const RootPoses roots = rootPosesOf(*context.resultOf(inputs[1]), up);
            addStepCosts(steps, StepDifferences(roots, layout, fps), weights);
        }
        const float greatest = steps.size() > 0 ? steps.maxCoeff() : 0.0F;
        makeRoomFor(sizeof(float) * static_cast<std::uint64_t>(steps.size()) * 7 / 2);
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
    step.version = 3;
    const double fps = work.opener->project().settings.fps;
    const UpAxis up = work.opener->project().settings.axes.up;
    step.settings = jsonLine({fps});
    step.inputs = {work.stepName(graphstep::poseDistance), work.stepName(graphstep::rootPoses),
                   work.stepName(graphstep::transitions)};
    step.compute = [=, inputs = step.inputs](const StepContext& context, const Progress& progress) {
        const FrameLayout layout = layoutOf(*context.resultOf(inputs[0]));
        const RootPoses roots = rootPosesOf(*context.resultOf(inputs[1]), up);
        Result result;
        result.arrays = {matrixOf(
            "transition-drift",
            "How far the blend of the best transition from a frame (row) to another drags a foot "
            "that stands.",
            "body heights",
            footDrifts(roots, layout, transitionTableOf(*context.resultOf(inputs[2])), fps, progress))};
        return result;
    };
    return step;
}

/// What is known of the transitions of a graph beside their paths, by position of the edge.
using KnownEdges = std::vector<EdgePaths::Known>;

/// One table after the other is read: all of them at once take too much room.
std::vector<KnownEdges> knownEdges(const std::vector<const Digraph*>& graphs, const CharacterInputs& work,
                                   const StepContext& context)
{
    std::vector<KnownEdges> known;
    known.reserve(graphs.size());
    for (const Digraph* graph : graphs)
        known.emplace_back(graph->edges().size());
    const auto set = [&](const auto& setOne) {
        for (std::size_t g = 0; g < graphs.size(); ++g)
            for (std::size_t e = 0; e < known[g].size(); ++e)
                setOne(known[g][e], graphs[g]->edges()[e]);
    };
    {
        const TransitionTable table =
            transitionTableOf(*context.resultOf(work.stepName(graphstep::transitions)));
        set([&](EdgePaths::Known& edge, const Edge& ends) {
            edge.transition = table.at({.source = ends.from, .destination = ends.to});
        });
    }
    if (knowsDrifts(work.graph)) {
        const SharedTable<float> drifts =
            sharedTableOf<float>(context.resultOf(work.stepName(graphstep::drifts))->arrays.front());
        set([&](EdgePaths::Known& edge, const Edge& ends) { edge.drift = drifts(ends.from, ends.to); });
    }
    return known;
}

BuildStep graphStep(const CharacterInputs& work)
{
    BuildStep step = work.step(graphstep::graphs);
    step.version = 4;
    step.settings = jsonLine(
        {work.graph.alpha, costSettings(work.graph), work.sequences, static_cast<int>(work.graph.smoothing)});
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
        // One after the other: from a list of all they would be copied.
        Result result;
        result.tables.push_back(
            graphTable("motion-graph", "The motion graph; motion-graph-edges tells more.", graphs.motion));
        result.tables.push_back(graphTable(
            "essential-graph", "The Essential graph; essential-graph-edges tells more.", graphs.essential));
        result.tables.push_back(std::move(statistics).table());
        result.tables.push_back(std::move(components).table());
        return result;
    };
    return step;
}

/// What a map of costs shows of them before they are read.
BuildStep overviewStep(const CharacterInputs& work)
{
    BuildStep step = work.step(graphstep::overview);
    step.settings = costSettings(work.graph).text();
    step.inputs = costInputs(work);
    step.compute = [work](const StepContext& context, const Progress&) {
        const auto costs = costsOf(work, context);
        const bool isSurface = work.graph.pose.metric == PoseMetric::Surface;
        return costOverviewResult(costOverview(costs->cost(), costs->layout()), isSurface ? "rad" : "m");
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
    step.settings = costSettings(work.graph).text();
    step.compute = [work, graphs = step.inputs.back()](const StepContext& context, const Progress& progress) {
        const auto resultOf = [&](const char* name) { return context.resultOf(work.stepName(name)); };
        const ProjectSettings& settings = work.opener->project().settings;
        context.forgetUnused();
        const FrameLayout layout = layoutOf(*resultOf(graphstep::poseDistance));
        constexpr std::uint64_t bytesOfPair = 12; // of the tables that are read at once
        makeRoomFor(bytesOfPair * static_cast<std::uint64_t>(layout.frameCount()) *
                    static_cast<std::uint64_t>(layout.frameCount()));
        auto both = context.resultOf(graphs);
        Digraph motion = storedGraph(*both, "motion-graph", layout.frameCount());
        Digraph essential = storedGraph(*both, "essential-graph", layout.frameCount());
        both.reset();
        const std::vector<const Digraph*> all{&motion, &essential};
        std::vector<std::vector<EdgeCost>> costs;
        costs.reserve(all.size());
        {
            const std::vector<KnownEdges> known = knownEdges(all, work, context);
            {
                const auto shared = costsOf(work, context);
                for (const Digraph* graph : all)
                    costs.push_back(costsOfEdges(*graph, *shared));
            }
            context.forgetUnused();
            const float greatestStep = greatestStepOf(*resultOf(graphstep::transitions));
            const RootPoses roots = rootPosesOf(*resultOf(graphstep::rootPoses), settings.axes.up);
            const SharedTable<float> distances =
                sharedTableOf<float>(resultOf(graphstep::poseDistance)->arrays.front());
            splitCosts(all,
                       {.layout = layout,
                        .distances = *distances,
                        .differences = StepDifferences(roots, layout, settings.fps),
                        .weights = work.graph.steps,
                        .greatestStep = greatestStep,
                        .settings = transitionSettings(work.graph, settings.fps),
                        .stances = roots.stances,
                        .known = [&](std::size_t graph, std::size_t edge) { return known[graph][edge]; }},
                       costs, progress.part(0, 0.9));
        }
        Result result;
        // Either goes as soon as it is a table, its costs before.
        const auto add = [&](const char* name, const char* description, Digraph&& graph,
                             std::vector<EdgeCost>&& edgeCosts) {
            const Digraph own = std::move(graph);
            result.tables.push_back(
                edgeTable(name, description, own, std::move(edgeCosts), layout, work.sequences));
        };
        add("motion-graph-edges", "The motion graph: local minima of the transition cost.", std::move(motion),
            std::move(costs[0]));
        add("essential-graph-edges", "The Essential graph: all edges on shortest paths.",
            std::move(essential), std::move(costs[1]));
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

} // namespace

std::vector<BuildStep> makeGraphSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const GraphEntry& graph : graphsOf(making.opener->project())) {
        const CharacterInputs work = characterWork(making.opener, graph);
        if (work.sequences.empty())
            continue;
        std::vector<BuildStep> poses = poseSteps(work);
        const BuildStep transitions = transitionStep(work, poses.front());
        std::ranges::move(poses, std::back_inserter(steps));
        steps.push_back(transitions);
        if (knowsDrifts(graph))
            steps.push_back(driftStep(work));
        if (graph.costScale == CostScale::Liveliness)
            steps.push_back(livelinessStep(work));
        steps.push_back(overviewStep(work));
        steps.push_back(graphStep(work));
        steps.push_back(edgeStep(work));
    }
    return steps;
}

} // namespace quadrille
