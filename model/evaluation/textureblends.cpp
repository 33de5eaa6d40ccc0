// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/textureblends.h"

#include "model/appearance/modeltextures.h"
#include "model/evaluation/combinedtextures.h"

#include <algorithm>

namespace quadrille {

namespace {

std::vector<float> meanWarp(const TextureAlignment& alignment, const std::array<std::int64_t, 2>& pair)
{
    std::vector<float> mean = alignment.backward(pair[0]);
    std::ranges::transform(mean, alignment.backward(pair[1]), mean.begin(),
                           [](float a, float b) { return (a + b) / 2; });
    return mean;
}

/// A column for each count and pair: the weights of both, midway, in the space of the first components.
Eigen::MatrixXd blendWeights(const SnapshotSpace& space, std::span<const std::array<std::int64_t, 2>> pairs,
                             std::span<const std::int64_t> counts)
{
    Eigen::MatrixXd weights;
    Eigen::Index column = 0;
    for (const std::int64_t count : counts) {
        const Eigen::MatrixXd restored = space.reconstructions(count);
        if (column == 0)
            weights.resize(restored.rows(), std::ssize(pairs) * std::ssize(counts));
        for (const auto& [first, second] : pairs)
            weights.col(column++) = (restored.col(first) + restored.col(second)) / 2;
    }
    return weights;
}

} // namespace

std::vector<BlendReductionRow> blendReduction(const AppearanceSubject& subject, TextureAlignment* alignment,
                                              std::span<const std::array<std::int64_t, 2>> pairs,
                                              std::span<const std::int64_t> counts, const Progress& progress,
                                              const Executor& executor)
{
    std::shared_ptr<TextureAlignment> captured;
    if (alignment == nullptr) {
        captured = gatherTextures(subject.textures, *subject.charts, {.scratchFolder = subject.scratchFolder},
                                  progress.part(0, 0.4), executor);
    } else {
        const LinearSpace warps = principalComponents(alignment->backwardSamples(), alignment->count(),
                                                      progress.part(0, 0.05), executor);
        realignTextures(subject.textures, *subject.charts, warps, *alignment, progress.part(0.05, 0.4),
                        executor);
    }
    const TextureAlignment& used = alignment == nullptr ? *captured : *alignment;
    const SnapshotSpace space(centredProducts(used.alignedSamples(), progress.part(0.4, 0.5), executor));
    std::vector<std::int64_t> withAll(counts.begin(), counts.end());
    withAll.push_back(space.components());
    const CombinedTextures blends(used.alignedSamples(), blendWeights(space, pairs, withAll),
                                  subject.scratchFolder, progress.part(0.5, 0.7), executor);
    const UsedTexels& texels = subject.charts->used();
    const Dealigner dealigner(texels, used.grid());
    std::vector<PictureQuality> qualities(pairs.size() * counts.size());
    executor.run(
        makeTasks<PictureQuality>(
            std::ssize(pairs),
            [&](std::int64_t pair, const Progress& own) {
                const std::vector<float> warp = meanWarp(used, pairs[static_cast<std::size_t>(pair)]);
                const auto blend = [&](std::int64_t count) {
                    return dealigner.dealigned(blends.colours(count * std::ssize(pairs) + pair), warp);
                };
                const Image whole = blend(std::ssize(counts));
                std::vector<PictureQuality> each;
                for (std::int64_t count = 0; count < std::ssize(counts); ++count) {
                    own.report(count, std::ssize(counts));
                    each.push_back(textureQuality(whole, blend(count), texels));
                }
                return each;
            },
            [&](std::int64_t pair, std::span<const PictureQuality> each) {
                std::ranges::copy(each, qualities.begin() + pair * std::ssize(counts));
            }),
        progress.part(0.7, 1));
    std::vector<BlendReductionRow> rows;
    for (std::size_t c = 0; c < counts.size(); ++c) {
        PictureQuality sum{.similarity = 0};
        for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
            sum.similarity += qualities[pair * counts.size() + c].similarity;
            sum.meanSquaredError += qualities[pair * counts.size() + c].meanSquaredError;
        }
        const auto all = static_cast<double>(pairs.size());
        rows.push_back({counts[c], {sum.similarity / all, sum.meanSquaredError / all}});
    }
    return rows;
}

std::vector<MiddleErrors> middleErrors(const TextureSource& textures, const AppearanceDecoder& decoder,
                                       std::span<const MiddleTexture> middles, const Progress& progress,
                                       const Executor& executor)
{
    std::vector<MiddleErrors> all(middles.size());
    executor.run(makeTasks<MiddleErrors>(
                     std::ssize(middles),
                     [&](std::int64_t task, const Progress& own) {
                         const MiddleTexture& each = middles[static_cast<std::size_t>(task)];
                         const auto before = textures.read(each.before);
                         const auto after = textures.read(each.after);
                         const auto truth = textures.read(each.middle);
                         const AppearanceModel& model = decoder.model();
                         own.report(0.2);
                         DecodeScratch scratch;
                         const Image blended = blendedTexture(
                             decoder, coefficientsOf(model, static_cast<std::size_t>(each.before)), *before,
                             coefficientsOf(model, static_cast<std::size_t>(each.after)), *after, 0.5,
                             scratch);
                         own.report(0.7);
                         return std::vector<MiddleErrors>{
                             {textureQuality(*truth, blended, model.texels),
                              textureQuality(*truth, mixedTexture(*before, *after, 0.5), model.texels)}};
                     },
                     [&](std::int64_t task, std::span<const MiddleErrors> errors) {
                         all[static_cast<std::size_t>(task)] = errors.front();
                     }),
                 progress);
    return all;
}

} // namespace quadrille
