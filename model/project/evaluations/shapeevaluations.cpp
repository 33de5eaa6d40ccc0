// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/appearancefile.h"
#include "model/core/message.h"
#include "model/evaluation/shapeappearance.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/evaluations/appearanceevaluations.h"
#include "model/project/json/jsonline.h"
#include "model/project/steps/appearanceposes.h"
#include "model/project/store/tablebuilder.h"

namespace quadrille {

namespace {

constexpr std::int64_t usualShapes = 10;

DataTable shapeTable(const std::vector<std::string>& names, const std::vector<LeftOutTake>& takes)
{
    TableBuilder table(
        "appearance-shape",
        "Textures of the poses of a take, from those of the other takes: of the captured frame "
        "with the nearest pose, the mean of all, and learned from poses. Root mean square "
        "errors of coefficients over all frames; SSIM and mean squared error over covered "
        "texels of some frames.");
    table.text("take").whole("frames");
    for (const char* way : {"nearest", "mean", "learned"})
        table.real(std::string("rms_") + way, "grey level");
    for (const char* way : {"nearest", "mean", "learned"})
        table.real(std::string("warp_rms_") + way, "texel");
    for (const char* way : {"nearest", "mean", "learned"})
        table.real(std::string("ssim_") + way);
    for (const char* way : {"nearest", "mean", "learned"})
        table.real(std::string("mse_") + way, "grey level²");
    for (std::size_t t = 0; t < takes.size(); ++t) {
        const auto& [frames, scales, nearest, mean, learned] = takes[t];
        table.add({names[t], frames, nearest.textures, mean.textures, learned.textures, nearest.warps,
                   mean.warps, learned.warps, nearest.picture.similarity, mean.picture.similarity,
                   learned.picture.similarity, nearest.picture.meanSquaredError,
                   mean.picture.meanSquaredError, learned.picture.meanSquaredError});
    }
    return std::move(table).table();
}

} // namespace

BuildStep appearanceShapeStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    const std::int64_t count = evaluation.count.value_or(usualShapes);
    BuildStep step = appearanceStep(inputs, evaluation);
    step.settings = jsonLine({count});
    step.compute = [=](const StepContext& context, const Progress& progress) {
        constexpr std::int64_t fewestTextures = 2;
        const auto measured = measuredAppearance(inputs, fewestTextures, progress.part(0, 0.05));
        KnownPoses known = knownPoses(*inputs.work.opener, measured->training.rows, progress.part(0.05, 0.2));
        if (known.names.size() < 2)
            throwInvalid("“" + inputs.appearance.entry.name +
                             "” learns from one take alone; none can be left out",
                         QUADRILLE_MESSAGE("Give it a second sequence with a texture for each frame."));
        const AppearanceDecoder decoder(std::make_shared<const AppearanceModel>(readAppearanceFile(
            modelFileOf(*context.resultOf(inputs.modelStep()), inputs.work.opener->folder()))));
        ShapeSubject subject{.places = std::move(known.places),
                             .takes = known.takes,
                             .source = measured->subject.textures,
                             .pictures = count};
        for (const AppearanceRow& row : known.rows)
            subject.textures.push_back(row.row);
        Result result;
        result.tables = {shapeTable(known.names, leftOutTakes(subject, decoder, progress.part(0.2, 1)))};
        return result;
    };
    return step;
}

} // namespace quadrille
