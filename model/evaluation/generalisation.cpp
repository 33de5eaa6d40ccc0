// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/generalisation.h"

#include "model/core/random.h"
#include "model/evaluation/combinedtextures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace quadrille {

namespace {

/// Which textures are learned from; the others are left out.
struct TrainingSplit
{
    std::vector<std::int64_t> training;
    std::vector<std::int64_t> others;
};

TrainingSplit drawnSplit(std::int64_t textures, std::int64_t training, std::uint64_t seed)
{
    std::vector<std::int64_t> all(static_cast<std::size_t>(textures));
    std::iota(all.begin(), all.end(), std::int64_t{0});
    Random random(seed);
    for (std::int64_t i = 0; i < training; ++i) {
        const auto at = i + static_cast<std::int64_t>(random.unit() * static_cast<double>(textures - i));
        std::swap(all[static_cast<std::size_t>(i)], all[static_cast<std::size_t>(at)]);
    }
    TrainingSplit split{{all.begin(), all.begin() + training}, {all.begin() + training, all.end()}};
    std::ranges::sort(split.training);
    std::ranges::sort(split.others);
    return split;
}

/// Combinations of warps, one after the other.
std::vector<float> combinedWarps(const SampleSet& warps, const Eigen::MatrixXd& weights,
                                 const Progress& progress, const Executor& executor)
{
    std::vector<float> all(static_cast<std::size_t>(warps.size * weights.cols()));
    combineSamples(
        warps, weights,
        [&](std::int64_t first, std::span<const float> mean, std::span<const float> combinations) {
            for (Eigen::Index row = 0; row < weights.cols(); ++row)
                std::transform(mean.begin(), mean.end(), combinations.begin() + row * std::ssize(mean),
                               all.begin() + row * warps.size + first, std::plus());
        },
        progress, executor);
    return all;
}

/// Spaces of all textures, of which those of some are made.
class Generalisation
{
public:
    Generalisation(const AppearanceSubject& subject, TextureAlignment* alignment, const Progress& progress,
                   const Executor& executor)
        : m_subject(subject)
        , m_alignment(alignment)
        , m_executor(executor)
        , m_captured(gatherTextures(subject.textures, *subject.charts,
                                    {.scratchFolder = subject.scratchFolder}, progress.part(0, 0.2),
                                    executor))
        , m_naive(centredProducts(m_captured->alignedSamples(), progress.part(0.2, 0.35), executor))
    {
        if (alignment == nullptr)
            return;
        const SampleSet warps = alignment->backwardSamples();
        realignTextures(subject.textures, *subject.charts,
                        principalComponents(warps, alignment->count(), progress.part(0.35, 0.4), executor),
                        *alignment, progress.part(0.4, 0.8), executor);
        m_aligned.emplace(centredProducts(alignment->alignedSamples(), progress.part(0.8, 0.95), executor));
        m_warps.emplace(centredProducts(warps, progress.part(0.95, 1), executor));
    }

    void add(GeneralisationRow& row, const TrainingSplit& split, const Progress& progress) const
    {
        const CombinedTextures naive(m_captured->alignedSamples(),
                                     m_naive.projections(split.training, split.others),
                                     m_subject.scratchFolder, progress.part(0, 0.2), m_executor);
        const auto placeOf = [&](std::int64_t texture) {
            return std::ranges::lower_bound(split.others, texture) - split.others.begin();
        };
        const UsedTexels& used = m_subject.charts->used();
        std::vector<RestoredTexture> ways{
            [&](std::int64_t texture) { return atlasPicture(used, naive.colours(placeOf(texture))); }};
        if (m_alignment == nullptr) {
            const auto errors =
                restorationErrors(m_subject, split.others, ways, progress.part(0.2, 1), m_executor);
            row.naive.push_back(errors[0]);
            row.own.push_back(errors[0]);
            return;
        }
        const CombinedTextures own(m_alignment->alignedSamples(),
                                   m_aligned->projections(split.training, split.others),
                                   m_subject.scratchFolder, progress.part(0.2, 0.4), m_executor);
        const std::vector<float> warps =
            combinedWarps(m_alignment->backwardSamples(), m_warps->projections(split.training, split.others),
                          progress.part(0.4, 0.45), m_executor);
        const Dealigner dealigner(used, m_alignment->grid());
        ways.emplace_back([&](std::int64_t texture) {
            const auto size = static_cast<std::size_t>(2 * m_alignment->grid().nodes());
            const auto place = static_cast<std::size_t>(placeOf(texture));
            return dealigner.dealigned(own.colours(placeOf(texture)),
                                       std::span(warps).subspan(place * size, size));
        });
        const auto errors =
            restorationErrors(m_subject, split.others, ways, progress.part(0.45, 1), m_executor);
        row.naive.push_back(errors[0]);
        row.own.push_back(errors[1]);
    }

private:
    const AppearanceSubject& m_subject;
    TextureAlignment* m_alignment;
    const Executor& m_executor;
    std::shared_ptr<TextureAlignment> m_captured; ///< the textures as they are
    SnapshotSpace m_naive;
    std::optional<SnapshotSpace> m_aligned;
    std::optional<SnapshotSpace> m_warps;
};

} // namespace

std::vector<GeneralisationRow> appearanceGeneralisation(const AppearanceSubject& subject,
                                                        TextureAlignment* alignment,
                                                        const GeneralisationSettings& settings,
                                                        const Progress& progress, const Executor& executor)
{
    constexpr double begun = 0.1; // of the time
    const Generalisation spaces(subject, alignment, progress.part(0, begun), executor);
    const std::int64_t textures = subject.textures.count;
    const auto all = static_cast<double>(std::ssize(settings.fractions) * settings.draws);
    std::vector<GeneralisationRow> rows;
    for (const double fraction : settings.fractions) {
        GeneralisationRow& row = rows.emplace_back();
        row.fraction = fraction;
        row.training =
            std::clamp<std::int64_t>(std::llround(fraction * static_cast<double>(textures)), 1, textures - 1);
        for (std::int64_t draw = 0; draw < settings.draws; ++draw) {
            const std::int64_t done = (std::ssize(rows) - 1) * settings.draws + draw;
            const TrainingSplit split = drawnSplit(
                textures, row.training, streamSeed(settings.seed, static_cast<std::uint64_t>(done)));
            spaces.add(row, split,
                       progress.part(begun + (1 - begun) * static_cast<double>(done) / all,
                                     begun + (1 - begun) * static_cast<double>(done + 1) / all));
        }
    }
    return rows;
}

} // namespace quadrille
