// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/appearancerates.h"
#include "model/project/evaluations/appearanceevaluations.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

constexpr std::array<std::int64_t, 6> ratedComponents{5, 10, 20, 30, 50, 100};
constexpr std::array ratedQualities{10, 20, 30, 50, 70, 85, 95};
constexpr std::array ratedQuantizers{44, 38, 32, 26, 20, 16, 10};
constexpr std::array ratedSimilarities{0.9, 0.92, 0.94, 0.95, 0.96, 0.97, 0.98, 0.99};
constexpr std::array rateKinds{"model", "jpeg", "h264"};

/// The textures as they were captured, where all of them are files.
std::vector<AppearanceRate> capturedRate(const AppearanceTraining& training)
{
    AppearanceRate rate{.kind = "captured"};
    for (const Texture& texture : training.textures) {
        if (texture.file.empty())
            return {};
        rate.bytes += std::filesystem::file_size(texture.file);
    }
    return {rate};
}

DataTable ratesTable(const std::vector<AppearanceRate>& rates, std::int64_t textures)
{
    TableBuilder table(
        "appearance-rates",
        "What textures take on disk, and how near they come to the captured ones: files of models with some "
        "number of components, JPEG pictures of some quality, and a film by H.264 with some quantizer; over "
        "covered texels, mean over all textures.");
    table.text("kind").whole("setting").real("bytes_per_frame", "byte").whole("bytes", "byte");
    table.real("ssim").real("mse", "grey level²");
    for (const AppearanceRate& rate : rates)
        table.add({rate.kind, rate.setting, static_cast<double>(rate.bytes) / static_cast<double>(textures),
                   static_cast<std::int64_t>(rate.bytes), rate.quality.similarity,
                   rate.quality.meanSquaredError});
    return std::move(table).table();
}

DataTable leastTable(const std::vector<AppearanceRate>& rates, std::int64_t textures)
{
    TableBuilder table("appearance-rates-least",
                       "Bytes per frame of each kind for an SSIM, between the settings that were tried, and "
                       "the kind that takes the least; none where no setting is as good.");
    table.real("ssim");
    for (const char* kind : rateKinds)
        table.real(kind, "byte");
    table.text("least");
    for (const double similarity : ratedSimilarities) {
        std::vector<TableBuilder::Cell> cells{similarity};
        std::string least;
        double fewest = std::numeric_limits<double>::infinity();
        for (const char* kind : rateKinds) {
            const auto bytes = bytesAt(rates, kind, similarity);
            cells.emplace_back(bytes ? *bytes / static_cast<double>(textures)
                                     : std::numeric_limits<double>::quiet_NaN());
            if (bytes && *bytes < fewest) {
                fewest = *bytes;
                least = kind;
            }
        }
        cells.emplace_back(least);
        table.add(cells);
    }
    return std::move(table).table();
}

} // namespace

BuildStep appearanceRatesStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    BuildStep step = appearanceStep(inputs, evaluation);
    step.compute = [=](const StepContext& context, const Progress& progress) {
        constexpr std::int64_t fewestTextures = 3;
        const auto measured = measuredAppearance(inputs, fewestTextures, progress.part(0, 0.01));
        const AppearanceSubject& subject = measured->subject;
        const auto alignment =
            alignmentOf(inputs, *measured, *context.resultOf(inputs.modelStep()), progress.part(0.01, 0.1));
        std::vector<std::int64_t> components(ratedComponents.begin(), ratedComponents.end());
        std::erase_if(components, [&](std::int64_t count) { return count >= subject.textures.count; });
        if (components.empty())
            components = {subject.textures.count - 1};
        std::vector<AppearanceRate> rates = capturedRate(measured->training);
        const auto add = [&](const std::vector<AppearanceRate>& more) {
            rates.insert(rates.end(), more.begin(), more.end());
        };
        add(modelRates(subject, alignment.get(), measured->frames, components,
                       inputs.appearance.options().textureShare, progress.part(0.1, 0.6)));
        add(jpegRates(subject, ratedQualities, progress.part(0.6, 0.8)));
        add(filmRates(subject, ratedQuantizers, progress.part(0.8, 1)));
        Result result;
        result.tables = {ratesTable(rates, subject.textures.count),
                         leastTable(rates, subject.textures.count)};
        return result;
    };
    return step;
}

} // namespace quadrille
