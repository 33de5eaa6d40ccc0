// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "appearancefixture.h"
#include "model/appearance/decode.h"
#include "model/appearance/reducedmodel.h"
#include "tests/model/codeof.h"

#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {

using namespace test;

namespace {

TEST(ReducedModel, TakesMeansOfTexelsOfOneChart)
{
    // Two rows of four texels: two of the first chart, one of a gutter and three of the second; one is not
    // used.
    AppearanceModel model;
    model.texels = {.width = 4,
                    .height = 2,
                    .texels = {0, 1, 2, 3, 4, 6, 7},
                    .charts = {0, 0, 0, 1, 0, 1, 1},
                    .covered = {1, 1, 0, 1, 0, 1, 1},
                    .chartCount = 2};
    LinearSpace textures;
    for (const float red : {10.0F, 20.0F, 200.0F, 50.0F, 30.0F, 60.0F, 70.0F}) {
        textures.mean.insert(textures.mean.end(), {red, 0, 255});
        textures.components.insert(textures.components.end(), {red / 100, 0, 0});
    }
    textures.eigenvalues = {3};
    model.textures = quadrille::quantised(textures);
    model.grid = {4, 2, 2};
    model.warps = quadrille::quantised(LinearSpace{.mean = std::vector<float>(8, 3)});
    const AppearanceModel small = reduced(model, 2);
    EXPECT_EQ(small.texels, (UsedTexels{.width = 2,
                                        .height = 1,
                                        .texels = {0, 1},
                                        .charts = {0, 1},
                                        .covered = {1, 1},
                                        .chartCount = 2}));
    const std::vector<float> mean = combined(small.textures, {});
    ASSERT_EQ(mean.size(), 6U);
    EXPECT_NEAR(mean[0], 20, 0.01); // 10, 20 and 30
    EXPECT_NEAR(mean[3], 60, 0.01); // 50, 60 and 70
    EXPECT_NEAR(mean[5], 255, 0.01);
    EXPECT_NEAR(small.textures.component(0, 3), 0.6, 0.005);
    EXPECT_EQ(small.textures.eigenvalues, textures.eigenvalues);
    EXPECT_EQ(small.grid, (WarpGrid{2, 2, 2}));
    EXPECT_NEAR(combined(small.warps, {})[0], 1.5, 1e-3);
}

TEST(ReducedModel, DecodesToMeansOfTheLargeTexture)
{
    const auto model = std::make_shared<const AppearanceModel>(modelOfWaves());
    const AppearanceDecoder large(model);
    for (const int factor : {2, 4}) {
        const AppearanceDecoder small(std::make_shared<const AppearanceModel>(reduced(*model, factor)));
        for (const std::size_t frame : {1U, 4U}) {
            const Image expected = large.decode(coefficientsOf(*model, frame));
            const Image found = small.decode(coefficientsOf(small.model(), frame));
            ASSERT_EQ(found.width, 160 / factor);
            double squares = 0;
            int count = 0;
            for (std::size_t t = 0; t < small.model().texels.texels.size(); ++t) {
                const int x = static_cast<int>(small.model().texels.texels[t]) % found.width;
                const int y = static_cast<int>(small.model().texels.texels[t]) / found.width;
                if (std::hypot(factor * (x + 0.5) - 43, factor * (y + 0.5) - 48) > 34)
                    continue; // near the rim of the first chart
                double sum = 0;
                for (int v = 0; v < factor; ++v) {
                    for (int u = 0; u < factor; ++u)
                        sum += expected.pixel(factor * x + u, factor * y + v)[1];
                }
                squares += std::pow(sum / (factor * factor) - found.pixel(x, y)[1], 2);
                ++count;
            }
            EXPECT_GT(count, 100);
            EXPECT_LT(std::sqrt(squares / count), factor == 2 ? 1 : 4)
                << factor; // a texel is a tenth of a wave
        }
    }
}

TEST(ReducedModel, OfFactorOneIsTheModelAgain)
{
    const AppearanceModel model = modelOfWaves();
    const AppearanceModel same = reduced(model, 1);
    EXPECT_EQ(same.texels, model.texels);
    EXPECT_EQ(same.grid, model.grid);
    EXPECT_EQ(same.textures.steps, model.textures.steps);
    EXPECT_EQ(same.warps, model.warps);
    EXPECT_EQ(same.frames, model.frames);
}

TEST(ReducedModel, StopsWhenCancelled)
{
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { reduced(modelOfWaves(), 2, Progress(token)); }), ErrorCode::Cancelled);
}

} // namespace

} // namespace quadrille
