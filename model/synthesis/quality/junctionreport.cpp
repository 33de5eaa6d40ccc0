// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/quality/junctionreport.h"

#include "model/core/badargument.h"
#include "model/core/ranks.h"
#include "model/graph/motiongraph.h"
#include "model/transition/acceleration.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <iterator>
#include <random>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

JunctionRow rowOf(const JunctionInputs& inputs, JunctionSource source, const Transition& transition,
                  JunctionMeasures measures)
{
    JunctionRow row{.frames = transition.frames,
                    .source = source,
                    .length = transition.length(),
                    .sourceWindow = transition.sourceWindow,
                    .destinationWindow = transition.destinationWindow,
                    .measures = measures};
    double sum = 0;
    for (const FramePair& cell : transition.path)
        sum += static_cast<double>(inputs.distances(cell.source, cell.destination));
    const double mean = sum / transition.length();
    const auto set = [&row](JunctionPredictor predictor, double value) {
        row.predictors[static_cast<std::size_t>(predictor)] = value;
    };
    set(JunctionPredictor::Sum, sum);
    set(JunctionPredictor::Mean, mean);
    set(JunctionPredictor::Acceleration, accelerationCost(inputs.accelerations, transition));
    const auto [i, j] = transition.frames;
    set(JunctionPredictor::Weight, inputs.costs.weight(i, j, inputs.alpha));
    set(JunctionPredictor::Cost, static_cast<double>(inputs.costs.cost()(i, j)));
    return row;
}

std::vector<FramePair> transitionsOf(const Digraph& graph)
{
    std::vector<FramePair> pairs;
    for (const Edge& edge : graph.edges()) {
        if (edge.kind == EdgeKind::Transition)
            pairs.push_back({edge.from, edge.to});
    }
    return pairs;
}

std::vector<FramePair> minimaBeside(const JunctionInputs& inputs)
{
    std::vector<FramePair> minima = costMinima(inputs.costs);
    std::erase_if(minima, [&](const FramePair& pair) {
        return inputs.graph.find(pair.source, pair.destination) != nullptr;
    });
    return minima;
}

CriterionSummary summaryOf(std::span<const JunctionRow> rows, std::size_t criterion)
{
    CriterionSummary summary;
    std::vector<double> ratios;
    for (const JunctionRow& row : rows) {
        const JunctionValue& value = row.measures.values[criterion];
        if (!value.isMeasured)
            continue;
        ratios.push_back(value.ratio);
        summary.good += value.isGood() ? 1 : 0;
    }
    summary.measured = static_cast<int>(ratios.size());
    summary.median = quantile(ratios, 0.5);
    summary.ninetieth = quantile(ratios, 0.9);
    summary.greatest = quantile(ratios, 1);
    return summary;
}

PredictorSummary summaryOf(std::span<const JunctionRow> rows, JunctionPredictor predictor)
{
    std::vector<double> scores;
    std::vector<double> worst;
    std::vector<bool> isBad;
    for (const JunctionRow& row : rows) {
        scores.push_back(row.predictors[static_cast<std::size_t>(predictor)]);
        worst.push_back(row.measures.worstRatio());
        isBad.push_back(!row.measures.isGood());
    }
    PredictorSummary summary{.rankCorrelation = rankCorrelation(scores, worst),
                             .area = areaUnderCurve(scores, isBad),
                             .areas = {}};
    for (std::size_t criterion = 0; criterion < junctionCriteria; ++criterion) {
        std::vector<double> measured;
        std::vector<bool> isBadHere;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const JunctionValue& value = rows[i].measures.values[criterion];
            if (!value.isMeasured)
                continue;
            measured.push_back(scores[i]);
            isBadHere.push_back(!value.isGood());
        }
        summary.areas[criterion] = areaUnderCurve(measured, isBadHere);
    }
    return summary;
}

} // namespace

std::vector<FramePair> drawPairs(std::vector<FramePair> pairs, int count, std::uint32_t seed)
{
    assert(count >= 0);
    std::mt19937 random(seed);
    std::vector<FramePair> drawn;
    auto wanted = std::min(static_cast<std::size_t>(count), pairs.size());
    for (std::size_t i = 0; i < pairs.size() && wanted > 0; ++i) {
        // Each of the rest is as likely to be among those that are still wanted.
        const std::uint64_t rest = pairs.size() - i;
        if (std::uint64_t{random()} * rest >> 32U < wanted) {
            drawn.push_back(pairs[i]);
            --wanted;
        }
    }
    return drawn;
}

JunctionReport judgeJunctions(const JunctionInputs& inputs, const JunctionOptions& options,
                              const Progress& progress)
{
    if (options.count < 0 || options.minima < 0 || options.context < 0)
        refuse("Numbers of transitions and of frames around them cannot be negative",
               "Give numbers from 0 upwards.");
    if (inputs.roots.supports.size() != static_cast<std::size_t>(inputs.character.frameCount()))
        refuse("It is not known which vertices stand on the ground", "Find the supports first.");
    std::vector<FramePair> pairs = drawPairs(transitionsOf(inputs.graph), options.count, options.seed);
    const std::size_t drawn = pairs.size();
    std::ranges::copy(drawPairs(minimaBeside(inputs), options.minima, options.seed),
                      std::back_inserter(pairs));
    const std::vector<FrameMeasure> measures =
        frameMeasures(inputs.character, inputs.roots.supports, inputs.roots.up, progress.part(0, 0.1));
    const JunctionJudge judge(inputs.character, inputs.roots, measures, options.limits, options.context);
    const WarpPaths paths(inputs.distances, inputs.character.layout(), inputs.settings);
    JunctionReport report;
    report.rows.resize(pairs.size());
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
        const std::optional<Transition> transition = paths.of(inputs.transitions, pairs[i]);
        assert(transition);
        report.rows[i] =
            rowOf(inputs, i < drawn ? JunctionSource::Graph : JunctionSource::Minima, *transition,
                  judge.judge(*transition, options.blend, options.method, options.correction));
        progress.part(0.1, 1).report(++done, static_cast<std::int64_t>(pairs.size()));
    });
    const auto ofGraph = std::span<const JunctionRow>(report.rows).first(drawn);
    const auto isGood = [](const JunctionRow& row) { return row.measures.isGood(); };
    report.drawn = static_cast<int>(drawn);
    report.good = static_cast<int>(std::ranges::count_if(ofGraph, isGood));
    report.bad = static_cast<int>(std::ssize(report.rows) - std::ranges::count_if(report.rows, isGood));
    for (std::size_t c = 0; c < junctionCriteria; ++c)
        report.criteria[c] = summaryOf(ofGraph, c);
    for (std::size_t p = 0; p < junctionPredictors; ++p)
        report.predictors[p] = summaryOf(report.rows, static_cast<JunctionPredictor>(p));
    progress.report(1.0);
    return report;
}

} // namespace quadrille
