// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/generalisation.h"
#include "model/project/evaluations/appearanceevaluations.h"
#include "model/project/evaluations/picturemeasure.h"
#include "model/project/json/jsonline.h"
#include "model/project/store/tablebuilder.h"

#include <cmath>

namespace quadrille {

namespace {

constexpr std::int64_t usualDraws = 5;
constexpr std::array learnedFractions{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};

struct Spread
{
    double mean = 0;
    double deviation = 0; ///< standard, over draws
};

Spread spreadOf(const std::vector<AppearanceErrors>& draws, PictureQuality AppearanceErrors::*domain,
                double PictureQuality::*value)
{
    Spread spread;
    const auto count = static_cast<double>(draws.size());
    for (const AppearanceErrors& each : draws)
        spread.mean += (each.*domain).*value / count;
    for (const AppearanceErrors& each : draws)
        spread.deviation += std::pow((each.*domain).*value - spread.mean, 2) / count;
    spread.deviation = std::sqrt(spread.deviation);
    return spread;
}

Result generalisationResult(const std::string& name, const std::vector<GeneralisationRow>& rows,
                            const PictureMeasure& measure)
{
    TableBuilder table(
        name, "How well textures that were left out are restored by spaces learned from some of the textures "
              "(SMCAS Fig. 19 and 20): aligned textures and warps projected on all their Eigen textures and "
              "Eigen warps, beside principal components of the textures as they are. Means over draws, each "
              "over what it left out, and standard deviations over draws.");
    table.real("fraction").whole("training").whole("draws");
    const std::array domains{&AppearanceErrors::texture, &AppearanceErrors::image};
    for (const char* domain : {"texture_", "image_"}) {
        for (const char* way : {"", "_naive"}) {
            std::string column(domain);
            column.append(measure.name).append(way);
            table.real(column, measure.unit);
            table.real(column.append("_deviation"), measure.unit);
        }
    }
    for (const GeneralisationRow& row : rows) {
        std::vector<TableBuilder::Cell> cells{row.fraction, row.training, std::ssize(row.own)};
        for (const auto domain : domains) {
            for (const auto* draws : {&row.own, &row.naive}) {
                const Spread spread = spreadOf(*draws, domain, measure.value);
                cells.insert(cells.end(), {spread.mean, spread.deviation});
            }
        }
        table.add(cells);
    }
    Result result;
    result.tables = {std::move(table).table()};
    return result;
}

std::vector<GeneralisationRow> generalisationOf(const AppearanceInputs& inputs,
                                                const GeneralisationSettings& settings,
                                                const StepContext& context, const Progress& progress)
{
    constexpr std::int64_t fewestTextures = 4;
    constexpr std::int64_t picturesOfADraw = 12;
    const auto measured = measuredAppearance(inputs, fewestTextures, progress.part(0, 0.01));
    AppearanceSubject subject = measured->subject;
    subject.pictures = picturesOfADraw;
    const auto alignment =
        alignmentOf(inputs, *measured, *context.resultOf(inputs.modelStep()), progress.part(0.01, 0.1));
    return appearanceGeneralisation(subject, alignment.get(), settings, progress.part(0.1, 1));
}

} // namespace

BuildStep generalisationStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    const GeneralisationSettings settings{.fractions = {learnedFractions.begin(), learnedFractions.end()},
                                          .draws = evaluation.count.value_or(usualDraws),
                                          .seed = static_cast<std::uint64_t>(evaluation.seed)};
    BuildStep step = appearanceStep(inputs, evaluation);
    step.settings = jsonLine(
        {static_cast<int>(inputs.work.opener->project().settings.axes.up), settings.draws, settings.seed});
    step.compute = [=, text = step.settings](const StepContext& context, const Progress& progress) {
        // Both figures are of one computation.
        const auto rows = context.shared<const std::vector<GeneralisationRow>>(
            {inputs.modelStep()}, "generalisation" + text, [&] {
                return std::make_shared<const std::vector<GeneralisationRow>>(
                    generalisationOf(inputs, settings, context, progress));
            });
        return generalisationResult(evaluation.table, *rows, pictureMeasureOf(evaluation.table));
    };
    return step;
}

} // namespace quadrille
