// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/alignment.h"
#include "shiftedtextures.h"
#include "tests/model/codeof.h"

#include <gtest/gtest.h>
#include <map>
#include <mutex>
#include <tbb/task_arena.h>

using namespace quadrille;
using test::codeOf;
using test::shiftedTextures;

namespace {

class FlowMemory : public FlowCache
{
public:
    std::optional<std::vector<float>> get(const Key& key) const override
    {
        const std::scoped_lock lock(m_mutex);
        const auto found = m_warps.find(numbers(key));
        return found == m_warps.end() ? std::nullopt : std::optional(found->second);
    }
    void put(const Key& key, std::span<const float> warp) override
    {
        const std::scoped_lock lock(m_mutex);
        ++puts;
        m_warps[numbers(key)].assign(warp.begin(), warp.end());
    }

    int puts = 0;

private:
    static std::array<std::int64_t, 3> numbers(const Key& key)
    {
        return {key.texture, key.reference, static_cast<std::int64_t>(key.method)};
    }

    mutable std::mutex m_mutex;
    std::map<std::array<std::int64_t, 3>, std::vector<float>> m_warps;
};

double difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                  const UsedTexels& used)
{
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (used.covered[k / 3] == 0)
            continue;
        sum += std::abs(int{a[k]} - int{b[k]});
        ++count;
    }
    return sum / count;
}

void expectSame(const TextureAlignment& a, const TextureAlignment& b)
{
    EXPECT_EQ(a.reference, b.reference);
    EXPECT_EQ(a.rounds, b.rounds);
    for (std::int64_t k = 0; k < a.count(); ++k) {
        EXPECT_EQ(a.forward(k), b.forward(k));
        EXPECT_EQ(a.backward(k), b.backward(k));
        EXPECT_EQ(a.aligned(k), b.aligned(k));
    }
}

} // namespace

TEST(TextureAlignment, FindsTheMedoidAndAlignsTheOthersToIt)
{
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = shiftedTextures(charts, 5);
    const auto alignment = alignTextures(textures, charts);
    EXPECT_EQ(alignment->reference, 2);
    EXPECT_GE(alignment->rounds, 1);
    const auto reference = charts.colours(*textures.read(2));
    EXPECT_EQ(alignment->aligned(2), reference);
    for (std::int64_t k = 0; k < 5; ++k) {
        const AlignmentFigures& figures = alignment->figures[static_cast<std::size_t>(k)];
        const double shift = 0.6 * std::abs(static_cast<double>(k - 2)) * std::hypot(1, 0.5);
        // Displacements near edges are shortened.
        EXPECT_NEAR(figures.displacement, shift, 0.25 * shift) << k;
        if (k == 2)
            continue;
        EXPECT_LT(figures.after, 0.5 * figures.before) << k;
        EXPECT_LT(difference(alignment->aligned(k), reference, charts.used()),
                  0.5 * difference(charts.colours(*textures.read(k)), reference, charts.used()));
    }
}

TEST(TextureAlignment, GivesTexturesBackByBackwardWarps)
{
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = shiftedTextures(charts, 5);
    const auto alignment = alignTextures(textures, charts);
    for (std::int64_t k = 0; k < 5; ++k) {
        Image aligned = *textures.read(k);
        const std::vector<std::uint8_t> colours = alignment->aligned(k);
        for (std::size_t t = 0; t < charts.used().texels.size(); ++t)
            std::copy_n(colours.begin() + static_cast<std::ptrdiff_t>(3 * t), 3,
                        aligned.pixels.begin() + std::ptrdiff_t{4} * charts.used().texels[t]);
        const auto found =
            charts.colours(aligned, charts.atTexels(alignment->backward(k), alignment->grid()));
        // Sampled twice between texels, which softens a pattern of 60 grey levels a texel at most.
        EXPECT_LT(difference(found, charts.colours(*textures.read(k)), charts.used()), 4) << k;
    }
}

TEST(TextureAlignment, StreamsSamples)
{
    const ChartLookup charts = test::twoCharts();
    const auto alignment = alignTextures(shiftedTextures(charts, 3), charts);
    const SampleSet colours = alignment->alignedSamples();
    EXPECT_EQ(colours.count, 3);
    EXPECT_EQ(colours.size, 3 * charts.count());
    std::vector<float> values(10);
    colours.read(1, 50, values);
    for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_EQ(values[k], static_cast<float>(alignment->aligned(1)[50 + k]));
    const SampleSet warps = alignment->backwardSamples();
    EXPECT_EQ(warps.size, 2 * alignment->grid().nodes());
    warps.read(2, 301, values);
    for (std::size_t k = 0; k < values.size(); ++k)
        EXPECT_EQ(values[k], alignment->backward(2)[301 + k]);
}

TEST(TextureAlignment, GoesOnWithFlowsThatWereKept)
{
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = shiftedTextures(charts, 5);
    FlowMemory memory;
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.25)
            token.cancel();
    });
    EXPECT_EQ(codeOf([&] { alignTextures(textures, charts, {}, &memory, progress); }), ErrorCode::Cancelled);
    const int kept = memory.puts;
    EXPECT_GT(kept, 0);
    const auto alignment = alignTextures(textures, charts, {}, &memory);
    const int all = memory.puts;
    expectSame(*alignment, *alignTextures(textures, charts, {}, &memory));
    EXPECT_EQ(memory.puts, all);
    FlowMemory fresh;
    expectSame(*alignment, *alignTextures(textures, charts, {}, &fresh));
    EXPECT_EQ(fresh.puts, all); // none was computed twice
}

TEST(TextureAlignment, DoesNotDependOnThreads)
{
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = shiftedTextures(charts, 4);
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return alignTextures(textures, charts); });
    };
    expectSame(*with(1), *with(4));
}

TEST(TextureAlignment, OfOneTextureIsItself)
{
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = shiftedTextures(charts, 1);
    const auto alignment = alignTextures(textures, charts);
    EXPECT_EQ(alignment->reference, 0);
    EXPECT_EQ(alignment->rounds, 0);
    EXPECT_EQ(alignment->aligned(0), charts.colours(*textures.read(0)));
    EXPECT_EQ(alignment->backward(0),
              std::vector<float>(static_cast<std::size_t>(2 * alignment->grid().nodes())));
}

TEST(TextureAlignment, CanBeLeftOut)
{
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = shiftedTextures(charts, 5);
    const auto gathered = gatherTextures(textures, charts);
    EXPECT_EQ(gathered->reference, 2);
    for (std::int64_t k = 0; k < 5; ++k) {
        EXPECT_EQ(gathered->aligned(k), charts.colours(*textures.read(k)));
        EXPECT_EQ(gathered->backward(k), std::vector<float>(gathered->forward(k).size()));
    }
}

TEST(TextureAlignment, RefusesWhatDoesNotFit)
{
    const ChartLookup charts = test::twoCharts();
    TextureSource textures = shiftedTextures(charts, 3);
    EXPECT_EQ(codeOf([&] { alignTextures(textures, charts, {.spacing = 0}); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { alignTextures(textures, charts, {.rounds = 0}); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { alignTextures(textures, charts, {.scratchFolder = "/nowhere"}); }),
              ErrorCode::WriteFailed);
    textures.read = [](std::int64_t) { return std::make_shared<const Image>(8, 8); };
    EXPECT_EQ(codeOf([&] { alignTextures(textures, charts); }), ErrorCode::BadArgument);
    textures.count = 0;
    EXPECT_EQ(codeOf([&] { alignTextures(textures, charts); }), ErrorCode::BadArgument);
}
