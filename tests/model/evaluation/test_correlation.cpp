// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/evaluation/correlation.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace quadrille;

namespace {

using Values = std::vector<double>;

/// By its definition: tables of differences, doubly centred.
double plainDistanceCorrelation(const Values& x, const Values& y)
{
    const std::size_t n = x.size();
    const auto table = [n](const Values& v) {
        std::vector<Values> differences(n, Values(n));
        Values rows(n);
        double all = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                differences[i][j] = std::abs(v[i] - v[j]);
                rows[i] += differences[i][j] / static_cast<double>(n);
            }
            all += rows[i] / static_cast<double>(n);
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                differences[i][j] += all - rows[i] - rows[j];
        }
        return differences;
    };
    const auto a = table(x);
    const auto b = table(y);
    double ab = 0;
    double aa = 0;
    double bb = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            ab += a[i][j] * b[i][j];
            aa += a[i][j] * a[i][j];
            bb += b[i][j] * b[i][j];
        }
    }
    return std::sqrt(ab / std::sqrt(aa * bb));
}

struct Samples
{
    Values x;
    Values y;
};

/// \param levels  values are rounded to so many steps of 1, so that there are ties; 0: they are not.
Samples samplesOf(std::uint32_t seed, std::size_t n, double linear, int levels)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Samples samples;
    for (std::size_t i = 0; i < n; ++i) {
        const double x = normal(random);
        const double y = linear * x + x * x + normal(random);
        const auto rounded = [levels](double v) { return levels > 0 ? std::round(v * levels) / levels : v; };
        samples.x.push_back(rounded(x) + 100);
        samples.y.push_back(rounded(y));
    }
    return samples;
}

} // namespace

TEST(PearsonCorrelation, OfSmallSamples)
{
    EXPECT_DOUBLE_EQ(pearsonCorrelation(Values{1, 2, 3}, Values{5, 7, 9}), 1);
    EXPECT_DOUBLE_EQ(pearsonCorrelation(Values{1, 2, 3}, Values{3, 2, 1}), -1);
    // Means 2 and 2; covariance (−1·−2 + 0·1 + 1·1) = 3, variances 2 and 6.
    EXPECT_DOUBLE_EQ(pearsonCorrelation(Values{1, 2, 3}, Values{0, 3, 3}), 3 / std::sqrt(12.0));
}

TEST(PearsonCorrelation, IsZeroWhereNothingVaries)
{
    EXPECT_EQ(pearsonCorrelation(Values{1, 2, 3}, Values{4, 4, 4}), 0);
    EXPECT_EQ(pearsonCorrelation(Values{}, Values{}), 0);
}

TEST(DistanceCorrelation, OfThreePointsByHand)
{
    const Values x{0, 1, 3};
    const Values y{0, 1, 0};
    // Doubly centred, the differences are
    // (−4/3 0 4/3; 0 −2/3 2/3; 4/3 2/3 −2) and (−2/9 4/9 −2/9; 4/9 −8/9 4/9; −2/9 4/9 −2/9).
    const double ab = 4.0 / 3;
    const double aa = 32.0 / 3;
    const double bb = 16.0 / 9;
    EXPECT_NEAR(distanceCorrelation(x, y), std::sqrt(ab / std::sqrt(aa * bb)), 1e-14);
}

TEST(DistanceCorrelation, EqualsItsDefinition)
{
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const int levels = seed % 3 == 0 ? 2 : 0;
        const Samples samples = samplesOf(seed, 2 + 37 * seed, 0.2 * seed, levels);
        // Rounding grows with the number of points.
        EXPECT_NEAR(distanceCorrelation(samples.x, samples.y), plainDistanceCorrelation(samples.x, samples.y),
                    1e-10)
            << seed;
    }
}

TEST(DistanceCorrelation, IsOneForLinesAndZeroWhereNothingVaries)
{
    Samples samples = samplesOf(1, 500, 1, 0);
    for (std::size_t i = 0; i < samples.x.size(); ++i)
        samples.y[i] = 3 - 2 * samples.x[i];
    EXPECT_NEAR(distanceCorrelation(samples.x, samples.y), 1, 1e-9);
    EXPECT_EQ(distanceCorrelation(samples.x, Values(500, 7.0)), 0);
    EXPECT_EQ(distanceCorrelation(Values{}, Values{}), 0);
    EXPECT_EQ(distanceCorrelation(Values{1}, Values{2}), 0);
}

TEST(DistanceCorrelation, SeesDependencesThatPearsonDoesNot)
{
    Values x;
    Values y;
    for (int i = -100; i <= 100; ++i) {
        x.push_back(i);
        y.push_back(i * i);
    }
    EXPECT_NEAR(pearsonCorrelation(x, y), 0, 1e-12);
    EXPECT_GT(distanceCorrelation(x, y), 0.4);
}

TEST(DistanceCorrelation, CanBeCancelled)
{
    CancelToken token;
    token.cancel();
    const Samples samples = samplesOf(1, 10, 1, 0);
    EXPECT_THROW(distanceCorrelation(samples.x, samples.y, Progress(token)), Error);
}
