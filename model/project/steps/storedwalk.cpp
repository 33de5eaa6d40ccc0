// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/storedwalk.h"

#include "model/project/steps/walkrequest.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

// What the rows of the report are called.
constexpr auto edgeCostRow = "cost of edges";
constexpr auto timingCostRow = "cost of timing";
constexpr auto deviationCostRow = "cost of deviation";
constexpr auto totalCostRow = "total cost";
constexpr auto expansionsRow = "expansions";
constexpr auto optimalRow = "proven best in the Essential graph";
constexpr auto boundRow = "proven least cost of any walk in the Essential graph";
constexpr auto keyRow = "key";
constexpr auto pathLengthRow = "length of path";
constexpr auto meanDeviationRow = "mean deviation";
constexpr auto greatestDeviationRow = "greatest deviation";
constexpr auto actionRow = "action";
constexpr auto pathSpanRow = "span of path";

DataArray askedArray(const FrameRange& asked)
{
    DataArray array;
    array.name = "asked";
    array.description = "The first and the last frame that show what was asked for: keys, actions and spans "
                        "of a path; 0 and -1 where nothing was.";
    array.shape = {2};
    array.values = std::vector<std::int64_t>{asked.first.value, asked.last.value};
    return array;
}

DataTable walkTable(const WalkSolution& solution, const CharacterGraph& graph, const ClipPlan& plan)
{
    TableBuilder table("walk", "The captured frames of the animation, and the transitions after them.");
    table.text("sequence").whole("first", "frame").whole("last", "frame").whole("shown-from", "frame");
    table.whole("transition-length", "frame").real("transition-cost").real("transition-weight");
    // What the cost is made of.
    table.real("pose-cost").real("contact-cost").real("velocity-cost");
    const std::vector<WalkSpan>& spans = solution.walk.spans;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const NamedFrame first = graph.nameOf(spans[i].first);
        const bool isLast = i + 1 == spans.size();
        std::int64_t length = 0;
        double cost = 0;
        double weight = 0;
        CostParts parts;
        if (!isLast) {
            const FramePair pair = solution.walk.transition(i);
            length = graph.costs().length()(pair.source, pair.destination);
            cost = static_cast<double>(graph.costs().cost()(pair.source, pair.destination));
            weight = graph.costs().weight(pair.source, pair.destination, graph.alpha());
            parts = graph.partsOf(pair);
        }
        table.add({first.sequence, first.frame.value, graph.nameOf(spans[i].last).frame.value,
                   plan.spanStarts[i], length, cost, weight, parts.pose, parts.contacts, parts.velocity});
    }
    return std::move(table).table();
}

/// What was wanted and what came out.
DataTable reportTable(const AnimationEntry& animation, const CharacterGraph& graph,
                      const WalkSolution& solution, const WalkConstraints& constraints,
                      std::int64_t frameCount)
{
    const double fps = graph.fps();
    TableBuilder table("report", "What was asked of the animation, and what it does.");
    table.text("what").text("name").real("wanted").real("obtained").text("unit");
    constexpr double open = std::numeric_limits<double>::quiet_NaN(); // nothing was asked
    table.add({"duration", "", open, static_cast<double>(frameCount) / fps, "s"});
    table.add({"transitions", "", open, static_cast<double>(solution.walk.transitionCount()), ""});
    table.add({edgeCostRow, "", open, solution.cost.edges, ""});
    if (animation.walk)
        return std::move(table).table();
    const char* const unit = constraints.path ? "m²" : "";
    const CostWeights weights = costWeights(animation, graph);
    table.add({"weight of edges", "mu", open, weights.mu, unit});
    table.add({timingCostRow, "", open, solution.cost.timing, unit});
    table.add({"weight of timing", "beta, of a frame", open, weights.beta, unit});
    table.add({deviationCostRow, "", open, solution.cost.deviation, "m²"});
    table.add({totalCostRow, "", open, solution.totalCost, unit});
    table.add({expansionsRow, "", open, static_cast<double>(solution.expansions), ""});
    table.add({optimalRow, solution.eachLeg ? "each stretch from key to key" : "", open,
               solution.optimal ? 1.0 : 0.0, ""});
    table.add({boundRow, "", open, solution.bound > 0 ? solution.bound : open, unit});
    for (std::size_t k = 0; k < solution.keys.size(); ++k)
        table.add({keyRow, std::to_string(k + 1), solution.keys[k].wanted / fps,
                   static_cast<double>(solution.keys[k].obtained) / fps, "s"});
    if (constraints.path) {
        table.add({pathLengthRow, "", solution.pathLength, solution.pathLength, "m"});
        table.add({meanDeviationRow, "", 0.0, solution.meanDeviation, "m"});
        table.add({greatestDeviationRow, "", 0.0, solution.greatestDeviation, "m"});
    }
    const auto addRange = [&](const char* what, const std::string& name, const FrameRange& range,
                              const std::optional<double>& wanted) {
        table.add(
            {std::string(what) + " from", name, open, static_cast<double>(range.first.value) / fps, "s"});
        table.add({std::string(what) + " lasts", name, wanted.value_or(open) / fps,
                   static_cast<double>(range.count()) / fps, "s"});
    };
    for (std::size_t a = 0; a < solution.actions.size(); ++a)
        addRange(actionRow, constraints.actions[a].frames.name, solution.actions[a],
                 constraints.actions[a].duration);
    for (std::size_t s = 0; s < solution.spans.size(); ++s) {
        const PathSpan& span = constraints.path->spans[s];
        addRange(pathSpanRow, span.demanded ? span.demanded->name : std::to_string(s + 1), solution.spans[s],
                 span.duration);
    }
    return std::move(table).table();
}

Walk spansOf(const Result& result, const CharacterGraph& graph)
{
    const DataTable& table = result.tables.front();
    const auto& sequences = std::get<TextColumn>(table.columns[0].values);
    const auto& first = std::get<std::vector<std::int64_t>>(table.columns[1].values);
    const auto& last = std::get<std::vector<std::int64_t>>(table.columns[2].values);
    Walk walk;
    for (std::size_t i = 0; i < sequences.size(); ++i)
        walk.spans.push_back(graph.span(sequences[i], FrameRange{FrameIndex(first[i]), FrameIndex(last[i])}));
    return walk;
}

/// Reads the report of a walk row by row.
class ReportReader
{
public:
    ReportReader(const DataTable& report, double fps)
        : m_what(std::get<TextColumn>(report.columns[0].values))
        , m_name(std::get<TextColumn>(report.columns[1].values))
        , m_obtained(std::get<std::vector<double>>(report.columns[3].values))
        , m_fps(fps)
    {
    }

    /// Nothing where it says nothing of it.
    double valueOf(const char* row) const
    {
        const auto found = std::ranges::find(m_what, row);
        const double value =
            found == m_what.end() ? 0 : m_obtained[static_cast<std::size_t>(found - m_what.begin())];
        return std::isfinite(value) ? value : 0;
    }
    std::string nameOf(const char* row) const
    {
        const auto found = std::ranges::find(m_what, row);
        return found == m_what.end() ? std::string()
                                     : m_name[static_cast<std::size_t>(found - m_what.begin())];
    }
    /// Of all rows that are called so, seconds as frames.
    std::vector<std::int64_t> framesOf(const std::string& row) const
    {
        std::vector<std::int64_t> frames;
        for (std::size_t i = 0; i < m_what.size(); ++i) {
            if (m_what[i] == row)
                frames.push_back(std::llround(m_obtained[i] * m_fps));
        }
        return frames;
    }
    std::vector<FrameRange> rangesOf(const char* row) const
    {
        const auto first = framesOf(std::string(row) + " from");
        const auto count = framesOf(std::string(row) + " lasts");
        std::vector<FrameRange> ranges;
        for (std::size_t i = 0; i < first.size(); ++i)
            ranges.push_back({FrameIndex(first[i]), FrameIndex(first[i] + count[i] - 1)});
        return ranges;
    }

private:
    const TextColumn& m_what;
    const TextColumn& m_name;
    const std::vector<double>& m_obtained;
    double m_fps;
};

} // namespace

DataArray groundMotionArray(std::string name, std::string description, const GroundMotion& motion)
{
    DataArray array;
    array.name = std::move(name);
    array.description = std::move(description);
    array.shape = {3};
    array.values = std::vector<double>{motion.turn, motion.shift.x(), motion.shift.y()};
    return array;
}

GroundMotion groundMotionOf(const DataArray& array)
{
    const auto& values = std::get<std::vector<double>>(array.values);
    return {values[0], Vec2d(values[1], values[2])};
}

DataArray framesBeforeRetimeArray(std::int64_t frames)
{
    DataArray array = columnOf("frames-before-retime", "frame", std::vector{frames});
    array.description =
        "How long the clip lasts before it is retimed: to its last frame, a loop to its first.";
    return array;
}

Result walkResult(const AnimationEntry& animation, const CharacterGraph& graph, const AnimationWalk& walk)
{
    const WalkSolution& solution = walk.solution;
    const ClipPlan plan = planClip(graph.roots(), graph.layout(), graph.paths(), solution.walk);
    Result result;
    result.arrays = {groundMotionArray("placement",
                                       "Turn about the up axis, radians, and shift over the ground, "
                                       "metres, that place the first sequence as it was captured.",
                                       solution.start),
                     askedArray(solution.asked())};
    result.tables = {walkTable(solution, graph, plan),
                     reportTable(animation, graph, solution, walk.constraints, plan.frameCount())};
    return result;
}

WalkSolution shownWalkOf(const Result& result, const CharacterGraph& graph)
{
    const auto& asked = std::get<std::vector<std::int64_t>>(arrayOf(result, "asked").values);
    return {.walk = spansOf(result, graph),
            .start = groundMotionOf(arrayOf(result, "placement")),
            .actions = {{FrameIndex(asked[0]), FrameIndex(asked[1])}}};
}

AnimationWalk storedWalk(const Result& result, const AnimationEntry& animation, const CharacterGraph& graph)
{
    if (animation.walk)
        return animationWalk(animation, graph);
    AnimationWalk stored{
        .constraints = walkConstraints(animation, graph),
        .solution = {.walk = spansOf(result, graph), .start = groundMotionOf(arrayOf(result, "placement"))}};
    const ReportReader report(result.tables.at(1), graph.fps());
    WalkSolution& solution = stored.solution;
    solution.cost = {.deviation = report.valueOf(deviationCostRow),
                     .edges = report.valueOf(edgeCostRow),
                     .timing = report.valueOf(timingCostRow)};
    solution.totalCost = report.valueOf(totalCostRow);
    solution.frameCount = report.framesOf("duration").front();
    const auto keys = report.framesOf(keyRow);
    for (std::size_t k = 0; k < keys.size(); ++k)
        solution.keys.push_back({stored.constraints.keys.at(k).time, keys[k]});
    solution.meanDeviation = report.valueOf(meanDeviationRow);
    solution.greatestDeviation = report.valueOf(greatestDeviationRow);
    solution.pathLength = report.valueOf(pathLengthRow);
    solution.actions = report.rangesOf(actionRow);
    solution.spans = report.rangesOf(pathSpanRow);
    solution.expansions = std::llround(report.valueOf(expansionsRow));
    solution.optimal = report.valueOf(optimalRow) > 0;
    solution.eachLeg = !report.nameOf(optimalRow).empty();
    solution.bound = report.valueOf(boundRow);
    return stored;
}

} // namespace quadrille
