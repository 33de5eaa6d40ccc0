// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/random.h"
#include "model/evaluation/appearancerates.h"
#include "model/evaluation/combinedtextures.h"
#include "model/evaluation/compactness.h"

#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::ElementsAre;
using ::testing::Optional;

namespace {

constexpr std::int64_t sampleSize = 60;

/// Whole numbers of 0 … 255, as textures have.
std::vector<std::vector<float>> someSamples(std::int64_t count)
{
    Random random(7);
    std::vector<std::vector<float>> samples(static_cast<std::size_t>(count));
    for (auto& sample : samples)
        for (std::int64_t i = 0; i < sampleSize; ++i)
            sample.push_back(std::floor(static_cast<float>(random.between(0, 256))));
    return samples;
}

SampleSet setOf(const std::vector<std::vector<float>>& samples)
{
    return {std::ssize(samples), std::ssize(samples.front()),
            [&samples](std::int64_t sample, std::int64_t first, std::span<float> values) {
                std::copy_n(samples[static_cast<std::size_t>(sample)].begin() + first, values.size(),
                            values.begin());
            }};
}

/// Sum of squares between samples and what combinations of them give.
double errorOf(const std::vector<std::vector<float>>& samples, const Eigen::MatrixXd& weights)
{
    const CombinedTextures combined(setOf(samples), weights, {}, {});
    double error = 0;
    for (std::size_t s = 0; s < samples.size(); ++s) {
        const auto colours = combined.colours(static_cast<std::int64_t>(s));
        for (std::size_t i = 0; i < colours.size(); ++i)
            error += std::pow(static_cast<double>(samples[s][i]) - colours[i], 2);
    }
    return error;
}

} // namespace

TEST(CombinedTextures, AreTheSamplesThemselvesWithAllComponents)
{
    const auto samples = someSamples(9);
    const SnapshotSpace space(centredProducts(setOf(samples)));
    EXPECT_EQ(space.components(), 8);
    EXPECT_EQ(errorOf(samples, space.reconstructions(8)), 0);
    EXPECT_EQ(errorOf(samples, space.reconstructions(100)), 0);
}

TEST(CombinedTextures, LoseWhatTheEigenvaluesLeftOutSay)
{
    const auto samples = someSamples(9);
    const SnapshotSpace space(centredProducts(setOf(samples)));
    const LinearSpace components = principalComponents(setOf(samples), 8);
    for (const std::size_t count : {0U, 1U, 4U, 7U}) {
        double left = 0;
        for (std::size_t c = count; c < components.eigenvalues.size(); ++c)
            left += components.eigenvalues[c] * 9;
        // Values are rounded, and clamped to 0 … 255.
        EXPECT_NEAR(errorOf(samples, space.reconstructions(static_cast<std::int64_t>(count))), left,
                    0.03 * left)
            << count;
    }
}

TEST(CombinedTextures, ProjectOnTheNearestPointOfWhatWasLearned)
{
    // On a line through the first two: the third lies on it, the fourth 12 beside the place of the third.
    std::vector<std::vector<float>> samples{{10, 20, 30}, {20, 20, 30}, {40, 20, 30}, {40, 32, 30}};
    const SnapshotSpace space(centredProducts(setOf(samples)));
    const Eigen::MatrixXd weights =
        space.projections(std::vector<std::int64_t>{0, 1}, std::vector<std::int64_t>{2, 3});
    ASSERT_EQ(weights.rows(), 4);
    ASSERT_EQ(weights.cols(), 2);
    for (const Eigen::Index column : {0, 1}) {
        EXPECT_NEAR(weights(0, column), -2, 1e-9);
        EXPECT_NEAR(weights(1, column), 3, 1e-9);
        EXPECT_EQ(weights(2, column), 0);
        EXPECT_EQ(weights(3, column), 0);
    }
    const CombinedTextures combined(setOf(samples), weights, {}, {});
    EXPECT_THAT(combined.colours(1), ElementsAre(40, 20, 30));
    const Eigen::MatrixXd ofOne =
        space.projections(std::vector<std::int64_t>{3}, std::vector<std::int64_t>{0});
    EXPECT_NEAR(ofOne(3, 0), 1, 1e-9);
    EXPECT_NEAR(ofOne.col(0).sum(), 1, 1e-9);
}

TEST(Crossover, LiesWhereLinesCross)
{
    const std::vector<double> components{1, 2, 5, 10};
    const auto at = [&](const std::vector<double>& gain) { return crossover(components, gain); };
    EXPECT_EQ(at({0, 3, 2, 1}), std::nullopt);
    EXPECT_THAT(at({0, 3, 2, -2}), Optional(7.5));
    EXPECT_THAT(at({0, -1, 3, -1}), Optional(8.75)) << "the last time";
    EXPECT_THAT(at({-1, -1, -3, -1}), Optional(1.0));
    EXPECT_THAT(at({0, -1, -3, -1}), Optional(1.0));
}

TEST(ComponentCounts, AreCloseWhereTheyAreFew)
{
    EXPECT_THAT(componentCounts(2), ElementsAre(1));
    EXPECT_THAT(componentCounts(3), ElementsAre(1, 2));
    EXPECT_THAT(componentCounts(23), ElementsAre(1, 2, 5, 10, 20, 22));
    EXPECT_THAT(componentCounts(101), ElementsAre(1, 2, 5, 10, 20, 30, 50, 75, 100));
    EXPECT_EQ(componentCounts(10'000).size(), 18U);
}

TEST(BytesAt, LieBetweenSettings)
{
    const std::vector<AppearanceRate> rates{{"jpeg", 10, 100, {.similarity = 0.8}},
                                            {"jpeg", 90, 10'000, {.similarity = 1}},
                                            {"model", 5, 50, {.similarity = 0.85}}};
    EXPECT_NEAR(*bytesAt(rates, "jpeg", 0.9), 1000, 1e-6);
    EXPECT_THAT(bytesAt(rates, "jpeg", 0.7), Optional(100.0));
    EXPECT_EQ(bytesAt(rates, "model", 0.9), std::nullopt);
    EXPECT_EQ(bytesAt(rates, "h264", 0.1), std::nullopt);
}
