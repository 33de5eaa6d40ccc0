// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/buildappearance.h"
#include "model/sequence/io/registry.h"
#include "shiftedtextures.h"
#include "tests/model/codeof.h"

#include <gtest/gtest.h>

using namespace quadrille;
using test::codeOf;

namespace {

/// A sample that all components of a space give back.
std::vector<float> modelledSample(const LinearSpace& space, std::int64_t sample)
{
    std::vector<float> values = space.mean;
    for (std::int64_t c = 0; c < space.count(); ++c) {
        const auto weight =
            static_cast<float>(space.coefficients[static_cast<std::size_t>(sample * space.count() + c)]);
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] += weight * space.components[static_cast<std::size_t>(c) * values.size() + k];
    }
    return values;
}

/// Root mean square difference of textures that a model makes, in grey levels, over covered texels
/// that stay in their charts.
double modelError(const BuiltAppearance& built, const TextureSource& textures)
{
    const ChartLookup charts(built.used);
    double sum = 0;
    double count = 0;
    for (std::int64_t t = 0; t < textures.count; ++t) {
        const std::vector<float> colours = modelledSample(built.textures, t);
        Image aligned(built.used.width, built.used.height);
        for (std::size_t k = 0; k < colours.size(); ++k)
            aligned.pixels[std::size_t{4} * built.used.texels[k / 3] + k % 3] =
                static_cast<std::uint8_t>(std::clamp(colours[k] + 0.5F, 0.0F, 255.0F));
        const auto found =
            charts.colours(aligned, charts.atTexels(modelledSample(built.warps, t), built.grid));
        const auto wanted = charts.colours(*textures.read(t));
        for (std::size_t k = 0; k < found.size(); ++k) {
            const auto [x, y] = charts.place(k / 3);
            if (y < 14 || y > 50 || x < 14 || x > 82 || (x > 52 && x < 74))
                continue;
            sum += std::pow(int{found[k]} - int{wanted[k]}, 2);
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

} // namespace

TEST(BuildAppearance, DoesWithFewerComponentsThanPlainAnalysis)
{
    const TopologyData atlas = test::atlasOf({{6, 6, 60, 58}, {66, 6, 90, 58}}, 96, 64);
    const Topology topology(atlas);
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = test::shiftedTextures(charts, 9, 1.2);
    const BuildAppearanceOptions options{.gutter = 3, .components = 2};
    const BuiltAppearance built = buildAppearance(textures, topology, options);
    EXPECT_EQ(built.used, charts.used());
    EXPECT_NEAR(static_cast<double>(built.reference), 4, 1); // in the middle
    EXPECT_EQ(built.textures.count(), 1);
    EXPECT_EQ(built.warps.count(), 1);
    EXPECT_EQ(built.textures.size(), 3 * charts.count());
    EXPECT_EQ(built.warps.size(), 2 * built.grid.nodes());
    EXPECT_EQ(built.figures.size(), 9U);
    BuildAppearanceOptions plain = options;
    plain.textureShare = 1;
    const BuiltAppearance naive = buildAppearance(textures, topology, plain);
    EXPECT_EQ(naive.textures.count(), 2);
    EXPECT_EQ(naive.warps.count(), 0);
    // One shift is one warp, while the pattern that moves takes many pictures.
    EXPECT_LT(modelError(built, textures), 0.6 * modelError(naive, textures));
}

TEST(BuildAppearance, WithoutWarpsIsPlainAnalysis)
{
    const Topology topology(test::atlasOf({{6, 6, 60, 58}, {66, 6, 90, 58}}, 96, 64));
    const ChartLookup charts = test::twoCharts();
    const TextureSource textures = test::shiftedTextures(charts, 5, 1.2);
    const BuiltAppearance built =
        buildAppearance(textures, topology, {.gutter = 3, .components = 3, .textureShare = 1});
    EXPECT_EQ(built.textures, principalComponents(gatherTextures(textures, charts)->alignedSamples(), 3));
    EXPECT_EQ(built.warps.count(), 0);
    EXPECT_EQ(std::ranges::count(built.warps.mean, 0.0F), std::ssize(built.warps.mean));
}

TEST(BuildAppearance, SharesComponentsOut)
{
    EXPECT_EQ(textureComponents({.components = 50}), 33);
    EXPECT_EQ(textureComponents({.components = 3}), 2);
    EXPECT_EQ(textureComponents({.components = 0}), 0);
    EXPECT_EQ(textureComponents({.components = 10, .textureShare = 1}), 10);
}

TEST(BuildAppearance, HasAsManyWarpsAsTexturesLeave)
{
    const Topology topology(test::atlasOf({{6, 6, 60, 58}, {66, 6, 90, 58}}, 96, 64));
    const ChartLookup charts = test::twoCharts();
    BuildAppearanceOptions options{.gutter = 3, .components = 3};
    options.alignment.flow.method = FlowMethod::Dis;
    const BuiltAppearance built = buildAppearance(test::shiftedTextures(charts, 4), topology, options);
    EXPECT_EQ(built.textures.count(), 2);
    EXPECT_EQ(built.warps.count(), 1);
    EXPECT_EQ(built.warps.samples(), 4);
}

TEST(BuildAppearance, RefusesNothing)
{
    const Topology topology(test::atlasOf({{6, 6, 60, 58}}, 96, 64));
    const ChartLookup charts = test::twoCharts();
    TextureSource textures = test::shiftedTextures(charts, 2);
    EXPECT_EQ(codeOf([&] { buildAppearance(textures, topology, {.components = -1}); }),
              ErrorCode::BadArgument);
    textures.read = [](std::int64_t) { return std::make_shared<const Image>(); };
    EXPECT_EQ(codeOf([&] { buildAppearance(textures, topology); }), ErrorCode::BadArgument);
    textures.count = 0;
    EXPECT_EQ(codeOf([&] { buildAppearance(textures, topology); }), ErrorCode::BadArgument);
}

TEST(BuildAppearance, BringsRealTexturesNearerToEachOther)
{
    const std::filesystem::path folder = std::filesystem::path(QUADRILLE_DATA_DIR) / "characters/liam";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no real captures at " << folder;
    const ImportResult mesh = openSequences(folder / "mesh.obj");
    const TextureSource textures{3, [&](std::int64_t index) {
                                     const std::string name = "00" + std::to_string(10 + 15 * index) + ".jpg";
                                     return std::make_shared<const Image>(
                                         readImage(folder / "textures/talk_a" / name));
                                 }};
    BuildAppearanceOptions options{.components = 2};
    options.alignment.flow.method = FlowMethod::Dis;
    const BuiltAppearance built = buildAppearance(textures, *mesh.sequences.front().topology, options);
    for (std::int64_t k = 0; k < 3; ++k) {
        if (k == built.reference)
            continue;
        EXPECT_LT(built.figures[static_cast<std::size_t>(k)].after,
                  built.figures[static_cast<std::size_t>(k)].before);
    }
}
