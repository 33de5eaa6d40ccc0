// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "latentloops.h"
#include "model/variation/gpdm/hmc.h"
#include "tests/model/codeof.h"
#include "tests/model/plainalgebra.h"

#include <limits>
#include <numbers>

using namespace quadrille;
using namespace quadrille::test;

namespace {

struct Gaussian
{
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd precision;

    HmcEnergy energy() const
    {
        return [this](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
            gradient = precision * (x - mean);
            return 0.5 * gradient.dot(x - mean);
        };
    }
};

/// Neighbours correlate by 0.95, and variances differ by a factor of 100.
Gaussian correlatedGaussian(Eigen::Index dimensions)
{
    Gaussian target{.mean = Eigen::VectorXd::LinSpaced(dimensions, -2, 3),
                    .covariance = Eigen::MatrixXd(dimensions, dimensions)};
    for (Eigen::Index i = 0; i < dimensions; ++i)
        for (Eigen::Index j = 0; j < dimensions; ++j) {
            const auto size = [&](Eigen::Index k) {
                return std::pow(10.0, static_cast<double>(k) / static_cast<double>(dimensions - 1) - 0.5);
            };
            target.covariance(i, j) =
                size(i) * size(j) * std::pow(0.95, std::abs(static_cast<double>(i - j)));
        }
    target.precision = inverseOf(target.covariance);
    return target;
}

struct ChainMoments
{
    Eigen::VectorXd mean;
    Eigen::MatrixXd covariance;
};

ChainMoments chainMomentsOf(const std::vector<Eigen::VectorXd>& samples)
{
    Eigen::MatrixXd values(samples.front().size(), std::ssize(samples));
    for (Eigen::Index i = 0; i < values.cols(); ++i)
        values.col(i) = samples[static_cast<std::size_t>(i)];
    ChainMoments moments{.mean = values.rowwise().mean()};
    values.colwise() -= moments.mean;
    moments.covariance = values * values.transpose() / static_cast<double>(values.cols());
    return moments;
}

/// Standard errors with n independent draws are √(σ²/n) and √((c_ij² + c_ii·c_jj)/n); five are allowed, for
/// as many draws as the chain says that it has at least.
void expectMoments(const HmcChain& chain, const Gaussian& target)
{
    const double n = std::min(chain.report.effectiveSampleSize, static_cast<double>(chain.samples.size()));
    const ChainMoments found = chainMomentsOf(chain.samples);
    for (Eigen::Index i = 0; i < target.mean.size(); ++i) {
        EXPECT_NEAR(found.mean[i], target.mean[i], 5 * std::sqrt(target.covariance(i, i) / n)) << i;
        for (Eigen::Index j = 0; j <= i; ++j) {
            const double expected = target.covariance(i, j);
            const double error =
                std::sqrt((expected * expected + target.covariance(i, i) * target.covariance(j, j)) / n);
            EXPECT_NEAR(found.covariance(i, j), expected, 5 * error) << i << ' ' << j;
        }
    }
}

} // namespace

TEST(Hmc, drawsFromACorrelatedGaussianWithTheMassOfItsPrecision)
{
    const Gaussian target = correlatedGaussian(20);
    const HmcChain chain =
        drawByHmc(target.energy(), Eigen::VectorXd::Zero(20), target.precision, 2000, 1, {.thinning = 1});
    ASSERT_EQ(chain.samples.size(), 2000u);
    EXPECT_GE(chain.report.effectiveSampleSize, 2000);
    EXPECT_GE(chain.report.acceptance, 0.6);
    EXPECT_LE(chain.report.acceptance, 0.9);
    expectMoments(chain, target);
}

TEST(Hmc, drawsFromACorrelatedGaussianWithTheMassOfOne)
{
    const Gaussian target = correlatedGaussian(6);
    const HmcChain chain =
        drawByHmc(target.energy(), target.mean, Eigen::MatrixXd::Identity(6, 6), 1500, 2, {.thinning = 2});
    EXPECT_GE(chain.report.acceptance, 0.6);
    EXPECT_LE(chain.report.acceptance, 0.9);
    expectMoments(chain, target);
}

// E = x⁴/4: ⟨x²⟩ = 2·Γ(3/4)/Γ(1/4) and ⟨x⁴⟩ = 1; the standard error of x⁴ is √(Var x⁴/n) = 2/√n.
TEST(Hmc, drawsFromADensityThatIsNotGaussian)
{
    const HmcEnergy energy = [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        gradient = x.array().cube();
        return x.array().pow(4).sum() / 4;
    };
    const HmcChain chain = drawByHmc(energy, Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Identity(1, 1), 4000,
                                     5, {.thinning = 2});
    double second = 0;
    double fourth = 0;
    for (const Eigen::VectorXd& x : chain.samples) {
        second += x[0] * x[0] / 4000;
        fourth += std::pow(x[0], 4) / 4000;
    }
    EXPECT_NEAR(second, 2 * std::tgamma(0.75) / std::tgamma(0.25), 0.05);
    EXPECT_NEAR(fourth, 1, 5 * 2 / std::sqrt(4000));
}

// A wall: the density is none where x < 0, so that what remains is half a normal distribution.
TEST(Hmc, staysWhereTheEnergyIsFinite)
{
    const HmcEnergy energy = [](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        gradient = x;
        return x[0] < 0 ? std::numeric_limits<double>::infinity() : 0.5 * x.squaredNorm();
    };
    const HmcChain chain =
        drawByHmc(energy, Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Identity(1, 1), 3000, 5);
    double mean = 0;
    for (const Eigen::VectorXd& x : chain.samples) {
        EXPECT_GE(x[0], 0);
        mean += x[0] / 3000;
    }
    EXPECT_NEAR(mean, std::sqrt(2 / std::numbers::pi), 0.08);
}

TEST(Hmc, growsItsChainUntilTheSamplesAreWorthTheirNumber)
{
    const Gaussian target = correlatedGaussian(12);
    const HmcSettings settings{.leapfrogSteps = 2, .thinning = 1};
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(12, 12);
    const HmcChain chain = drawByHmc(target.energy(), target.mean, one, 40, 3, settings);
    EXPECT_EQ(chain.samples.size(), 40u);
    EXPECT_GT(chain.report.thinning, 1);
    EXPECT_LE(chain.report.thinning, 16);
    EXPECT_EQ(chain.report.energies.size(), 40u * static_cast<unsigned>(chain.report.thinning));
    EXPECT_TRUE(chain.report.effectiveSampleSize >= 40 || chain.report.thinning == 16);
}

TEST(Hmc, theSameSeedGivesTheSameSamples)
{
    const Gaussian target = correlatedGaussian(5);
    const auto draw = [&](std::uint64_t seed) {
        return drawByHmc(target.energy(), target.mean, target.precision, 7, seed).samples;
    };
    EXPECT_EQ(draw(4), draw(4));
    EXPECT_NE(draw(4), draw(5));
}

TEST(Hmc, hasNothingToDrawWithoutCoordinatesOrCount)
{
    const HmcEnergy energy = [](const Eigen::VectorXd&, Eigen::VectorXd&) { return 0.0; };
    EXPECT_EQ(drawByHmc(energy, Eigen::VectorXd(), Eigen::MatrixXd(), 3, 1).samples.size(), 3u);
    EXPECT_TRUE(
        drawByHmc(energy, Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Ones(1, 1), 0, 1).samples.empty());
}

TEST(Hmc, stopsWithinOneStepOfACancelledTrajectory)
{
    CancelToken token;
    int evaluations = 0;
    const HmcEnergy energy = [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
        gradient = x;
        if (++evaluations == 50)
            token.cancel();
        return 0.5 * x.squaredNorm();
    };
    EXPECT_EQ(codeOf([&] {
                  drawByHmc(energy, Eigen::VectorXd::Ones(2), Eigen::MatrixXd::Identity(2, 2), 100000, 1, {},
                            Progress(token));
              }),
              ErrorCode::Cancelled);
    EXPECT_EQ(evaluations, 50);
}

// Each value a·last + √(1 − a²)·noise: n·(1 − a)/(1 + a) independent ones.
TEST(EffectiveSampleSize, isThatOfAnAutoregressiveSeries)
{
    Random random(9);
    for (const double a : {0.0, 0.5, 0.9}) {
        Eigen::VectorXd series(20000);
        double value = 0;
        for (double& entry : series)
            entry = value = a * value + std::sqrt(1 - a * a) * random.normal();
        EXPECT_NEAR(effectiveSampleSize(series) / 20000, (1 - a) / (1 + a), 0.15 * (1 - a) / (1 + a)) << a;
        EXPECT_NEAR(lag1Autocorrelation(series), a, 0.03);
    }
}

TEST(EffectiveSampleSize, knowsShortAndConstantSeries)
{
    EXPECT_EQ(effectiveSampleSize(Eigen::VectorXd()), 0);
    EXPECT_EQ(effectiveSampleSize(Eigen::VectorXd::Ones(1)), 1);
    EXPECT_EQ(effectiveSampleSize(Eigen::VectorXd::Ones(30)), 1);
    EXPECT_EQ(lag1Autocorrelation(Eigen::VectorXd::Ones(30)), 0);
    const Eigen::VectorXd alternating{{1, -1, 1, -1, 1, -1, 1, -1}};
    EXPECT_EQ(effectiveSampleSize(alternating), 8);
    EXPECT_LT(lag1Autocorrelation(alternating), -0.8);
}
