// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/appearancefile.h"
#include "model/core/message.h"
#include "model/core/random.h"
#include "model/evaluation/compactness.h"
#include "model/evaluation/textureblends.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/evaluations/appearanceevaluations.h"
#include "model/project/json/jsonline.h"
#include "model/project/store/tablebuilder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace quadrille {

namespace {

constexpr std::int64_t usualBlends = 20;

/// Draws some of these, in their order.
template <typename Value>
std::vector<Value> drawn(std::vector<Value> values, std::int64_t count, Random& random)
{
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for (std::size_t i = 0; i < values.size(); ++i)
        order.emplace_back(random.next(), i);
    std::ranges::sort(order);
    order.resize(std::min(order.size(), static_cast<std::size_t>(count)));
    std::ranges::sort(order, {}, [](const auto& each) { return each.second; });
    std::vector<Value> some;
    some.reserve(order.size());
    for (const auto& [key, index] : order)
        some.push_back(values[index]);
    return some;
}

std::vector<std::array<std::int64_t, 2>> drawnPairs(std::int64_t textures, std::int64_t count,
                                                    std::uint64_t seed)
{
    Random random(seed);
    std::set<std::array<std::int64_t, 2>> pairs;
    const std::int64_t all = textures * (textures - 1) / 2;
    const auto below = [&](std::int64_t limit) {
        return static_cast<std::int64_t>(random.unit() * static_cast<double>(limit));
    };
    while (std::ssize(pairs) < std::min(count, all)) {
        const std::int64_t second = 1 + below(textures - 1);
        pairs.insert({below(second), second});
    }
    return {pairs.begin(), pairs.end()};
}

/// A middle with the frame that it is.
struct NamedMiddle
{
    MiddleTexture textures;
    AppearanceRow row;
};

/// All captured frames between two that are some frames away, each with a texture of its own.
std::vector<NamedMiddle> middlesAt(const std::vector<AppearanceRow>& rows, std::int64_t distance)
{
    std::map<std::pair<std::string, FrameIndex>, std::int64_t> textures;
    for (const AppearanceRow& row : rows)
        textures[{row.sequence, row.frame}] = row.row;
    std::vector<NamedMiddle> middles;
    for (const AppearanceRow& row : rows) {
        const auto before = textures.find({row.sequence, FrameIndex(row.frame.value - distance)});
        const auto after = textures.find({row.sequence, FrameIndex(row.frame.value + distance)});
        if (before != textures.end() && after != textures.end() && before->second != row.row &&
            after->second != row.row && before->second != after->second)
            middles.push_back({{before->second, row.row, after->second}, row});
    }
    return middles;
}

/// Both tables of appearance-interpolation.
class MiddleTables
{
public:
    MiddleTables()
    {
        m_means.whole("apart", "frame").whole("frames");
        m_frames.whole("apart", "frame").text("sequence").whole("frame", "frame");
        for (TableBuilder* table : {&m_means, &m_frames}) {
            table->real("rms", "grey level").real("rms_linear", "grey level").real("rms_ratio");
            table->real("ssim").real("ssim_linear");
        }
    }

    void add(std::int64_t distance, const std::vector<NamedMiddle>& middles,
             const std::vector<MiddleErrors>& errors)
    {
        std::array<double, 4> sums{};
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const auto [model, linear] = errors[i];
            const double own = std::sqrt(model.meanSquaredError);
            const double other = std::sqrt(linear.meanSquaredError);
            m_frames.add({distance, middles[i].row.sequence, middles[i].row.frame.value, own, other,
                          own / other, model.similarity, linear.similarity});
            sums[0] += own;
            sums[1] += other;
            sums[2] += model.similarity;
            sums[3] += linear.similarity;
        }
        const auto count = static_cast<double>(middles.size());
        m_means.add({distance, std::ssize(middles), sums[0] / count, sums[1] / count, sums[0] / sums[1],
                     sums[2] / count, sums[3] / count});
    }

    Result result() &&
    {
        Result result;
        result.tables = {std::move(m_means).table(), std::move(m_frames).table()};
        return result;
    }

private:
    TableBuilder m_means{"appearance-interpolation",
                         "Textures midway between two captured ones, by the model as clips have them and by "
                         "blending both, against the texture that was captured in the middle, `apart` "
                         "frames from each: errors over covered texels, mean over frames."};
    TableBuilder m_frames{"appearance-interpolation-frames", "The same, frame by frame."};
};

} // namespace

BuildStep fig22Step(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    const std::int64_t count = evaluation.count.value_or(usualBlends);
    const auto seed = static_cast<std::uint64_t>(evaluation.seed);
    BuildStep step = appearanceStep(inputs, evaluation);
    step.settings = jsonLine({count, seed});
    step.compute = [=](const StepContext& context, const Progress& progress) {
        constexpr std::int64_t fewestTextures = 3;
        const auto measured = measuredAppearance(inputs, fewestTextures, progress.part(0, 0.02));
        const auto alignment =
            alignmentOf(inputs, *measured, *context.resultOf(inputs.modelStep()), progress.part(0.02, 0.3));
        const std::int64_t textures = measured->subject.textures.count;
        const auto rows =
            blendReduction(measured->subject, alignment.get(), drawnPairs(textures, count, seed),
                           componentCounts(textures), progress.part(0.3, 1));
        TableBuilder table("fig22", "How near textures midway between two frames come, with some Eigen "
                                    "textures, to those with all of them, warps with all Eigen warps "
                                    "(SMCAS Fig. 22): over covered texels, mean over pairs of frames.");
        table.whole("textures").real("ssim").real("mse", "grey level²");
        for (const BlendReductionRow& row : rows)
            table.add({row.textures, row.quality.similarity, row.quality.meanSquaredError});
        Result result;
        result.tables = {std::move(table).table()};
        return result;
    };
    return step;
}

BuildStep appearanceInterpolationStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation)
{
    const std::int64_t count = evaluation.count.value_or(usualBlends);
    const auto seed = static_cast<std::uint64_t>(evaluation.seed);
    BuildStep step = appearanceStep(inputs, evaluation);
    step.settings = jsonLine({count, seed});
    step.compute = [=](const StepContext& context, const Progress& progress) {
        constexpr std::int64_t fewestTextures = 3;
        constexpr std::array<std::int64_t, 4> distances{1, 2, 4, 8};
        const auto measured = measuredAppearance(inputs, fewestTextures, progress.part(0, 0.05));
        const AppearanceDecoder decoder(std::make_shared<const AppearanceModel>(readAppearanceFile(
            modelFileOf(*context.resultOf(inputs.modelStep()), inputs.work.opener->folder()))));
        MiddleTables tables;
        Random random(seed);
        bool isAny = false;
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const auto middles = drawn(middlesAt(measured->training.rows, distances[i]), count, random);
            if (middles.empty())
                continue;
            isAny = true;
            std::vector<MiddleTexture> textures;
            textures.reserve(middles.size());
            for (const NamedMiddle& middle : middles)
                textures.push_back(middle.textures);
            const double from = 0.05 + 0.95 * static_cast<double>(i) / distances.size();
            tables.add(distances[i], middles,
                       middleErrors(measured->subject.textures, decoder, textures,
                                    progress.part(from, from + 0.95 / distances.size())));
        }
        if (!isAny)
            throwInvalid("No sequence that “" + inputs.appearance.entry.name +
                             "” learns from has three frames with textures of their own",
                         QUADRILLE_MESSAGE("Give it sequences with more frames."));
        return std::move(tables).result();
    };
    return step;
}

} // namespace quadrille
