// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/pca.h"
#include "model/core/random.h"
#include "tests/model/codeof.h"
#include "tests/model/plainalgebra.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

using namespace quadrille;
using namespace quadrille::test;
using test::codeOf;

namespace {

using SampleRows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

SampleSet samplesOf(const SampleRows& rows)
{
    return {rows.rows(), rows.cols(),
            [&rows](std::int64_t sample, std::int64_t first, std::span<float> values) {
                std::copy_n(rows.data() + sample * rows.cols() + first, values.size(), values.begin());
            }};
}

SampleRows randomRows(Eigen::Index count, Eigen::Index size, std::uint64_t seed)
{
    Random random(seed);
    SampleRows rows(count, size);
    for (float& value : rows.reshaped())
        value = static_cast<float>(random.normal());
    return rows;
}

SampleRows randomBytes(Eigen::Index count, Eigen::Index size, std::uint64_t seed)
{
    Random random(seed);
    SampleRows rows(count, size);
    for (float& value : rows.reshaped())
        value = static_cast<float>(random.next() % 256);
    return rows;
}

Eigen::Map<const SampleRows> componentsOf(const LinearSpace& space)
{
    return {space.components.data(), space.count(), space.size()};
}

/// mean + coefficientsᵀ · components.
Eigen::MatrixXd modelled(const LinearSpace& space)
{
    using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Table> coefficients(space.coefficients.data(), space.samples(), space.count());
    const Eigen::Map<const Eigen::RowVectorXf> mean(space.mean.data(), space.size());
    return (coefficients * componentsOf(space).cast<double>()).rowwise() + mean.cast<double>();
}

void expectDecompositionOf(const SampleRows& rows, const LinearSpace& space)
{
    const Eigen::MatrixXd wanted = rows.cast<double>();
    const Eigen::RowVectorXd mean = wanted.colwise().mean();
    const SingularVectors svd = singularVectors(wanted.rowwise() - mean);
    const double largest = svd.values[0];
    for (std::size_t k = 0; k < space.eigenvalues.size(); ++k) {
        const double value = svd.values[static_cast<Eigen::Index>(k)];
        // The Gram matrix squares what was rounded.
        EXPECT_NEAR(std::sqrt(space.eigenvalues[k] * static_cast<double>(rows.rows())), value,
                    1e-7 * largest);
    }
    for (Eigen::Index c = 0; c < space.count(); ++c) {
        const Eigen::VectorXd found = componentsOf(space).row(c).cast<double>();
        EXPECT_NEAR(std::abs(found.dot(svd.right.col(c))), 1, 1e-5) << c; // single precision
        Eigen::Index place = 0;
        found.cwiseAbs().maxCoeff(&place);
        EXPECT_GT(found[place], 0);
    }
    const Eigen::MatrixXd products =
        componentsOf(space).cast<double>() * componentsOf(space).cast<double>().transpose();
    EXPECT_LT((products - Eigen::MatrixXd::Identity(space.count(), space.count())).cwiseAbs().maxCoeff(),
              1e-5);
    const Eigen::Map<const Eigen::RowVectorXf> foundMean(space.mean.data(), space.size());
    EXPECT_LT((foundMean.cast<double>() - mean).cwiseAbs().maxCoeff(),
              1e-5 * (1 + mean.cwiseAbs().maxCoeff()));
}

} // namespace

TEST(PrincipalComponents, AreThoseOfACaseDoneByHand)
{
    SampleRows rows(4, 3);
    rows << 4, 1, 5, -2, 1, 5, 1, 3, 5, 1, -1, 5;
    const LinearSpace space = principalComponents(samplesOf(rows), 2);
    EXPECT_EQ(space.mean, (std::vector<float>{1, 1, 5}));
    ASSERT_EQ(space.eigenvalues.size(), 2U);
    EXPECT_NEAR(space.eigenvalues[0], 18.0 / 4, 1e-12);
    EXPECT_NEAR(space.eigenvalues[1], 8.0 / 4, 1e-12);
    const SampleRows wanted = (SampleRows(2, 3) << 1, 0, 0, 0, 1, 0).finished();
    EXPECT_LT((componentsOf(space) - wanted).cwiseAbs().maxCoeff(), 1e-6F);
    const std::vector<double> coefficients{3, 0, -3, 0, 0, 2, 0, -2};
    for (std::size_t k = 0; k < coefficients.size(); ++k)
        EXPECT_NEAR(space.coefficients[k], coefficients[k], 1e-12);
}

TEST(PrincipalComponents, AreThoseOfASingularValueDecomposition)
{
    for (const auto& [count, size] : {std::pair{5, 40}, {12, 1000}, {30, 7}, {9, 70000}}) {
        const SampleRows rows = randomRows(count, size, 7);
        expectDecompositionOf(rows, principalComponents(samplesOf(rows), 5));
        const SampleRows bytes = randomBytes(count, size, 8);
        expectDecompositionOf(bytes, principalComponents(samplesOf(bytes), 5));
    }
}

TEST(PrincipalComponents, GiveTheSamplesBackWhenAllAreKept)
{
    const SampleRows rows = randomBytes(10, 3000, 2);
    const LinearSpace space = principalComponents(samplesOf(rows), 100);
    EXPECT_EQ(space.count(), 9);
    EXPECT_EQ(space.samples(), 10);
    // Of values up to 255 in single precision.
    EXPECT_LT((modelled(space) - rows.cast<double>()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(PrincipalComponents, AreAsManyAsTheRank)
{
    const SampleRows rows = randomRows(20, 3, 4) * randomRows(3, 800, 5);
    const LinearSpace space = principalComponents(samplesOf(rows), 10);
    EXPECT_EQ(space.count(), 3);
    EXPECT_EQ(space.eigenvalues.size(), 3U);
    expectDecompositionOf(rows, space);
    const SampleRows bytes = randomBytes(3, 800, 5).replicate(7, 1);
    EXPECT_EQ(principalComponents(samplesOf(bytes), 10).count(), 2);
}

TEST(PrincipalComponents, FindWeakDirectionsBesideAStrongOne)
{
    // One direction is 3000 times as strong as the next.
    SampleRows rows = 3000 * randomRows(12, 1, 4) * randomRows(1, 900, 5);
    rows += randomRows(12, 2, 6) * randomRows(2, 900, 7);
    const LinearSpace space = principalComponents(samplesOf(rows), 3);
    ASSERT_EQ(space.count(), 3);
    expectDecompositionOf(rows, space);
}

TEST(PrincipalComponents, OfOneSampleAndOfEqualOnesAreNone)
{
    const SampleRows one = randomRows(1, 50, 1);
    for (const SampleRows& rows :
         {one, SampleRows(one.replicate(6, 1)), SampleRows(SampleRows::Zero(3, 9))}) {
        const LinearSpace space = principalComponents(samplesOf(rows), 4);
        EXPECT_EQ(space.count(), 0);
        EXPECT_TRUE(space.eigenvalues.empty());
        for (std::int64_t k = 0; k < space.size(); ++k)
            EXPECT_FLOAT_EQ(space.mean[static_cast<std::size_t>(k)], rows(0, k));
    }
}

TEST(PrincipalComponents, DoNotDependOnThreads)
{
    const SampleRows rows = randomRows(40, 200000, 3);
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return principalComponents(samplesOf(rows), 6); });
    };
    const LinearSpace one = with(1);
    const LinearSpace several = with(4);
    EXPECT_EQ(one.components, several.components);
    EXPECT_EQ(one.eigenvalues, several.eigenvalues);
    EXPECT_EQ(one.coefficients, several.coefficients);
    EXPECT_EQ(one.mean, several.mean);
}

TEST(PrincipalComponents, CanBeCancelledAndRefuseNothing)
{
    const SampleRows rows = randomRows(8, 100000, 3);
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.3)
            token.cancel();
    });
    EXPECT_EQ(codeOf([&] { principalComponents(samplesOf(rows), 2, progress); }), ErrorCode::Cancelled);
    EXPECT_EQ(codeOf([&] { principalComponents(samplesOf(SampleRows(0, 3)), 2); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { principalComponents(samplesOf(SampleRows(3, 0)), 2); }), ErrorCode::BadArgument);
}
