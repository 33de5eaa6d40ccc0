// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/compactness.h"

#include "model/appearance/buildappearance.h"
#include "model/evaluation/combinedtextures.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace quadrille {

namespace {

/// Both ways to represent textures, with any number of components.
class Compactness
{
public:
    Compactness(const AppearanceSubject& subject, TextureAlignment* alignment, const Progress& progress,
                const Executor& executor)
        : m_subject(subject)
        , m_alignment(alignment)
        , m_executor(executor)
        , m_captured(gatherTextures(subject.textures, *subject.charts,
                                    {.scratchFolder = subject.scratchFolder}, progress.part(0, 0.3),
                                    executor))
        , m_naive(centredProducts(m_captured->alignedSamples(), progress.part(0.3, 0.6), executor))
    {
        if (alignment != nullptr) {
            m_warps = principalComponents(alignment->backwardSamples(), alignment->count(),
                                          progress.part(0.6, 1), executor);
            std::ranges::fill(m_warps.mean, 0.0F);
        }
        m_all.resize(static_cast<std::size_t>(subject.textures.count));
        std::iota(m_all.begin(), m_all.end(), std::int64_t{0});
    }

    CompactnessRow row(std::int64_t components, std::int64_t warps, const Progress& progress)
    {
        const CombinedTextures naive(m_captured->alignedSamples(), m_naive.reconstructions(components),
                                     m_subject.scratchFolder, progress.part(0, 0.15), m_executor);
        const UsedTexels& used = m_subject.charts->used();
        std::vector<RestoredTexture> ways{
            [&](std::int64_t texture) { return atlasPicture(used, naive.colours(texture)); }};
        if (m_alignment == nullptr || warps == 0) {
            const auto errors = errorsOf(ways, progress.part(0.15, 1));
            return {components, 0, errors.front(), errors.front()};
        }
        const LinearSpace kept = firstComponents(m_warps, warps);
        realignTextures(m_subject.textures, *m_subject.charts, kept, *m_alignment, progress.part(0.15, 0.5),
                        m_executor);
        const SnapshotSpace space(
            centredProducts(m_alignment->alignedSamples(), progress.part(0.5, 0.55), m_executor));
        const CombinedTextures own(m_alignment->alignedSamples(), space.reconstructions(components - warps),
                                   m_subject.scratchFolder, progress.part(0.55, 0.65), m_executor);
        const Dealigner dealigner(used, m_alignment->grid());
        ways.emplace_back([&](std::int64_t texture) {
            return dealigner.dealigned(own.colours(texture), keptWarp(kept, texture));
        });
        const auto errors = errorsOf(ways, progress.part(0.65, 1));
        return {components, warps, errors[1], errors[0]};
    }

private:
    std::vector<AppearanceErrors> errorsOf(std::span<const RestoredTexture> ways,
                                           const Progress& progress) const
    {
        return restorationErrors(m_subject, m_all, ways, progress, m_executor);
    }

    const AppearanceSubject& m_subject;
    TextureAlignment* m_alignment;
    const Executor& m_executor;
    std::shared_ptr<TextureAlignment> m_captured; ///< the textures as they are
    SnapshotSpace m_naive;
    LinearSpace m_warps; ///< all of them
    std::vector<std::int64_t> m_all;
};

} // namespace

std::vector<std::int64_t> componentCounts(std::int64_t textures)
{
    assert(textures >= 2);
    std::vector<std::int64_t> counts{1,   2,   5,   10,  20,  30,   50,   75,  100,
                                     150, 200, 300, 500, 750, 1000, 1500, 2000};
    std::erase_if(counts, [&](std::int64_t count) { return count >= textures - 1; });
    counts.push_back(textures - 1);
    return counts;
}

std::vector<CompactnessRow> appearanceCompactness(const AppearanceSubject& subject,
                                                  TextureAlignment* alignment,
                                                  std::span<const std::int64_t> components,
                                                  double textureShare, const Progress& progress,
                                                  const Executor& executor)
{
    constexpr double begun = 0.08; // of the time
    Compactness compactness(subject, alignment, progress.part(0, begun), executor);
    std::vector<CompactnessRow> rows;
    for (const std::int64_t count : components) {
        const std::int64_t textures = textureComponents({.components = count, .textureShare = textureShare});
        const auto at = [&](std::size_t done) {
            return begun + (1 - begun) * static_cast<double>(done) / static_cast<double>(components.size());
        };
        rows.push_back(
            compactness.row(count, count - textures, progress.part(at(rows.size()), at(rows.size() + 1))));
    }
    return rows;
}

std::optional<double> crossover(std::span<const double> components, std::span<const double> gain)
{
    std::size_t first = gain.size(); // from here on naive ones are better
    while (first > 0 && gain[first - 1] < 0)
        --first;
    if (first == gain.size())
        return std::nullopt;
    if (first == 0)
        return components[0];
    const double share = gain[first - 1] / (gain[first - 1] - gain[first]);
    return components[first - 1] + share * (components[first] - components[first - 1]);
}

} // namespace quadrille
