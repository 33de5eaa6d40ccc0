// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/keyexperiment.h"
#include "model/project/document/lengthunit.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/charactergraph.h"
#include "model/project/store/tablebuilder.h"
#include "model/synthesis/quality/junctionreport.h"
#include "model/synthesis/walks/findwalk.h"
#include "model/transition/acceleration.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr auto table2Note = "Poses of the character at new times, drawn at random, as in SMCAS Table 2: when "
                            "each was wanted and when "
                            "the walk shows it; keys in pairs as the paper seeks them, and all at once.";
constexpr auto junctionsNote =
    "Transitions drawn from the Essential graph, and as many local minima of the cost that it leaves out: "
    "what "
    "shows at each, against its limit from the two takes (good up to 1), and what might have told so "
    "beforehand.";
constexpr std::array criterionNames{"acceleration", "frozen", "centre-step", "foot-slip", "volume"};
constexpr std::array criterionUnits{"/s²", "", "", "/s", ""}; // behind that of lengths
constexpr std::array isCriterionLength{true, false, true, true, false};
constexpr std::array predictorNames{"sum", "mean", "acceleration-cost", "weight", "cost"};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<WalkSpan> spansOf(const CharacterGraph& graph, const std::vector<std::string>& sequences)
{
    std::vector<WalkSpan> spans;
    spans.reserve(sequences.size());
    for (const std::string& sequence : sequences)
        spans.push_back(graph.span(sequence, std::nullopt));
    return spans;
}

struct KeyTables
{
    TableBuilder keys;
    TableBuilder summary;
};

KeyTables keyTables()
{
    KeyTables tables{TableBuilder("table2", table2Note),
                     TableBuilder("table2-summary", "The walks of table2: costs and timing errors.")};
    tables.keys.text("search").whole("key").text("sequence").whole("frame", "frame");
    tables.keys.whole("wanted", "frame").whole("obtained", "frame").whole("error", "frame");
    tables.summary.text("search").real("cost").real("edge-cost").real("timing-cost").whole("frames", "frame");
    tables.summary.whole("transitions").real("mean-error", "frame").whole("greatest-error", "frame");
    tables.summary.whole("expansions").text("optimal").real("bound");
    return tables;
}

void addWalk(KeyTables& tables, const char* search, const CharacterGraph& graph,
             const std::vector<PoseKey>& keys, const WalkSolution& solution)
{
    std::int64_t sum = 0;
    std::int64_t greatest = 0;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const NamedFrame frame = graph.nameOf(keys[k].frame);
        const auto wanted = std::llround(keys[k].time);
        const std::int64_t obtained = solution.keys[k].obtained;
        tables.keys.add({search, static_cast<std::int64_t>(k + 1), frame.sequence, frame.frame.value,
                         std::int64_t{wanted}, obtained, obtained - wanted});
        sum += std::abs(obtained - wanted);
        greatest = std::max<std::int64_t>(greatest, std::abs(obtained - wanted));
    }
    tables.summary.add({search, solution.cost.edges + solution.cost.timing, solution.cost.edges,
                        solution.cost.timing, solution.frameCount,
                        static_cast<std::int64_t>(solution.walk.transitionCount()),
                        static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(keys.size(), 1)),
                        greatest, solution.expansions,
                        !solution.optimal  ? "no"
                        : solution.eachLeg ? "from key to key"
                                           : "yes",
                        solution.bound});
}

std::string criterionColumn(std::size_t criterion, const char* what)
{
    return std::string(criterionNames[criterion]) + what;
}

struct JunctionTables
{
    TableBuilder rows;
    TableBuilder criteria;
    TableBuilder predictors;
};

JunctionTables junctionTables(const std::string& unit, const std::string& length)
{
    JunctionTables tables{
        TableBuilder("junctions", junctionsNote),
        TableBuilder("junctions-criteria",
                     "How many of the junctions of the Essential graph are good, by criterion and by all of "
                     "them, and quantiles of what they use up of their limits."),
        TableBuilder("junctions-predictors",
                     "How well costs tell beforehand what all junctions of the first table are like: rank "
                     "correlation with the worst ratio, and the area under the curve for those that are not "
                     "good (½ tells nothing, 1 all).")};
    tables.rows.text("blend").text("drawn-from").text("from").whole("from-frame", "frame").text("to");
    tables.rows.whole("to-frame", "frame").whole("length", "frame").whole("source-window", "frame");
    tables.rows.whole("destination-window", "frame");
    const std::array<std::string, junctionPredictors> predictorUnits{unit, unit, length + "/s²", "", unit};
    tables.predictors.text("blend")
        .text("predictor")
        .whole("transitions")
        .whole("bad")
        .real("rank-correlation")
        .real("area");
    for (std::size_t p = 0; p < junctionPredictors; ++p)
        tables.rows.real(predictorNames[p], predictorUnits[p]);
    for (std::size_t c = 0; c < junctionCriteria; ++c) {
        tables.rows.real(criterionColumn(c, ""),
                         isCriterionLength[c] ? length + criterionUnits[c] : std::string());
        tables.rows.real(criterionColumn(c, "-ratio"));
        tables.predictors.real(criterionColumn(c, "-area"));
    }
    tables.criteria.text("blend").text("criterion").whole("measured").whole("good").real("median-ratio");
    tables.criteria.real("ninetieth-ratio").real("greatest-ratio");
    return tables;
}

void addReport(JunctionTables& tables, const std::string& blend, const CharacterGraph& graph,
               const JunctionReport& report)
{
    double worst = 0;
    for (const JunctionRow& row : report.rows) {
        const NamedFrame from = graph.nameOf(row.frames.source);
        const NamedFrame to = graph.nameOf(row.frames.destination);
        std::vector<TableBuilder::Cell> cells{blend,
                                              row.source == JunctionSource::Graph ? "essential" : "minima",
                                              from.sequence,
                                              from.frame.value,
                                              to.sequence,
                                              to.frame.value,
                                              std::int64_t{row.length},
                                              std::int64_t{row.sourceWindow},
                                              std::int64_t{row.destinationWindow}};
        cells.insert(cells.end(), row.predictors.begin(), row.predictors.end());
        for (const JunctionValue& value : row.measures.values) {
            cells.emplace_back(value.isMeasured ? value.value : none);
            cells.emplace_back(value.isMeasured ? value.ratio : none);
        }
        tables.rows.add(cells);
        if (row.source == JunctionSource::Graph)
            worst = std::max(worst, row.measures.worstRatio());
    }
    for (std::size_t c = 0; c < junctionCriteria; ++c) {
        const CriterionSummary& summary = report.criteria[c];
        tables.criteria.add({blend, criterionNames[c], std::int64_t{summary.measured},
                             std::int64_t{summary.good}, summary.median, summary.ninetieth,
                             summary.greatest});
    }
    tables.criteria.add(
        {blend, "all", std::int64_t{report.drawn}, std::int64_t{report.good}, none, none, worst});
    for (std::size_t p = 0; p < junctionPredictors; ++p) {
        const PredictorSummary& summary = report.predictors[p];
        std::vector<TableBuilder::Cell> cells{blend,
                                              predictorNames[p],
                                              std::ssize(report.rows),
                                              std::int64_t{report.bad},
                                              summary.rankCorrelation.value_or(none),
                                              summary.area.value_or(none)};
        for (const std::optional<double>& area : summary.areas)
            cells.emplace_back(area.value_or(none));
        tables.predictors.add(cells);
    }
}

} // namespace

BuildStep table2Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    constexpr int usualCount = 10;
    constexpr std::int64_t enough = 1'000'000'000; // expansions, to the end of the exact search
    const int count = static_cast<int>(evaluation.count.value_or(usualCount));
    const auto seed = static_cast<std::uint64_t>(evaluation.seed);
    const auto sequences = evaluation.sequences.empty() ? work.sequences : evaluation.sequences;
    BuildStep step = evaluationStep(work, evaluation);
    step.settings = jsonLine({count, seed, sequences, work.sequences, work.graph.alpha});
    step.inputs = CharacterGraph::inputs(work);
    step.compute = [=](const StepContext& context, const Progress& progress) {
        const CharacterGraph graph(work, context);
        const std::vector<WalkSpan> spans = spansOf(graph, sequences);
        std::int64_t duration = 0;
        for (const WalkSpan& span : spans)
            duration += span.frameCount();
        WalkConstraints constraints;
        constraints.keys = drawKeys(connectedFrames(graph.graph(), spans), count, duration, seed);
        const WalkMaterial material = graph.material({}, false);
        KeyTables tables = keyTables();
        addWalk(tables, "pairs", graph, constraints.keys,
                findWalk(material, constraints, {.budget = enough}, progress.part(0, 0.5)));
        addWalk(
            tables, "global", graph, constraints.keys,
            findWalk(material, constraints, {.budget = enough, .globalKeys = true}, progress.part(0.5, 1)));
        Result result;
        result.tables = {std::move(tables.keys).table(), std::move(tables.summary).table()};
        return result;
    };
    return step;
}

BuildStep junctionsStep(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    constexpr int usualCount = 200;
    const int count = static_cast<int>(evaluation.count.value_or(usualCount));
    const auto seed = static_cast<std::uint32_t>(evaluation.seed);
    const double fps = work.opener->project().settings.fps;
    BuildStep step = evaluationStep(work, evaluation);
    step.version = 9;
    step.settings = work.settings + jsonLine({count, seed, fps, work.sequences});
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = CharacterGraph::inputs(work);
    step.compute = [=](const StepContext& context, const Progress& progress) {
        const CharacterGraph graph(work, context);
        const CharacterFrames character = work.open(progress.part(0, 0.05));
        const Table<float> steps = graph.steps();
        const TransitionTable transitions =
            transitionTableOf(*context.resultOf(work.stepName(graphstep::transitions)));
        const Table<float> accelerations = accelerationDifferences(character, fps, progress.part(0.05, 0.4));
        const JunctionInputs inputs{.character = character,
                                    .roots = graph.roots(),
                                    .distances = steps,
                                    .accelerations = accelerations,
                                    .transitions = transitions,
                                    .settings = transitionSettings(work.graph, fps),
                                    .graph = graph.graph(),
                                    .costs = graph.costs(),
                                    .alpha = graph.alpha()};
        JunctionTables tables = junctionTables(work.graph.pose.metric == PoseMetric::Surface ? "rad" : "m",
                                               unitText(work.opener->project().settings.axes.metresPerUnit));
        JunctionOptions options{.count = count, .minima = count, .seed = seed};
        const auto judge = [&](const char* name, const Progress& part) {
            addReport(tables, name, graph, judgeJunctions(inputs, options, part));
        };
        judge("paper", progress.part(0.4, 0.5));
        options.blend = BlendSettings::gentle();
        judge("gentle", progress.part(0.5, 0.7));
        options.correction.emplace();
        judge("gentle-corrected", progress.part(0.7, 1));
        Result result;
        result.tables = {std::move(tables.rows).table(), std::move(tables.criteria).table(),
                         std::move(tables.predictors).table()};
        return result;
    };
    return step;
}

} // namespace quadrille
