// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/charactergraph.h"

#include "model/core/freememory.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/json/jsonline.h"
#include "model/synthesis/clips/stepcosts.h"

#include <algorithm>
#include <array>

namespace quadrille {

namespace {

/// Body heights a second; empty where nobody knows how tall the figure is.
std::vector<double> pacesInHeights(const RootPoses& roots, const FrameLayout& layout, double fps)
{
    if (roots.stances.height <= 0)
        return {};
    std::vector<double> paces = pacesOf(roots, layout, fps);
    for (double& pace : paces)
        pace /= roots.stances.height;
    return paces;
}

} // namespace

std::vector<std::string> CharacterGraph::inputs(const CharacterInputs& work)
{
    std::vector<std::string> steps = costInputs(work);
    steps.push_back(work.stepName(graphstep::graphs));
    steps.push_back(work.stepName(graphstep::rootPoses));
    return steps;
}

CharacterGraph::Tables::Tables(const CharacterInputs& work, const StepContext& context)
    : weights(work.graph.steps)
{
    const auto resultOf = [&](const char* step) { return context.resultOf(work.stepName(step)); };
    const ProjectSettings& settings = work.opener->project().settings;
    const auto takeDistances = [&](const Result& poses) {
        distances = sharedTableOf<float>(poses.arrays.front());
    };
    const auto takeTransitions = [&](const Result& result) {
        greatestStep = greatestStepOf(result);
        windows = sharedTableOf<std::uint16_t>(arrayOf(result, "transition-windows"));
    };
    costs = costsOf(work, context, {.distances = takeDistances, .transitions = takeTransitions});
    layout = costs->layout();
    if (windows.empty()) // they were there already
        takeTransitions(*resultOf(graphstep::transitions));
    if (distances.empty())
        takeDistances(*resultOf(graphstep::poseDistance));
    roots = rootPosesOf(*resultOf(graphstep::rootPoses), settings.axes.up);
    differences.emplace(roots, layout, settings.fps);
    if (knowsDrifts(work.graph))
        drifts.emplace(roots, layout, settings.fps);
    const auto rows = [this](NodeIndex source, NodeIndex first, std::span<float> row) {
        for (float& value : row)
            value = step(source, first++);
    };
    paths.emplace(rows, greatestStep, layout, transitionSettings(work.graph, settings.fps));
}

CharacterGraph::CharacterGraph(const CharacterInputs& work, const StepContext& context)
    : m_work(work), m_context(context)
{
    std::vector<std::string> steps = costInputs(work);
    steps.push_back(work.stepName(graphstep::rootPoses));
    const ProjectSettings& settings = work.opener->project().settings;
    const std::string others =
        jsonLine({costSettings(work.graph), settings.fps, static_cast<int>(settings.axes.up)});
    m_tables = context.shared<const Tables>(steps, others, [&] {
        auto tables = std::make_shared<const Tables>(work, context);
        returnFreeMemory(); // of the results that they were made from
        return tables;
    });
    m_graph = storedEssentialGraph(work, context, m_tables->layout.frameCount());
}

void CharacterGraph::unloadTables() const
{
    m_tables->distances.unload();
    m_tables->windows.unload();
    m_tables->roots.turns.unload();
    m_tables->costs->unloadLengths();
}

Table<float> CharacterGraph::steps() const
{
    Table<float> steps = distances();
    addStepCosts(steps, *m_tables->differences, m_tables->weights);
    return steps;
}

std::optional<Transition> CharacterGraph::transition(const FramePair& pair) const
{
    if (!m_tables->costs->hasTransition(pair.source, pair.destination))
        return std::nullopt;
    return paths().of(knownTransition(pair), pair);
}

KnownTransition CharacterGraph::knownTransition(const FramePair& pair) const
{
    const auto [i, j] = pair;
    const SharedTable<std::uint16_t>& windows = m_tables->windows;
    return {.cost = costs().cost()(i, j),
            .length = costs().length()(i, j),
            .sourceWindow = windows(i, Eigen::Index{2} * j),
            .destinationWindow = windows(i, Eigen::Index{2} * j + 1)};
}

CostParts CharacterGraph::partsOf(const FramePair& pair) const
{
    const auto transition = this->transition(pair);
    if (!transition)
        return {};
    const CostSplit::StepOf step = [this](NodeIndex i, NodeIndex j) { return m_tables->step(i, j); };
    const CostSplit split{.distances = distances(),
                          .step = step,
                          .stances = m_tables->roots.stances,
                          .contactWeight = m_work.graph.steps.contacts};
    const float drift = m_tables->drifts ? m_tables->drifts->of(knownTransition(pair), pair) : 0;
    return split.of(*transition, drift, costs().cost()(pair.source, pair.destination));
}

std::vector<std::vector<EdgeCost>> CharacterGraph::edgeCosts(const std::vector<const Digraph*>& graphs,
                                                             const Progress& progress) const
{
    std::vector<std::vector<EdgeCost>> all;
    all.reserve(graphs.size());
    for (const Digraph* graph : graphs)
        all.push_back(costsOfEdges(*graph, costs()));
    const auto known = [&](std::size_t graph, std::size_t edge) {
        const Edge& ends = graphs[graph]->edges()[edge];
        const FramePair pair{.source = ends.from, .destination = ends.to};
        const KnownTransition transition = knownTransition(pair);
        return EdgePaths::Known{.transition = transition,
                                .drift = m_tables->drifts ? m_tables->drifts->of(transition, pair) : 0};
    };
    splitCosts(graphs,
               {.layout = layout(),
                .distances = distances(),
                .differences = *m_tables->differences,
                .weights = m_tables->weights,
                .greatestStep = m_tables->greatestStep,
                .settings = transitionSettings(m_work.graph, fps()),
                .stances = m_tables->roots.stances,
                .known = known},
               all, progress);
    return all;
}

WalkMaterial CharacterGraph::material(const BlendSettings& blend, bool isAlongPath) const
{
    const auto transition = [this](const FramePair& pair) {
        const auto known = this->transition(pair);
        return known ? *known : m_tables->paths->get(pair);
    };
    return {.graph = *m_graph,
            .costs = *m_tables->costs,
            .alpha = alpha(),
            .motion = {.roots = &m_tables->roots,
                       .transition = transition,
                       .blend = blend,
                       .metresPerUnit = metresPerUnit(),
                       .fps = fps()},
            .locomotion = isAlongPath ? locomotion() : std::vector<bool>(),
            .inAir = framesInAir(m_tables->roots.stances, m_tables->layout, fps()),
            .paces = isAlongPath ? pacesInHeights(m_tables->roots, m_tables->layout, fps())
                                 : std::vector<double>()};
}

WalkSpan CharacterGraph::span(const std::string& sequence, const std::optional<FrameRange>& range) const
{
    const auto found = std::find(m_work.sequences.begin(), m_work.sequences.end(), sequence);
    if (found == m_work.sequences.end())
        throwInvalid("The graph has no sequence “" + sequence + "”", "Correct the name.");
    const auto index = static_cast<int>(found - m_work.sequences.begin());
    const NodeIndex count = m_tables->layout.countOf(index);
    if (!range)
        return {m_tables->layout.firstOf(index), m_tables->layout.lastOf(index)};
    for (const FrameIndex frame : {range->first, range->last}) {
        if (frame.value < 0 || frame.value >= count)
            throwNoFrame(sequence, frame.value, count);
    }
    return {m_tables->layout.firstOf(index) + static_cast<NodeIndex>(range->first.value),
            m_tables->layout.firstOf(index) + static_cast<NodeIndex>(range->last.value)};
}

NodeIndex CharacterGraph::node(const NamedFrame& frame) const
{
    return span(frame.sequence, FrameRange{frame.frame, frame.frame}).first;
}

NamedFrame CharacterGraph::nameOf(NodeIndex node) const
{
    const int sequence = m_tables->layout.sequenceOf(node);
    return {m_work.sequences[static_cast<std::size_t>(sequence)],
            FrameIndex(node - m_tables->layout.firstOf(sequence))};
}

Error CharacterGraph::named(const Error& error) const
{
    constexpr std::array codes{ErrorCode::NoTransition, ErrorCode::WalkKeyUnreachable};
    if (std::find(codes.begin(), codes.end(), error.code()) == codes.end())
        return error;
    ErrorContext context = error.context();
    for (auto& [key, value] : context.values) {
        const bool isFrame = key == "source" || key == "destination" || key == "frame" ||
                             (key == "nearest" && value.find_first_not_of("0123456789") == value.npos);
        if (!isFrame)
            continue;
        const NamedFrame frame = nameOf(static_cast<NodeIndex>(std::stol(value)));
        value = std::to_string(frame.frame.value) + " of “" + frame.sequence + "”";
    }
    return Error(error.code(), std::move(context));
}

} // namespace quadrille
