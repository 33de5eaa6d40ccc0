// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/flow.h"
#include "model/sample/appearance.h"
#include "shiftedtextures.h"
#include "tests/model/codeof.h"

#include <gtest/gtest.h>

using namespace quadrille;
using test::codeOf;
using test::shiftedTexture;

namespace {

class DenseFlow : public testing::TestWithParam<FlowMethod>
{
protected:
    FlowOptions options() const { return {.method = GetParam()}; }
};

/// Mean distance from a displacement, over covered texels that are not near an edge of their chart.
double meanError(const ChartLookup& charts, const std::vector<Vec2f>& field, const Vec2f& wanted)
{
    double sum = 0;
    double count = 0;
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = charts.place(k);
        if (y < 12 || y > 52 || x < 12 || x > 84 || (x > 54 && x < 72))
            continue;
        sum += static_cast<double>((field[k] - wanted).norm());
        ++count;
    }
    return sum / count;
}

} // namespace

TEST_P(DenseFlow, FindsAShift)
{
    const ChartLookup charts = test::twoCharts();
    const Image fixed = shiftedTexture(charts.used(), {0, 0});
    // fixed(x) = pattern(x) = moving(x − shift).
    for (const Vec2d& shift : {Vec2d(1.5, 0.75), Vec2d(-2.25, 1)}) {
        const auto field = denseFlow(fixed, shiftedTexture(charts.used(), shift), charts, options());
        EXPECT_LT(meanError(charts, field, -shift.cast<float>()), 0.15);
    }
    // Nothing moves, to a fiftieth of a texel.
    EXPECT_LT(meanError(charts, denseFlow(fixed, fixed, charts, options()), Vec2f::Zero()), 0.02);
}

TEST_P(DenseFlow, IsNotMisledByLight)
{
    const ChartLookup charts = test::twoCharts();
    const Image fixed = shiftedTexture(charts.used(), {0, 0}, 0.5);
    const auto field = denseFlow(fixed, shiftedTexture(charts.used(), {1.5, 0.75}, -0.5), charts, options());
    EXPECT_LT(meanError(charts, field, Vec2f(-1.5F, -0.75F)), 0.2);
}

TEST_P(DenseFlow, DoesNotSeeWhatIsNotCovered)
{
    const ChartLookup charts = test::twoCharts();
    const auto with = [&](std::uint8_t outside) {
        return denseFlow(shiftedTexture(charts.used(), {0, 0}, 0, outside),
                         shiftedTexture(charts.used(), {1, 1}, 0, static_cast<std::uint8_t>(255 - outside)),
                         charts, options());
    };
    EXPECT_EQ(with(0), with(200));
}

TEST_P(DenseFlow, FindsTheWarpsOfTheSample)
{
    constexpr int size = 256;
    const SampleCharacter sample = makeSampleCharacter({.textureSize = size, .takesPerKind = 1});
    const ChartLookup charts(usedTexels(*sample.body.topology, size, size));
    const TexelMap texels = mapTexels(sample.body.topology->data(), size, 4);
    const auto take = std::find_if(sample.takes.begin(), sample.takes.end(),
                                   [](const SampleTake& t) { return t.kind == "idle"; });
    ASSERT_TRUE(take != sample.takes.end() && take->appearance);
    const SampleBody body = forTexturesOf(size, sample.body);
    const auto texture = [&](FrameIndex frame) {
        return frameTexture(body, texels, take->sequence.frame(frame).positions(), *take->appearance, frame);
    };
    const FrameIndex last(take->sequence.frameCount() - 1);
    const auto field = denseFlow(texture(FrameIndex(0)), texture(last), charts, options());
    const SampleWarp& from = take->appearance->warps.front();
    const SampleWarp& to = take->appearance->warps.back();
    double error = 0;
    double still = 0;
    for (std::size_t k = 0; k < field.size(); ++k) {
        const auto [x, y] = charts.place(k);
        const auto at = [&](const SampleWarp& warp, const Vec2f& by) {
            return warp.at((x + 0.5 + static_cast<double>(by.x())) / size,
                           (y + 0.5 + static_cast<double>(by.y())) / size);
        };
        Vec2f wanted = Vec2f::Zero();
        for (int iteration = 0; iteration < 20; ++iteration)
            wanted = at(from, Vec2f::Zero()) - at(to, wanted);
        error += static_cast<double>((field[k] - wanted).norm());
        still += static_cast<double>(wanted.norm());
    }
    // Half a texel is what is asked for.
    EXPECT_LT(error, 0.5 * still);
    EXPECT_LT(error / static_cast<double>(field.size()), 0.35);
}

TEST_P(DenseFlow, CanBeCancelledAndRefusesTinyTextures)
{
    const ChartLookup charts = test::twoCharts();
    const Image image = shiftedTexture(charts.used(), {0, 0});
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction >= 0.1)
            token.cancel();
    });
    EXPECT_EQ(codeOf([&] { denseFlow(image, image, charts, options(), progress); }), ErrorCode::Cancelled);
    const ChartLookup tiny(usedTexels(Topology(test::atlasOf({{0, 0, 16, 16}}, 16, 16)), 16, 16));
    EXPECT_EQ(codeOf([&] { denseFlow(Image(16, 16), Image(16, 16), tiny, options()); }),
              ErrorCode::BadArgument);
}

INSTANTIATE_TEST_SUITE_P(Methods, DenseFlow, testing::Values(FlowMethod::TvL1, FlowMethod::Dis),
                         [](const auto& method) {
                             return method.param == FlowMethod::TvL1 ? "TvL1" : "Dis";
                         });
