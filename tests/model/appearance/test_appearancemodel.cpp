// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "appearancefixture.h"
#include "model/appearance/projection.h"
#include "model/core/random.h"
#include "tests/model/codeof.h"

#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {

using namespace test;

namespace {

/// Two components of two values each, so that results can be told by hand.
LinearSpace smallSpace()
{
    return {.mean = {100, -50, 7},
            .components = {0.6F, 0.8F, 0, -0.8F, 0.6F, 0},
            .eigenvalues = {4, 1, 0.5},
            .coefficients = {3, 1, -3, -1}};
}

std::vector<float> reconstruction(const LinearSpace& space, const std::vector<double>& coefficients)
{
    std::vector<float> values = space.mean;
    for (std::size_t c = 0; c < coefficients.size(); ++c) {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] += static_cast<float>(coefficients[c]) * space.components[c * values.size() + i];
    }
    return values;
}

TEST(QuantisedSpace, HoldsTheLargestValuesOfABlockExactlyAndTheOthersToHalfAStep)
{
    const QuantisedSpace space = quantised(smallSpace());
    EXPECT_EQ(space.size, 3);
    EXPECT_EQ(space.count, 2);
    EXPECT_EQ(space.blocks(), 1);
    EXPECT_EQ(space.samples(), 2);
    EXPECT_EQ(space.eigenvalues, (std::vector<double>{4, 1, 0.5}));
    EXPECT_EQ(space.coefficients, (std::vector<double>{3, 1, -3, -1}));
    EXPECT_EQ(space.mean[0], 32767);
    EXPECT_EQ(space.mean[1], -16384); // −50 of 100 is 16383.5 steps
    EXPECT_FLOAT_EQ(space.component(0, 1), 0.8F);
    EXPECT_FLOAT_EQ(space.component(0, 0), 95 * 0.8F / 127); // 95.25 steps
    EXPECT_FLOAT_EQ(space.component(1, 0), -0.8F);
    EXPECT_FLOAT_EQ(space.component(1, 2), 0);
}

TEST(QuantisedSpace, CombinesMeanAndComponents)
{
    const QuantisedSpace space = quantised(smallSpace());
    const std::vector<float> values = combined(space, std::vector<float>{10, 100});
    ASSERT_EQ(values.size(), 3U);
    EXPECT_NEAR(values[0], 100 + 10 * 95 * 0.8 / 127 - 80, 1e-4);
    EXPECT_NEAR(values[1], -50 + 8 + 100 * 95 * 0.8 / 127, 1e-2); // the mean has steps of 0.003
    EXPECT_NEAR(values[2], 7, 1e-2);
    EXPECT_NEAR(combined(space, std::vector<float>{10})[0], 100 + 10 * 95 * 0.8 / 127, 1e-4);
    EXPECT_NEAR(combined(space, {})[0], 100, 1e-4);
}

TEST(QuantisedSpace, CombinesAnyNumberOfComponentsAsPlainSums)
{
    for (const int count : {1, 2, 3, 4, 5, 7, 8}) {
        const LinearSpace space = randomSpace(std::vector<float>(2000, 50), count, 1, 5, false, 3);
        const QuantisedSpace rounded = quantised(space);
        std::vector<float> coefficients(space.coefficients.begin(), space.coefficients.end());
        const std::vector<float> values = combined(rounded, coefficients);
        for (std::int64_t i : {0, 1, 1535, 1536, 1999}) {
            double expected = 50;
            for (int c = 0; c < count; ++c)
                expected += static_cast<double>(coefficients[static_cast<std::size_t>(c)]) *
                            static_cast<double>(rounded.component(c, i));
            EXPECT_NEAR(values[static_cast<std::size_t>(i)], expected, 1e-3) << count << " " << i;
        }
    }
}

TEST(QuantisedSpace, StaysWithinATenthOfAGreyLevelOfItsComponents)
{
    // 127 steps for uniform noise: its error is 1 / (127 · 2) / √3 of its largest value, or 0.4 % of its
    // spread.
    const LinearSpace space = randomSpace(std::vector<float>(20'000, 128), 12, 4, 10, true, 11);
    const QuantisedSpace rounded = quantised(space);
    for (std::int64_t s = 0; s < space.samples(); ++s) {
        const std::vector<double> row(space.coefficients.begin() + s * 12,
                                      space.coefficients.begin() + (s + 1) * 12);
        const std::vector<float> exact = reconstruction(space, row);
        const std::vector<float> values = combined(rounded, std::vector<float>(row.begin(), row.end()));
        double squared = 0;
        for (std::size_t i = 0; i < exact.size(); ++i)
            squared += std::pow(exact[i] - values[i], 2);
        EXPECT_LT(std::sqrt(squared / 20'000), 0.1);
    }
}

TEST(QuantisedSpace, KeepsDetailsOfOneBlockApartFromLargeValuesOfAnother)
{
    LinearSpace space;
    space.mean.assign(2 * QuantisedSpace::blockSize, 0);
    space.components.assign(2 * QuantisedSpace::blockSize, 0.001F);
    space.components.front() = 1;
    const QuantisedSpace rounded = quantised(space);
    EXPECT_FLOAT_EQ(rounded.component(0, 0), 1);
    EXPECT_FLOAT_EQ(rounded.component(0, 5), 0);
    EXPECT_FLOAT_EQ(rounded.component(0, QuantisedSpace::blockSize + 5), 0.001F);
}

TEST(QuantisedSpace, HoldsNothingButAMean)
{
    const QuantisedSpace space = quantised(LinearSpace{.mean = {0, 0, 0}});
    EXPECT_EQ(combined(space, {}), (std::vector<float>{0, 0, 0}));
    EXPECT_EQ(space.samples(), 0);
    EXPECT_EQ(quantised(LinearSpace{}).blocks(), 0);
}

TEST(QuantisedSpace, StopsWhenCancelled)
{
    CancelToken token;
    token.cancel();
    EXPECT_EQ(codeOf([&] { quantised(smallSpace(), Progress(token)); }), ErrorCode::Cancelled);
    const QuantisedSpace space = quantised(smallSpace());
    EXPECT_EQ(codeOf([&] { componentProducts(space, {}, Progress(token)); }), ErrorCode::Cancelled);
}

TEST(SpaceProjection, FindsTheCoefficientsOfWhatLiesInTheSpace)
{
    const QuantisedSpace space = quantised(randomSpace(std::vector<float>(4000, 100), 7, 1, 5, false, 5));
    Random random(9);
    Eigen::VectorXd coefficients(7);
    for (double& value : coefficients)
        value = 300 * random.normal();
    std::vector<float> sample(4000);
    for (std::int64_t i = 0; i < space.size; ++i) {
        double value = static_cast<double>(space.meanStep) * space.mean[static_cast<std::size_t>(i)];
        for (int c = 0; c < 7; ++c)
            value += coefficients[c] * static_cast<double>(space.component(c, i));
        sample[static_cast<std::size_t>(i)] = static_cast<float>(value);
    }
    const Eigen::VectorXd found = SpaceProjection(space).project(sample);
    EXPECT_LT((found - coefficients).norm(), 1e-4 * coefficients.norm()); // samples are in single precision
}

TEST(SpaceProjection, LeavesARestThatNoComponentExplains)
{
    const QuantisedSpace space = quantised(randomSpace(std::vector<float>(3000, 100), 5, 1, 5, false, 6));
    Random random(2);
    std::vector<float> sample(3000);
    for (float& value : sample)
        value = static_cast<float>(random.between(0, 255));
    const Eigen::VectorXd found = SpaceProjection(space).project(sample);
    const std::vector<float> nearest = combined(space, std::vector<float>(found.begin(), found.end()));
    for (int c = 0; c < 5; ++c) {
        double product = 0;
        for (std::int64_t i = 0; i < space.size; ++i)
            product += static_cast<double>(sample[static_cast<std::size_t>(i)] -
                                           nearest[static_cast<std::size_t>(i)]) *
                       static_cast<double>(space.component(c, i));
        EXPECT_NEAR(product, 0, 0.01); // the rest is 4000 long
    }
}

TEST(SpaceProjection, CountsKnownValuesOnly)
{
    const QuantisedSpace space = quantised(randomSpace(std::vector<float>(2000, 0), 2, 1, 5, false, 8));
    std::vector<float> sample(2000, 3);
    std::vector<std::uint8_t> known(2000, 0);
    known[1] = known[1700] = 1;
    const Eigen::MatrixXd products = componentProducts(space, known);
    const Eigen::VectorXd with = sampleProducts(space, sample, known);
    const auto at = [&](int c, int i) { return static_cast<double>(space.component(c, i)); };
    for (int c = 0; c < 2; ++c) {
        EXPECT_NEAR(with(c), 3 * (at(c, 1) + at(c, 1700)),
                    1e-7); // values of components are in single precision
        for (int d = 0; d < 2; ++d)
            EXPECT_NEAR(products(c, d), at(c, 1) * at(d, 1) + at(c, 1700) * at(d, 1700), 1e-9);
    }
}

TEST(SpaceProjection, GivesNothingToComponentsThatAreZero)
{
    LinearSpace space = smallSpace();
    std::fill_n(space.components.begin() + 3, 3, 0.0F);
    const QuantisedSpace rounded = quantised(space);
    const Eigen::VectorXd found = SpaceProjection(rounded).project(std::vector<float>{106, -42, 7});
    EXPECT_NEAR(found(0), 10, 0.1);
    EXPECT_EQ(found(1), 0);
    EXPECT_EQ(
        SpaceProjection(quantised(LinearSpace{.mean = {1, 2}})).project(std::vector<float>{3, 4}).size(), 0);
}

TEST(AppearanceModel, GivesTheCoefficientsOfItsFrames)
{
    const AppearanceSpaces spaces = randomSpaces(texelsOfDiscs(32, 20, {{15, 10, 8}}), {}, 1);
    const AppearanceModel model = quantised(spaces);
    EXPECT_EQ(model.frames, spaces.frames);
    const AppearanceCoefficients third = coefficientsOf(model, 2);
    ASSERT_EQ(third.textures.size(), 6U);
    ASSERT_EQ(third.warps.size(), 3U);
    EXPECT_FLOAT_EQ(third.textures[1], static_cast<float>(spaces.textures.coefficients[2 * 6 + 1]));
    EXPECT_FLOAT_EQ(third.warps[2], static_cast<float>(spaces.warps.coefficients[2 * 3 + 2]));
}

TEST(AppearanceModel, ProjectsFramesToTheirCoefficients)
{
    const AppearanceModel model = quantised(randomSpaces(texelsOfDiscs(40, 40, {{20, 20, 15}}), {}, 4));
    for (const std::size_t frame : {0U, 5U}) {
        const AppearanceCoefficients expected = coefficientsOf(model, frame);
        const AppearanceCoefficients found = project(model, combined(model.textures, expected.textures),
                                                     combined(model.warps, expected.warps));
        for (std::size_t c = 0; c < expected.textures.size(); ++c)
            EXPECT_NEAR(found.textures[c], expected.textures[c], 0.01);
        for (std::size_t c = 0; c < expected.warps.size(); ++c)
            EXPECT_NEAR(found.warps[c], expected.warps[c], 0.001);
    }
}

TEST(AppearanceModel, InterpolatesCoefficients)
{
    const AppearanceCoefficients first{{1, 2}, {10}};
    const AppearanceCoefficients second{{3, 6}, {20, 8}};
    EXPECT_EQ(interpolated(first, second, 0.25), (AppearanceCoefficients{{1.5F, 3}, {12.5F, 2}}));
    EXPECT_EQ(interpolated(first, second, 1), second);
    EXPECT_EQ(interpolated(first, first, 0.3), first);
}

TEST(WarpGrid, LiesAroundAllTexels)
{
    EXPECT_EQ(WarpGrid::over(1024, 512), (WarpGrid{4, 257, 129}));
    EXPECT_EQ(WarpGrid::over(5, 1), (WarpGrid{4, 2, 1}));
    EXPECT_EQ(WarpGrid::over(6, 9, 8), (WarpGrid{8, 2, 2}));
}

} // namespace

} // namespace quadrille
