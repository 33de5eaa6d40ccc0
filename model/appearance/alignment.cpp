// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/alignment.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <set>
#include <string>

namespace quadrille {

namespace {

struct AlignedHead
{
    AlignmentFigures figures;
    bool isNew = false; ///< the flow was not known before
};

/// What becomes of a texture, as plain bytes between processes.
struct Aligned
{
    AlignedHead head;
    std::vector<float> forward;
    std::vector<float> backward; ///< empty while the reference is looked for
    std::vector<std::uint8_t> colours;
};

class Aligner
{
public:
    Aligner(const TextureSource& textures, const ChartLookup& charts, const AlignmentOptions& options,
            FlowCache* cache, const Executor& executor)
        : m_textures(textures), m_charts(charts), m_cache(cache), m_executor(executor)
    {
        if (textures.count <= 0)
            refuse("There is no texture to align", "Give sequences that have a texture per frame.");
        if (options.spacing <= 0 || options.rounds <= 0)
            refuse("Nodes are at least a texel apart, and it takes a round to find the reference",
                   "Change the settings of the alignment.");
        const UsedTexels& used = charts.used();
        m_alignment =
            std::make_shared<TextureAlignment>(WarpGrid::over(used.width, used.height, options.spacing),
                                               textures.count, charts.count(), options.scratchFolder);
    }

    /// Takes the textures as they are. \return the one nearest to their mean.
    std::int64_t gather(const Progress& progress)
    {
        run(0, FlowMethod::TvL1, progress.part(0, 0.8), [this](std::int64_t index, const Progress&) {
            const auto nodes = static_cast<std::size_t>(2 * m_alignment->grid().nodes());
            return Aligned{
                {}, std::vector<float>(nodes), std::vector<float>(nodes), m_charts.colours(*read(index))};
        });
        return nearestToMean(progress.part(0.8, 1));
    }

    /// Aligns all to a texture. \return the one nearest to the mean of the aligned, while the reference is
    /// looked for.
    std::int64_t align(std::int64_t reference, const FlowOptions& flow, bool isLast, const Progress& progress)
    {
        const std::shared_ptr<const Image> fixed = read(reference);
        const std::vector<std::uint8_t> wanted = m_charts.colours(*fixed);
        // Warps from the round before serve once more.
        const bool isKnown =
            m_aligned && m_aligned->reference == reference && m_aligned->method == flow.method;
        run(reference, flow.method, progress.part(0, isLast ? 1 : 0.95),
            [&](std::int64_t index, const Progress& own) {
                const std::shared_ptr<const Image> moving = read(index);
                Aligned result;
                if (isKnown)
                    result.forward = m_alignment->forward(index);
                else if (const auto known = knownWarp({index, reference, flow.method}))
                    result.forward = *known;
                else {
                    result.forward = m_charts.atNodes(denseFlow(*fixed, *moving, m_charts, flow, own),
                                                      m_alignment->grid());
                    result.head.isNew = true;
                }
                const WarpGrid& grid = m_alignment->grid();
                const std::vector<Vec2f> field = m_charts.atTexels(result.forward, grid);
                result.colours = m_charts.colours(*moving, field);
                if (isLast) {
                    result.backward = m_charts.atNodes(m_charts.inverse(result.forward, grid), grid);
                    result.head.figures = figuresOf(*moving, wanted, field, result.colours);
                }
                return result;
            });
        m_aligned = FlowCache::Key{0, reference, flow.method};
        return isLast ? reference : nearestToMean(progress.part(0.95, 1));
    }

    std::shared_ptr<TextureAlignment> result() const { return m_alignment; }

private:
    std::shared_ptr<const Image> read(std::int64_t index) const
    {
        std::shared_ptr<const Image> texture = m_textures.read(index);
        const UsedTexels& used = m_charts.used();
        if (!texture || texture->width != used.width || texture->height != used.height)
            refuse("Texture " + std::to_string(index + 1) + " has not the size of the atlas, " +
                       sizeText(used.width, used.height) + " texels",
                   "Bring all textures to one size.");
        return texture;
    }

    std::optional<std::vector<float>> knownWarp(const FlowCache::Key& key) const
    {
        const auto size = static_cast<std::size_t>(2 * m_alignment->grid().nodes());
        if (key.texture == key.reference)
            return std::vector<float>(size);
        std::optional<std::vector<float>> known = m_cache != nullptr ? m_cache->get(key) : std::nullopt;
        return known && known->size() == size ? known : std::nullopt;
    }

    AlignmentFigures figuresOf(const Image& texture, std::span<const std::uint8_t> wanted,
                               const std::vector<Vec2f>& field, std::span<const std::uint8_t> aligned) const
    {
        const std::vector<std::uint8_t> colours = m_charts.colours(texture);
        AlignmentFigures figures;
        double texels = 0;
        for (std::size_t k = 0; k < field.size(); ++k) {
            if (m_charts.used().covered[k] == 0)
                continue;
            texels += 1;
            figures.displacement += static_cast<double>(field[k].norm());
            for (std::size_t c = 3 * k; c < 3 * k + 3; ++c) {
                figures.before += std::pow(colours[c] - wanted[c], 2);
                figures.after += std::pow(aligned[c] - wanted[c], 2);
            }
        }
        texels = std::max(texels, 1.0);
        figures.displacement /= texels;
        figures.before = std::sqrt(figures.before / (3 * texels));
        figures.after = std::sqrt(figures.after / (3 * texels));
        return figures;
    }

    /// Computes what becomes of each texture, and puts it into scratch.
    template <typename Compute>
    void run(std::int64_t reference, FlowMethod method, const Progress& progress, const Compute& compute)
    {
        m_sums.assign(static_cast<std::size_t>(3 * m_charts.count()), 0);
        TaskSet tasks;
        tasks.count = m_textures.count;
        tasks.compute = [&](std::int64_t task, const Progress& own) {
            const Aligned aligned = compute(task, own);
            const auto parts = {
                std::as_bytes(std::span(&aligned.head, 1)), std::as_bytes(std::span(aligned.colours)),
                std::as_bytes(std::span(aligned.forward)), std::as_bytes(std::span(aligned.backward))};
            std::size_t size = 0;
            for (const std::span<const std::byte> part : parts)
                size += part.size();
            TaskSet::Result bytes(size);
            auto place = bytes.begin();
            for (const std::span<const std::byte> part : parts)
                place = std::copy(part.begin(), part.end(), place);
            return bytes;
        };
        tasks.store = [&](std::int64_t task, std::span<const std::byte> bytes) {
            AlignedHead head;
            std::memcpy(&head, bytes.data(), sizeof(head));
            const auto colours = bytes.subspan(sizeof(head), m_sums.size());
            const auto warps = bytes.subspan(sizeof(head) + m_sums.size());
            const auto forward =
                warps.first(static_cast<std::size_t>(2 * m_alignment->grid().nodes()) * sizeof(float));
            m_alignment->figures[static_cast<std::size_t>(task)] = head.figures;
            m_alignment->setAligned(task, colours);
            m_alignment->setForward(task, forward);
            m_alignment->setBackward(task, warps.subspan(forward.size()));
            if (m_cache != nullptr && head.isNew)
                m_cache->put({task, reference, method}, m_alignment->forward(task));
            const std::scoped_lock lock(m_mutex);
            for (std::size_t k = 0; k < m_sums.size(); ++k)
                m_sums[k] += static_cast<std::uint32_t>(colours[k]);
        };
        m_executor.run(tasks, progress);
    }

    std::int64_t nearestToMean(const Progress& progress) const
    {
        std::vector<double> distances(static_cast<std::size_t>(m_textures.count));
        m_executor.run(makeTasks<double>(
                           m_textures.count,
                           [&](std::int64_t task, const Progress&) {
                               const std::vector<std::uint8_t> colours = m_alignment->aligned(task);
                               double sum = 0;
                               for (std::size_t k = 0; k < colours.size(); ++k) {
                                   const double mean =
                                       static_cast<double>(m_sums[k]) / static_cast<double>(m_textures.count);
                                   sum += (colours[k] - mean) * (colours[k] - mean);
                               }
                               return std::vector<double>{sum};
                           },
                           [&](std::int64_t task, std::span<const double> distance) {
                               distances[static_cast<std::size_t>(task)] = distance.front();
                           }),
                       progress);
        return std::min_element(distances.begin(), distances.end()) - distances.begin();
    }

    const TextureSource& m_textures;
    const ChartLookup& m_charts;
    FlowCache* m_cache;
    const Executor& m_executor;
    std::shared_ptr<TextureAlignment> m_alignment;
    std::optional<FlowCache::Key> m_aligned; ///< to what, and how, forward warps in scratch were computed
    std::mutex m_mutex;
    std::vector<std::uint32_t> m_sums; ///< of the colours of all textures
};

} // namespace

std::shared_ptr<TextureAlignment> alignTextures(const TextureSource& textures, const ChartLookup& charts,
                                                const AlignmentOptions& options, FlowCache* cache,
                                                const Progress& progress, const Executor& executor)
{
    Aligner aligner(textures, charts, options, cache, executor);
    std::int64_t reference = options.reference.value_or(0);
    if (!options.reference)
        reference = aligner.gather(progress.part(0, 0.05));
    int round = 0;
    double done = 0.05;
    std::set<std::int64_t> tried;
    // Two textures may be each other's medoid: none is tried twice.
    const bool isSought = !options.reference && textures.count > 2;
    for (; isSought && round < options.rounds && tried.insert(reference).second; ++round) {
        // How many rounds it takes is not known before.
        const double end = done + (0.6 - done) / 2;
        reference = aligner.align(reference, options.search, false, progress.part(done, end));
        done = end;
    }
    aligner.align(reference, options.flow, true, progress.part(done, 1));
    aligner.result()->reference = reference;
    aligner.result()->rounds = round;
    return aligner.result();
}

std::shared_ptr<TextureAlignment> gatherTextures(const TextureSource& textures, const ChartLookup& charts,
                                                 const AlignmentOptions& options, const Progress& progress,
                                                 const Executor& executor)
{
    Aligner aligner(textures, charts, options, nullptr, executor);
    aligner.result()->reference = aligner.gather(progress);
    return aligner.result();
}

} // namespace quadrille
