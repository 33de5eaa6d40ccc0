// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/kernelregression.h"
#include "model/core/random.h"
#include "tests/model/codeof.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Places on a line.
struct Line
{
    explicit Line(std::vector<double> at) : places(std::move(at)) {}

    Eigen::MatrixXd squared() const
    {
        const auto count = std::ssize(places);
        Eigen::MatrixXd all(count, count);
        for (Eigen::Index i = 0; i < count; ++i)
            all.row(i) = from(places[static_cast<std::size_t>(i)]).transpose();
        return all;
    }
    Eigen::VectorXd from(double place) const
    {
        const Eigen::Map<const Eigen::ArrayXd> all(places.data(), std::ssize(places));
        return (all - place).square();
    }

    std::vector<double> places;
};

/// Three takes that go to and fro over one line, at other paces.
struct ThreeTakes
{
    ThreeTakes()
    {
        for (int take = 0; take < 3; ++take) {
            for (int frame = 0; frame < 20; ++frame) {
                line.places.push_back(std::sin(0.3 * frame * (1 + 0.2 * take) + take));
                takes.push_back(take);
            }
        }
    }
    Eigen::MatrixXd valuesBy(const std::function<double(double)>& function) const
    {
        Eigen::MatrixXd values(std::ssize(line.places), 2);
        for (Eigen::Index i = 0; i < values.rows(); ++i) {
            values(i, 0) = function(line.places[static_cast<std::size_t>(i)]);
            values(i, 1) = 5 - 2 * values(i, 0);
        }
        return values;
    }

    Line line{{}};
    std::vector<std::int64_t> takes;
};

} // namespace

TEST(KernelRegression, IsThatOfTwoPlacesByHand)
{
    const Line line({0, 3});
    Eigen::MatrixXd values(2, 1);
    values << 7, 3;
    const double length = 2;
    const double trust = 4;
    const KernelRegression regression(line.squared(), values, {length, trust});
    // Both are 2 from their mean 5, on other sides: weights are ±2 / (1 + trust · (1 − kernel)).
    const double kernel = std::exp(-9 / 8.0);
    const double weight = 2 / (1 + trust * (1 - kernel));
    EXPECT_NEAR(regression.at(line.from(0))[0], 5 + trust * weight * (1 - kernel), 1e-12);
    EXPECT_NEAR(regression.at(line.from(3))[0], 5 - trust * weight * (1 - kernel), 1e-12);
    EXPECT_NEAR(regression.at(line.from(1.5))[0], 5, 1e-12);
    EXPECT_NEAR(regression.at(line.from(1))[0],
                5 + trust * weight * (std::exp(-1 / 8.0) - std::exp(-4 / 8.0)), 1e-12);
}

TEST(KernelRegression, ComesBackToTheMeanFarAway)
{
    const Line line({0, 1, 2});
    Eigen::MatrixXd values(3, 2);
    values << 1, 10, 5, 20, 9, 60;
    const KernelRegression regression(line.squared(), values, {1, 1e6});
    EXPECT_NEAR(regression.at(line.from(1))[0], 5, 1e-3);
    EXPECT_NEAR(regression.at(line.from(2))[1], 60, 1e-3);
    EXPECT_NEAR(regression.at(line.from(50))[0], 5, 1e-12);
    EXPECT_NEAR(regression.at(line.from(50))[1], 30, 1e-12);
    const KernelRegression mean(line.squared(), values, {1, 0});
    EXPECT_EQ(mean.at(line.from(2))[1], 30) << "nothing is trusted";
}

TEST(KernelRegression, FindsWhatDependsOnPlaces)
{
    const ThreeTakes takes;
    const Eigen::MatrixXd values = takes.valuesBy([](double place) { return std::cos(3 * place); });
    const RegressionScale scale = foundScale(takes.line.squared(), values, takes.takes);
    EXPECT_GT(scale.trust, 100);
    const KernelRegression regression(takes.line.squared(), values, scale);
    for (double place = -0.9; place <= 0.9; place += 0.1)
        EXPECT_NEAR(regression.at(takes.line.from(place))[0], std::cos(3 * place), 0.05) << place;
}

TEST(KernelRegression, KeepsToTheMeanWhereValuesAreNoise)
{
    const ThreeTakes takes;
    Random random(3);
    const Eigen::MatrixXd values = takes.valuesBy([&](double) { return random.normal(); });
    const RegressionScale scale = foundScale(takes.line.squared(), values, takes.takes);
    const KernelRegression regression(takes.line.squared(), values, scale);
    const Eigen::VectorXd mean = values.colwise().mean();
    for (double place = -0.9; place <= 0.9; place += 0.1)
        EXPECT_LT((regression.at(takes.line.from(place)) - mean).norm(), 0.3 * std::sqrt(5.0)) << place;
}

TEST(KernelRegression, LeavesOutPartsOfATakeThatIsAlone)
{
    const ThreeTakes takes;
    const std::vector<std::int64_t> one(takes.takes.size(), 7);
    EXPECT_GT(
        foundScale(takes.line.squared(), takes.valuesBy([](double place) { return place * place; }), one)
            .trust,
        100);
    Eigen::MatrixXd inTime(60, 1);
    for (Eigen::Index i = 0; i < 60; ++i)
        inTime(i, 0) = i < 30 ? -1 : 1;
    EXPECT_EQ(foundScale(takes.line.squared(), inTime, one).trust, 0) << "whatever the place";
}

TEST(KernelRegression, FindsNoScaleWhereThereIsNone)
{
    const RegressionScale mean;
    const std::vector<std::int64_t> two{0, 1};
    EXPECT_EQ(foundScale(Line({1}).squared(), Eigen::MatrixXd::Ones(1, 3), std::vector<std::int64_t>{0}),
              mean);
    EXPECT_EQ(foundScale(Line({2, 2}).squared(), Eigen::MatrixXd::Random(2, 3), two), mean) << "equal poses";
    EXPECT_EQ(foundScale(Line({1, 2}).squared(), Eigen::MatrixXd(2, 0), two), mean) << "no components";
    EXPECT_EQ(foundScale(Line({1, 2}).squared(), Eigen::MatrixXd::Ones(2, 1), two).trust, 0);
    const KernelRegression regression(Line({1}).squared(), Eigen::MatrixXd::Constant(1, 2, 4), mean);
    EXPECT_EQ(regression.at(Line({1}).from(9)), Eigen::Vector2d(4, 4));
    const KernelRegression same(Line({2, 2}).squared(), Eigen::Vector2d(1, 3), {1, 100});
    EXPECT_NEAR(same.at(Line({2, 2}).from(2))[0], 2, 1e-12);
}

TEST(KernelRegression, FindsTheSameForAnyNumberOfThreadsAndTakes)
{
    ThreeTakes takes;
    const Eigen::MatrixXd values = takes.valuesBy([](double place) { return place * place; });
    const auto found = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return foundScale(takes.line.squared(), values, takes.takes); });
    };
    const RegressionScale one = found(1);
    EXPECT_EQ(found(4), one);
    EXPECT_GT(one.trust, 1);
    std::iota(takes.takes.begin(), takes.takes.end(), 0);
    EXPECT_GT(found(2).trust, one.trust / 100) << "more takes than are left out one by one";
}

TEST(KernelRegression, CanBeCancelled)
{
    const ThreeTakes takes;
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.3)
            token.cancel();
    });
    const Eigen::MatrixXd values = takes.valuesBy([](double place) { return place; });
    EXPECT_EQ(codeOf([&] { foundScale(takes.line.squared(), values, takes.takes, progress); }),
              ErrorCode::Cancelled);
}
