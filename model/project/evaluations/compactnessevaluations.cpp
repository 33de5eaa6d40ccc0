// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/compactness.h"
#include "model/project/evaluations/appearanceevaluations.h"
#include "model/project/evaluations/picturemeasure.h"
#include "model/project/json/jsonline.h"
#include "model/project/store/tablebuilder.h"

#include <limits>

namespace quadrille {

namespace {

constexpr std::int64_t usualCameras = 4;

Result compactnessResult(const std::string& name, const std::vector<CompactnessRow>& rows,
                         const PictureMeasure& measure)
{
    TableBuilder table(
        name,
        "How well Eigen textures and Eigen warps restore the textures that they are learned from, by "
        "their number, beside naive principal components of the textures as they are (SMCAS Fig. 17 and "
        "18): mean over all textures, in the texture's covered texels and over silhouettes seen from "
        "cameras around the body.");
    table.whole("components").whole("warps");
    TableBuilder crossings(name + "-crossover",
                           "From how many components on naive ones are better, in between where the lines "
                           "cross; none where they are not.");
    crossings.text("domain").real("components");
    std::vector<double> components;
    components.reserve(rows.size());
    for (const CompactnessRow& row : rows)
        components.push_back(static_cast<double>(row.components));
    const std::array domains{std::pair("texture", &AppearanceErrors::texture),
                             std::pair("image", &AppearanceErrors::image)};
    for (const auto& [domain, member] : domains) {
        const std::string column = domain + ("_" + measure.name);
        table.real(column, measure.unit).real(column + "_naive", measure.unit);
        std::vector<double> gains;
        gains.reserve(rows.size());
        for (const CompactnessRow& row : rows)
            gains.push_back(measure.sign *
                            ((row.own.*member).*measure.value - (row.naive.*member).*measure.value));
        crossings.add({std::string(domain),
                       crossover(components, gains).value_or(std::numeric_limits<double>::quiet_NaN())});
    }
    for (const CompactnessRow& row : rows)
        table.add({row.components, row.warps, row.own.texture.*measure.value,
                   row.naive.texture.*measure.value, row.own.image.*measure.value,
                   row.naive.image.*measure.value});
    Result result;
    result.tables = {std::move(table).table(), std::move(crossings).table()};
    return result;
}

std::vector<CompactnessRow> compactnessOf(const AppearanceInputs& inputs, std::int64_t cameras,
                                          const StepContext& context, const Progress& progress)
{
    constexpr std::int64_t fewestTextures = 3;
    const auto measured = measuredAppearance(inputs, fewestTextures, progress.part(0, 0.01));
    AppearanceSubject subject = measured->subject;
    subject.cameras = static_cast<int>(cameras);
    const ResultPointer model = context.resultOf(inputs.modelStep());
    const auto alignment = alignmentOf(inputs, *measured, *model, progress.part(0.01, 0.1));
    return appearanceCompactness(subject, alignment.get(), componentCounts(subject.textures.count),
                                 inputs.appearance.options().textureShare, progress.part(0.1, 1));
}

} // namespace

BuildStep compactnessStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    const std::int64_t cameras = evaluation.count.value_or(usualCameras);
    BuildStep step = appearanceStep(inputs, evaluation);
    step.settings = jsonLine({static_cast<int>(inputs.work.opener->project().settings.axes.up), cameras});
    step.compute = [=, text = step.settings](const StepContext& context, const Progress& progress) {
        // Both figures are of one computation.
        const auto rows = context.shared<const std::vector<CompactnessRow>>(
            {inputs.modelStep()}, "compactness" + text, [&] {
                return std::make_shared<const std::vector<CompactnessRow>>(
                    compactnessOf(inputs, cameras, context, progress));
            });
        return compactnessResult(evaluation.table, *rows, pictureMeasureOf(evaluation.table));
    };
    return step;
}

} // namespace quadrille
