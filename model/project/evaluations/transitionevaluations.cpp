// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/comparison.h"
#include "model/project/document/lengthunit.h"
#include "model/project/evaluations/evaluationsteps.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/graphtables.h"
#include "model/transition/acceleration.h"
#include "model/transition/transitioncomparison.h"

namespace quadrille {

namespace {

constexpr auto fig7Note =
    "Transitions of all pairs of frames as in SMCAS Fig. 7, mean and standard deviation; surface and "
    "acceleration costs in units of the largest of a linear transition.";
constexpr auto fig9Note = "Shortest paths in the Essential graph and in the motion graph as in SMCAS Fig. 9.";
constexpr auto fig9EqualNote =
    "The same with as many edges in both graphs, and over the pairs with a path in both (common).";

const char* nameOf(TransitionKind kind)
{
    switch (kind) {
    case TransitionKind::Linear:
        return "linear";
    case TransitionKind::Warped:
        return "dtw";
    case TransitionKind::VaryingLengths:
        return "dtw+vls";
    }
    return "";
}

Result fig7Result(const TransitionComparison& comparison, const std::string& unit,
                  const std::string& accelerationUnit)
{
    TableBuilder table("fig7", fig7Note);
    table.text("transition").whole("slope").real("surface").real("surface-deviation");
    table.real("acceleration").real("acceleration-deviation");
    table.real("surface-per-frame", unit).real("surface-per-frame-deviation", unit);
    table.real("length", "frame").real("length-deviation", "frame");
    for (const TransitionVariant& row : comparison.variants)
        table.add({nameOf(row.kind), std::int64_t{row.slope}, row.surface.mean, row.surface.deviation,
                   row.acceleration.mean, row.acceleration.deviation, row.surfacePerFrame.mean,
                   row.surfacePerFrame.deviation, row.length.mean, row.length.deviation});
    TableBuilder scale("fig7-scale", "What the costs of fig7 are counted over, and their units.");
    scale.whole("pairs")
        .real("largest-linear-cost", unit)
        .real("largest-linear-acceleration", accelerationUnit);
    scale.add({comparison.pairs, comparison.largestLinearCost, comparison.largestLinearAcceleration});
    Result result;
    result.tables = {std::move(table).table(), std::move(scale).table()};
    return result;
}

} // namespace

BuildStep fig7Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    const double fps = work.opener->project().settings.fps;
    TransitionSettings settings = transitionSettings(work.graph, fps);
    BuildStep step = evaluationStep(work, evaluation);
    step.settings = work.settings + jsonLine({fps, settings.shortest(), settings.longest(),
                                              settings.cost == TransitionCost::Sum ? "sum" : "mean"});
    step.files = [work](const Progress& progress) { return work.files(progress); };
    step.inputs = {work.stepName(graphstep::poseDistance)};
    step.compute = [=](const StepContext& context, const Progress& progress) {
        const auto poses = context.resultOf(step.inputs.front());
        const Table<float> accelerations =
            accelerationDifferences(work.open(progress.part(0, 0.05)), fps, progress.part(0.05, 0.4));
        return fig7Result(compareTransitions(tableOf<float>(poses->arrays.front()), layoutOf(*poses),
                                             settings, accelerations, progress.part(0.4, 1)),
                          poses->arrays.front().unit,
                          unitText(work.opener->project().settings.axes.metresPerUnit) + "/s²");
    };
    return step;
}

namespace {

Result fig9Result(const std::vector<GraphComparison>& rows, const FrameLayout& layout,
                  const std::vector<std::string>& sequences)
{
    TableBuilder own = statisticsTable("fig9", fig9Note);
    TableBuilder equal("fig9-equal-density", fig9EqualNote);
    equal.text("graph").real("alpha").whole("edges").real("density").real("mean-cost");
    equal.real("cost-deviation").whole("unreachable-pairs").whole("common-pairs").real("common-mean-cost");
    TableBuilder components = componentTable("fig9-components");
    for (const GraphComparison& row : rows) {
        const auto addEqual = [&](const char* graph, const GraphStatistics& statistics, double commonMean) {
            equal.add({graph, row.alpha, statistics.edges, statistics.density, statistics.pathCosts.mean,
                       statistics.pathCosts.standardDeviation, statistics.pathCosts.unreachablePairs,
                       row.commonPairs, commonMean});
        };
        addStatistics(own, "motion", row.alpha, row.motion);
        addStatistics(own, "essential", row.alpha, row.essential);
        addEqual("motion", row.motionAtEqualDensity, row.motionMeanOverCommonPairs);
        addEqual("essential", row.essentialAtEqualDensity, row.essentialMeanOverCommonPairs);
        addComponents(components, "motion", row.alpha, row.motion.connectivity, layout, sequences);
        addComponents(components, "essential", row.alpha, row.essential.connectivity, layout, sequences);
    }
    Result result;
    result.tables = {std::move(own).table(), std::move(equal).table(), std::move(components).table()};
    return result;
}

} // namespace

BuildStep fig9Step(const CharacterInputs& work, const EvaluationEntry& evaluation)
{
    std::vector<double> alphas = evaluation.alphas;
    if (alphas.empty())
        alphas.assign(figure9Alphas.begin(), figure9Alphas.end());
    BuildStep step = evaluationStep(work, evaluation);
    step.settings =
        jsonLine({alphas, costSettings(work.graph), work.sequences, static_cast<int>(work.graph.smoothing)});
    step.inputs = costInputs(work);
    step.compute = [=](const StepContext& context, const Progress& progress) {
        const auto shared = costsOf(work, context);
        const TransitionCosts& costs = *shared;
        const auto minima = costMinima(costs, work.graph.smoothing, progress.part(0, 0.05));
        return fig9Result(sweepAlpha(costs, minima, alphas, progress.part(0.05, 1)), costs.layout(),
                          work.sequences);
    };
    return step;
}

} // namespace quadrille
