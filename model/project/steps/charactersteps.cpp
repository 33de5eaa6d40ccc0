// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/charactersteps.h"

#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/media/sequencesettings.h"
#include "model/synthesis/clips/stepcosts.h"
#include "model/synthesis/quality/liveliness.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

CharacterFrames CharacterInputs::open(const Progress& progress) const
{
    std::vector<MeshSequence> opened;
    for (std::size_t i = 0; i < sequences.size(); ++i) {
        progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(sequences.size()));
        opened.push_back(opener->open(sequences[i], progress)->sequence);
    }
    return CharacterFrames(opened);
}

BuildStep CharacterInputs::step(const std::string& name) const
{
    BuildStep step;
    step.name = stepName(name);
    step.character = character;
    return step;
}

std::vector<std::filesystem::path> CharacterInputs::files(const Progress& progress) const
{
    std::vector<std::filesystem::path> all;
    for (const std::string& sequence : sequences) {
        const auto own = opener->filesOf(sequence, progress);
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

std::vector<GraphEntry> graphsOf(const Project& project)
{
    std::vector<GraphEntry> graphs = project.graphs;
    const auto add = [&](const std::string& character) {
        const auto isIts = [&](const GraphEntry& graph) { return isGraphOf(project, graph, character); };
        if (std::none_of(graphs.begin(), graphs.end(), isIts))
            graphs.emplace_back().character = character;
    };
    for (const EvaluationEntry& evaluation : project.evaluations) {
        if (!evaluation.character.empty() || project.characters.empty())
            add(evaluation.character);
        else
            for (const CharacterEntry& character : project.characters)
                add(character.name);
    }
    for (const AnimationEntry& animation : project.animations)
        add(characterNameOf(project, animation));
    return graphs;
}

bool isGraphOf(const Project& project, const GraphEntry& graph, const std::string& character)
{
    return graph.character == character || (graph.character.empty() && project.characters.size() < 2);
}

GraphEntry graphOf(const Project& project, const std::string& character)
{
    for (const GraphEntry& graph : project.graphs) {
        if (isGraphOf(project, graph, character))
            return graph;
    }
    GraphEntry usual;
    usual.character = character;
    return usual;
}

CharacterInputs characterWork(const std::shared_ptr<SequenceOpener>& opener, const GraphEntry& graph)
{
    const Project& project = opener->project();
    CharacterInputs work{.opener = opener, .graph = graph, .character = graph.character};
    if (work.character.empty() && !project.characters.empty())
        work.character = project.characters.front().name;
    work.prefix = project.characters.size() > 1 ? "graph/" + work.character : "graph";
    work.sequences = sequencesOfGraph(project, work.character);
    for (const std::string& name : work.sequences)
        work.settings += sequenceSettings(project, *findSequence(project, name));
    return work;
}

const DataArray& arrayOf(const Result& result, const std::string& name)
{
    const auto found = std::find_if(result.arrays.begin(), result.arrays.end(),
                                    [&](const DataArray& array) { return array.name == name; });
    assert(found != result.arrays.end());
    return *found;
}

std::vector<std::int64_t> lengthsOf(const FrameLayout& layout)
{
    std::vector<std::int64_t> lengths;
    lengths.reserve(static_cast<std::size_t>(layout.sequenceCount()));
    for (int s = 0; s < layout.sequenceCount(); ++s)
        lengths.push_back(layout.countOf(s));
    return lengths;
}

FrameLayout layoutOf(const Result& distances)
{
    return FrameLayout(std::get<std::vector<std::int64_t>>(arrayOf(distances, "sequence-lengths").values));
}

float greatestOf(const Result& distances)
{
    const SharedTable<float> table = sharedTableOf<float>(distances.arrays.front());
    const float greatest = table.empty() ? 0.0F : table->maxCoeff();
    table.unload();
    return greatest;
}

namespace {

TransitionCosts makeCosts(const CharacterInputs& work, const StepContext& context, const CostLooks& looks)
{
    // One after the other, so that no more of these tables are in memory than are needed at once.
    auto distances = context.resultOf(work.stepName(graphstep::poseDistance));
    const FrameLayout layout = layoutOf(*distances);
    const double greatest = work.graph.greatestDistance.value_or(greatestOf(*distances));
    if (looks.distances)
        looks.distances(*distances);
    distances.reset();
    auto transitions = context.resultOf(work.stepName(graphstep::transitions));
    if (looks.transitions)
        looks.transitions(*transitions);
    SharedTable<std::uint16_t> lengths =
        sharedTableOf<std::uint16_t>(arrayOf(*transitions, "transition-length"));
    Table<float> costs = takeTable<float>(std::move(transitions), "transition-cost");
    if (knowsDrifts(work.graph)) {
        const auto drifts = context.resultOf(work.stepName(graphstep::drifts));
        addDrifts(costs, *sharedTableOf<float>(drifts->arrays.front()), *lengths,
                  work.graph.cost == TransitionCost::Sum, work.graph.steps);
    }
    if (work.graph.costScale == CostScale::Liveliness) {
        const auto liveliness = context.resultOf(work.stepName(graphstep::liveliness));
        costs = costPerLiveliness(std::move(costs), layout, tableOf<double>(liveliness->arrays.front()));
    }
    return {layout, greatest, std::move(costs), std::move(lengths)};
}

} // namespace

std::shared_ptr<const TransitionCosts> costsOf(const CharacterInputs& work, const StepContext& context,
                                               const CostLooks& looks)
{
    return context.shared<const TransitionCosts>(costInputs(work), costSettings(work.graph).text(), [&] {
        return std::make_shared<const TransitionCosts>(makeCosts(work, context, looks));
    });
}

std::shared_ptr<const MeasuredGraphs>
sharedGraphs(const CharacterInputs& work, double alpha, const StepContext& context,
             const std::function<MeasuredGraphs(std::shared_ptr<const CostMinima>)>& make,
             const Progress& progress)
{
    const std::vector<std::string> inputs = costInputs(work);
    const JsonLine settings =
        std::vector<JsonLine>{costSettings(work.graph), static_cast<int>(work.graph.smoothing)};
    return context.shared<const MeasuredGraphs>(inputs, jsonLine({settings, alpha}), [&] {
        return std::make_shared<const MeasuredGraphs>(
            make(context.shared<const CostMinima>(inputs, settings.text(), [&] {
                return std::make_shared<const CostMinima>(
                    costMinima(*costsOf(work, context), work.graph.smoothing, progress));
            })));
    });
}

std::shared_ptr<const MeasuredGraphs> graphsAt(const CharacterInputs& work, double alpha,
                                               const StepContext& context, const Progress& progress,
                                               const GraphsTaker& edges)
{
    const auto make = [&](std::shared_ptr<const CostMinima> minima) {
        const auto graphs = std::make_shared<const GraphPair>(
            graphsAt(*costsOf(work, context), std::move(minima), alpha, progress.part(0.05, 0.3), edges));
        if (edges)
            edges(graphs);
        return measured(graphs, progress.part(0.3, 1));
    };
    return sharedGraphs(work, alpha, context, make, progress.part(0, 0.05));
}

bool knowsDrifts(const GraphEntry& graph)
{
    return graph.steps.contacts > 0;
}

std::vector<std::string> costInputs(const CharacterInputs& work)
{
    std::vector<std::string> inputs{work.stepName(graphstep::poseDistance),
                                    work.stepName(graphstep::transitions)};
    if (work.graph.costScale == CostScale::Liveliness)
        inputs.push_back(work.stepName(graphstep::liveliness));
    if (knowsDrifts(work.graph))
        inputs.push_back(work.stepName(graphstep::drifts));
    return inputs;
}

JsonLine costSettings(const GraphEntry& graph)
{
    return std::vector<JsonLine>{graph.greatestDistance.value_or(0),
                                 graph.costScale == CostScale::Liveliness ? "liveliness" : "none",
                                 graph.steps.contacts};
}

} // namespace quadrille
