// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/graphstepresults.h"

#include <algorithm>
#include <utility>

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

/// A row of the table of statistics. \pre There is one of this graph.
PathCostSummary storedPathCosts(const Result& graphs, const std::string& graph, NodeIndex nodes)
{
    const DataTable& table = *std::ranges::find(graphs.tables, "graph-statistics", &DataTable::name);
    const auto& names = columnNamed<TextColumn>(table, "graph");
    const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), graph) - names.begin());
    PathCostSummary summary;
    summary.mean = columnNamed<std::vector<double>>(table, "mean-cost")[row];
    summary.standardDeviation = columnNamed<std::vector<double>>(table, "cost-deviation")[row];
    summary.unreachablePairs = columnNamed<std::vector<std::int64_t>>(table, "unreachable-pairs")[row];
    summary.reachablePairs = std::int64_t{nodes} * (nodes - 1) - summary.unreachablePairs;
    return summary;
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

std::shared_ptr<const Digraph> storedEssentialGraph(const CharacterInputs& work, const StepContext& context,
                                                    NodeIndex nodeCount)
{
    const std::string graphs = work.stepName(graphstep::graphs);
    return context.shared<const Digraph>({graphs}, {}, [&] {
        return std::make_shared<const Digraph>(
            storedGraph(*context.resultOf(graphs), "essential-graph", nodeCount));
    });
}

Result costOverviewResult(CostOverview overview, const std::string& unit)
{
    Result result;
    result.arrays = {
        matrixOf("cost-overview", "Least cost of a transition in each square of so many frames.", unit,
                 std::move(overview.least)),
        columnOf("cost-overview-frames", "frame", std::vector<std::int64_t>{overview.framesOfCell}),
        columnOf("cost-overview-range", unit, std::vector{overview.range.minimum, overview.range.maximum}),
        columnOf("cost-overview-sequences", "frame", lengthsOf(overview.layout))};
    result.arrays[1].description = "Frames along a side of each square.";
    result.arrays[2].description = "The least cost, and one that nine tenths of all stay below.";
    result.arrays[3].description = "Frames of each sequence, in the order of the project.";
    return result;
}

CostOverview costOverviewOf(const Result& result)
{
    const auto wholes = [&](const char* name) -> const std::vector<std::int64_t>& {
        return std::get<std::vector<std::int64_t>>(arrayOf(result, name).values);
    };
    const auto& range = std::get<std::vector<double>>(arrayOf(result, "cost-overview-range").values);
    return {.layout = FrameLayout(wholes("cost-overview-sequences")),
            .framesOfCell = static_cast<int>(wholes("cost-overview-frames").front()),
            .least = *sharedTableOf<float>(arrayOf(result, "cost-overview")),
            .range = {.minimum = range.front(), .maximum = range.back()}};
}

Result rootPosesResult(RootPoses roots, const std::string& unit)
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
                              "rad", std::move(roots.turns))};
    addSupports(result, roots.supports, unit);
    addStances(result, roots.stances, unit);
    return result;
}

RootPoses rootPosesOf(const Result& result, UpAxis up)
{
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
    roots.turns = sharedTableOf<float>(arrayOf(result, "root-turns"));
    return roots;
}

TransitionTable transitionTableOf(const Result& result)
{
    return {.cost = sharedTableOf<float>(arrayOf(result, "transition-cost")),
            .length = sharedTableOf<std::uint16_t>(arrayOf(result, "transition-length")),
            .windows = sharedTableOf<std::uint16_t>(arrayOf(result, "transition-windows"))};
}

float greatestStepOf(const Result& transitions)
{
    return std::get<std::vector<float>>(arrayOf(transitions, "greatest-step").values).front();
}

std::shared_ptr<const MeasuredGraphs> storedGraphs(const CharacterInputs& work, const StepContext& context,
                                                   const Progress& progress)
{
    return sharedGraphs(work, work.graph.alpha, context, [&](std::shared_ptr<const CostMinima> minima) {
        const auto result = context.resultOf(work.stepName(graphstep::graphs));
        const NodeIndex frames = costsOf(work, context)->layout().frameCount();
        auto graphs = std::make_shared<GraphPair>();
        graphs->alpha = work.graph.alpha;
        graphs->minima = std::move(minima);
        graphs->essential = *storedEssentialGraph(work, context, frames);
        progress.report(0.5);
        graphs->motion = storedGraph(*result, "motion-graph", frames);
        MeasuredGraphs measured;
        measured.essential =
            graphStatistics(graphs->essential, storedPathCosts(*result, "essential", frames));
        measured.motion = graphStatistics(graphs->motion, storedPathCosts(*result, "motion", frames));
        measured.graphs = std::move(graphs);
        return measured;
    });
}

} // namespace quadrille
