// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/charactergraph.h"

#include "model/project/document/throwinvalid.h"
#include "model/synthesis/clips/stepcosts.h"

#include <algorithm>
#include <array>

namespace quadrille {

namespace {

void addSupports(Result& result, const std::vector<Support>& supports, const std::string& unit)
{
    std::vector<std::int64_t> counts;
    std::vector<std::int64_t> vertices;
    std::vector<double> places;
    for (const Support& support : supports) {
        counts.push_back(static_cast<std::int64_t>(support.vertices.size()));
        vertices.insert(vertices.end(), support.vertices.begin(), support.vertices.end());
        for (const Vec2d& place : support.places)
            places.insert(places.end(), place.begin(), place.end());
    }
    const auto add = [&result](const char* name, const char* description, const std::string& unitOf,
                               auto values) {
        result.arrays.push_back(columnOf(name, unitOf, std::move(values)));
        result.arrays.back().description = description;
    };
    add("support-counts", "How many vertices stand on the ground in each frame.", "", std::move(counts));
    add("support-vertices", "The vertices that stand, frame after frame.", "", std::move(vertices));
    add("support-places", "Where they stand on the ground, two coordinates each.", unit, std::move(places));
    result.arrays.back().shape = {result.arrays.back().shape.front() / 2, 2};
}

void addStances(Result& result, const Stances& stances, const std::string& unit)
{
    DataTable feet{.name = "feet", .description = "The feet of the character; vertices by foot-vertices."};
    std::vector<std::string> names;
    std::vector<std::int64_t> counts;
    std::vector<std::int64_t> vertices;
    for (const Stances::Foot& foot : stances.feet) {
        names.push_back(foot.name);
        counts.push_back(static_cast<std::int64_t>(foot.vertices.size()));
        vertices.insert(vertices.end(), foot.vertices.begin(), foot.vertices.end());
    }
    const auto count = static_cast<std::int64_t>(stances.feet.size());
    std::vector<std::int64_t> standing;
    standing.reserve(stances.standing.size() * stances.feet.size());
    for (const std::uint32_t feetOfFrame : stances.standing)
        for (std::size_t foot = 0; foot < stances.feet.size(); ++foot)
            standing.push_back(feetOfFrame >> foot & 1U);
    feet.columns = {columnOf("foot", "", std::move(names)), columnOf("vertices", "", std::move(counts))};
    result.tables.push_back(std::move(feet));
    const auto add = [&result](const char* name, const char* description, const std::string& unitOf,
                               auto values) {
        result.arrays.push_back(columnOf(name, unitOf, std::move(values)));
        result.arrays.back().description = description;
    };
    add("foot-vertices", "The vertices of each foot, foot after foot.", "", std::move(vertices));
    add("foot-height", "Height of the figure.", unit, std::vector{stances.height});
    std::vector<double> places;
    places.reserve(3 * stances.places.size());
    for (const Vec3d& place : stances.places)
        places.insert(places.end(), place.begin(), place.end());
    add("foot-places", "Mean of the vertices of each foot in each frame.", unit, std::move(places));
    result.arrays.back().shape = {static_cast<std::int64_t>(stances.standing.size()), count, 3};
    add("stances", "Whether each foot stands in each frame, 1 or 0.", "", std::move(standing));
    result.arrays.back().shape = {static_cast<std::int64_t>(stances.standing.size()), count};
}

Stances stancesOf(const Result& result)
{
    const auto wholes = [&](const char* name) -> const std::vector<std::int64_t>& {
        return std::get<std::vector<std::int64_t>>(arrayOf(result, name).values);
    };
    Stances stances;
    const DataTable& feet = result.tables.front();
    const auto& names = std::get<TextColumn>(feet.columns[0].values);
    const auto& counts = std::get<std::vector<std::int64_t>>(feet.columns[1].values);
    auto vertex = wholes("foot-vertices").begin();
    for (std::size_t i = 0; i < names.size(); ++i) {
        Stances::Foot& foot = stances.feet.emplace_back();
        foot.name = names[i];
        for (std::int64_t v = 0; v < counts[i]; ++v)
            foot.vertices.push_back(static_cast<std::uint32_t>(*vertex++));
    }
    stances.height = std::get<std::vector<double>>(arrayOf(result, "foot-height").values).front();
    const auto& places = std::get<std::vector<double>>(arrayOf(result, "foot-places").values);
    for (std::size_t i = 0; i < places.size(); i += 3)
        stances.places.emplace_back(places[i], places[i + 1], places[i + 2]);
    const DataArray& array = arrayOf(result, "stances");
    const auto& standing = wholes("stances");
    stances.standing.assign(static_cast<std::size_t>(array.shape[0]), 0);
    for (std::size_t i = 0; i < standing.size(); ++i)
        stances.standing[i / names.size()] |= static_cast<std::uint32_t>(standing[i]) << i % names.size();
    return stances;
}

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

constexpr int bitsOfWindow = 8;
constexpr std::uint16_t greatestPacked = (1U << bitsOfWindow) - 1;

std::uint16_t packedWindows(std::uint16_t source, std::uint16_t destination)
{
    const bool fits = source <= greatestPacked && destination <= greatestPacked;
    return fits ? static_cast<std::uint16_t>(source << bitsOfWindow | destination) : std::uint16_t{0};
}

} // namespace

Digraph storedGraph(const Result& graphs, const std::string& name, NodeIndex nodeCount)
{
    const auto table = std::find_if(graphs.tables.begin(), graphs.tables.end(),
                                    [&](const DataTable& candidate) { return candidate.name == name; });
    const auto& from = std::get<std::vector<std::int64_t>>(table->columns[0].values);
    const auto& to = std::get<std::vector<std::int64_t>>(table->columns[1].values);
    const auto& weight = std::get<std::vector<double>>(table->columns[2].values);
    const auto& kind = std::get<TextColumn>(table->columns[3].values);
    std::vector<Edge> edges;
    edges.reserve(from.size());
    for (std::size_t e = 0; e < from.size(); ++e)
        edges.push_back({static_cast<NodeIndex>(from[e]), static_cast<NodeIndex>(to[e]), weight[e],
                         kind[e] == "original" ? EdgeKind::Original : EdgeKind::Transition});
    return {nodeCount, std::move(edges)};
}

Result rootPosesResult(const RootPoses& roots, const std::string& unit)
{
    DataArray centres;
    centres.name = "root-centres";
    centres.description = "Mean of the vertices of each frame.";
    centres.unit = unit;
    centres.columns = {"x", "y", "z"};
    centres.shape = {static_cast<std::int64_t>(roots.centres.size()), 3};
    std::vector<double> values;
    values.reserve(3 * roots.centres.size());
    for (const Vec3d& centre : roots.centres)
        values.insert(values.end(), centre.begin(), centre.end());
    centres.values = std::move(values);
    Result result;
    result.arrays = {std::move(centres),
                     matrixOf("root-turns",
                              "Turn about the up axis that lays the pose of the column on that of the row.",
                              "rad", roots.turns)};
    addSupports(result, roots.supports, unit);
    addStances(result, roots.stances, unit);
    return result;
}

RootPoses rootPosesOf(ResultPointer pointer, UpAxis up)
{
    const Result& result = *pointer;
    RootPoses roots{.up = up};
    const auto& centres = std::get<std::vector<double>>(arrayOf(result, "root-centres").values);
    for (std::size_t node = 0; node < centres.size() / 3; ++node)
        roots.centres.emplace_back(centres[3 * node], centres[3 * node + 1], centres[3 * node + 2]);
    const auto& counts = std::get<std::vector<std::int64_t>>(arrayOf(result, "support-counts").values);
    const auto& vertices = std::get<std::vector<std::int64_t>>(arrayOf(result, "support-vertices").values);
    const auto& places = std::get<std::vector<double>>(arrayOf(result, "support-places").values);
    std::size_t next = 0;
    for (const std::int64_t count : counts) {
        Support& support = roots.supports.emplace_back();
        for (std::int64_t i = 0; i < count; ++i, ++next) {
            support.vertices.push_back(static_cast<std::uint32_t>(vertices[next]));
            support.places.emplace_back(places[2 * next], places[2 * next + 1]);
        }
    }
    roots.stances = stancesOf(result);
    roots.turns = takeTable<float>(std::move(pointer), "root-turns");
    return roots;
}

TransitionTable transitionTableOf(ResultPointer result)
{
    SharedTable<float> cost = sharedTableOf<float>(arrayOf(*result, "transition-cost"));
    TransitionTable table = transitionWindowsOf(std::move(result));
    table.cost = std::move(cost).take();
    return table;
}

TransitionTable transitionWindowsOf(ResultPointer result)
{
    SharedTable<std::uint16_t> length = sharedTableOf<std::uint16_t>(arrayOf(*result, "transition-length"));
    TransitionTable table{.windows = takeTable<std::uint16_t>(std::move(result), "transition-windows")};
    table.length = std::move(length).take();
    return table;
}

float greatestStepOf(const Result& transitions)
{
    return std::get<std::vector<float>>(arrayOf(transitions, "greatest-step").values).front();
}

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
    costs = costsOf(work, context);
    layout = costs->layout();
    auto transitions = resultOf(graphstep::transitions);
    greatestStep = greatestStepOf(*transitions);
    const SharedTable<std::uint16_t> both =
        sharedTableOf<std::uint16_t>(arrayOf(*transitions, "transition-windows"));
    transitions.reset();
    windows = Table<std::uint16_t>::Zero(layout.frameCount(), layout.frameCount());
    for (Eigen::Index i = 0; i < windows.rows(); ++i)
        for (Eigen::Index j = 0; j < windows.cols(); ++j)
            windows(i, j) = packedWindows((*both)(i, 2 * j), (*both)(i, 2 * j + 1));
    roots = rootPosesOf(resultOf(graphstep::rootPoses), settings.axes.up);
    distances = sharedTableOf<float>(resultOf(graphstep::poseDistance)->arrays.front());
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
        nlohmann::json({costSettings(work.graph), settings.fps, static_cast<int>(settings.axes.up)}).dump();
    m_tables = context.shared<const Tables>(steps, others,
                                            [&] { return std::make_shared<const Tables>(work, context); });
    const std::string graphs = work.stepName(graphstep::graphs);
    m_graph = context.shared<const Digraph>({graphs}, {}, [&] {
        return std::make_shared<const Digraph>(
            storedGraph(*context.resultOf(graphs), "essential-graph", m_tables->layout.frameCount()));
    });
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
    const std::uint16_t windows = m_tables->windows(pair.source, pair.destination);
    return windows == 0 ? paths().find(pair)
                        : paths().between(pair, windows >> bitsOfWindow, windows & greatestPacked);
}

KnownTransition CharacterGraph::knownTransition(const FramePair& pair) const
{
    KnownTransition known{.cost = costs().cost()(pair.source, pair.destination),
                          .length = costs().length()(pair.source, pair.destination)};
    if (const std::uint16_t windows = m_tables->windows(pair.source, pair.destination)) {
        known.sourceWindow = windows >> bitsOfWindow;
        known.destinationWindow = windows & greatestPacked;
    } else if (const auto found = paths().find(pair)) {
        known.sourceWindow = static_cast<std::uint16_t>(found->sourceWindow);
        known.destinationWindow = static_cast<std::uint16_t>(found->destinationWindow);
    }
    return known;
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
