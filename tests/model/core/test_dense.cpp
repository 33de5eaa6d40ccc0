// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

using namespace quadrille;

namespace {

using Plain = DenseMatrix::Plain;

/// Sizes with and without a remainder to eight, and one that is larger than what fits the fastest cache.
constexpr int sizes[] = {1, 2, 7, 8, 9, 37, 160, 203};

Plain randomMatrix(Eigen::Index rows, Eigen::Index columns)
{
    std::mt19937 engine(static_cast<unsigned>(rows * 1000 + columns));
    std::uniform_real_distribution<double> value(-1, 1);
    return Plain::NullaryExpr(rows, columns, [&] { return value(engine); });
}

Plain randomTriangle(Eigen::Index size, int which)
{
    Plain triangle = randomMatrix(size, size + which).leftCols(size).triangularView<Eigen::Lower>();
    triangle.diagonal().array() += 2;
    return triangle;
}

/// Well conditioned, so that 1e-12 is far above what rounding leaves.
Plain randomSymmetric(Eigen::Index size)
{
    const Plain factor = randomMatrix(size, size + 3);
    Plain product = factor * factor.transpose() / static_cast<double>(size);
    product.diagonal().array() += 0.2;
    return product;
}

Plain lowerOf(const Plain& matrix)
{
    return matrix.triangularView<Eigen::Lower>();
}

void expectNear(const Plain& value, const Plain& expected, double tolerance = 1e-12)
{
    ASSERT_EQ(value.rows(), expected.rows());
    ASSERT_EQ(value.cols(), expected.cols());
    EXPECT_LE((value - expected).norm(), tolerance * expected.norm()) << expected.rows() << " rows";
}

} // namespace

TEST(DenseMatrix, FillsUpWithZerosAndKeepsWhatItWasMadeOf)
{
    const Plain values = randomMatrix(5, 11);
    const DenseMatrix matrix(values);
    EXPECT_EQ(matrix.filledRows(), 8);
    EXPECT_EQ(matrix.filledColumns(), 16);
    EXPECT_EQ(Plain(matrix.view()), values);
    EXPECT_EQ(matrix(4, 10), values(4, 10));
    EXPECT_EQ(matrix.row(4)[11], 0);
    EXPECT_EQ(matrix.row(7)[15], 0);
    // Rows that are a power of two apart would share few sets of the cache.
    EXPECT_EQ(DenseMatrix(8, 1024).stride() % 16, 8);
}

TEST(DenseCholesky, TwoByTwoByHand)
{
    // (4 2; 2 5) = (2 0; 1 2)·(2 1; 0 2); what stands above the diagonal is not read.
    Plain values(2, 2);
    values << 4, 99, 2, 5;
    DenseMatrix factor(values);
    ASSERT_TRUE(factoriseCholesky(factor));
    EXPECT_EQ(factor(0, 0), 2);
    EXPECT_EQ(factor(0, 1), 0);
    EXPECT_EQ(factor(1, 0), 1);
    EXPECT_EQ(factor(1, 1), 2);
    EXPECT_DOUBLE_EQ(logDeterminant(factor), std::log(16));
}

TEST(DenseCholesky, AgreesWithEigen)
{
    for (const int size : sizes) {
        const Plain a = randomSymmetric(size);
        DenseMatrix factor(a);
        ASSERT_TRUE(factoriseCholesky(factor));
        expectNear(factor.view(), a.llt().matrixL());
        EXPECT_NEAR(logDeterminant(factor), std::log(a.determinant()), 1e-10 * size);

        const Plain b = randomMatrix(size, 13);
        DenseMatrix x(b);
        solveLower(factor, x);
        expectNear(x.view(), a.llt().matrixL().solve(b));
        solveLowerTransposed(factor, x);
        expectNear(x.view(), a.llt().solve(b));

        DenseMatrix inverse(size, size);
        invertLower(factor, inverse);
        expectNear(factor.view() * inverse.view(), Plain::Identity(size, size));
    }
}

TEST(DenseCholesky, TellsWhatIsNotPositiveDefinite)
{
    for (const int size : {2, 20}) {
        DenseMatrix ones(Plain(Plain::Ones(size, size)));
        EXPECT_FALSE(factoriseCholesky(ones));
        Plain indefinite = Plain::Identity(size, size);
        indefinite(size - 1, size - 1) = -1;
        DenseMatrix negative(indefinite);
        EXPECT_FALSE(factoriseCholesky(negative));
        indefinite(size - 1, size - 1) = std::numeric_limits<double>::quiet_NaN();
        DenseMatrix undefined(indefinite);
        EXPECT_FALSE(factoriseCholesky(undefined));
    }
    // Far from singular in double precision: a noise of 1e-12 of the variance.
    Plain nearly = Plain::Ones(30, 30);
    nearly.diagonal().array() += 1e-12;
    DenseMatrix factor(nearly);
    EXPECT_TRUE(factoriseCholesky(factor));
}

TEST(DenseProducts, AgreeWithEigen)
{
    for (const int size : sizes) {
        const Plain a = randomTriangle(size, 1);
        const Plain b = randomTriangle(size, 2);
        const DenseMatrix left(a);
        const DenseMatrix right(b);
        DenseMatrix product(size, size);
        multiplyLower(left, right, product);
        expectNear(product.view(), a * b);
        squareLower(left, product);
        expectNear(lowerOf(product.view()), lowerOf(a * a.transpose()));
        squareLowerTransposed(left, product);
        expectNear(lowerOf(product.view()), lowerOf(a.transpose() * a));
        multiplySymmetric(left, right, product);
        expectNear(lowerOf(product.view()), lowerOf(a.transpose() * b + b.transpose() * a));
    }
}

TEST(DenseExponentials, AreExactToRounding)
{
    std::vector<double> values{0, 1, -1, -0.0, -1e-300, -700, 700};
    for (double x = -60; x < 60; x += 0.0371)
        values.push_back(x);
    std::vector<double> results = values;
    exponentials(results);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(results[i] / std::exp(values[i]), 1, 1e-15) << values[i];
    EXPECT_EQ(results[0], 1);
}

TEST(DenseExponentials, EndWhereNumbersEnd)
{
    std::vector<double> values{-1e300, -std::numeric_limits<double>::infinity(), -745,
                               std::numeric_limits<double>::quiet_NaN()};
    exponentials(values);
    EXPECT_LT(values[0], 1e-300);
    EXPECT_GE(values[0], 0);
    EXPECT_LT(values[1], 1e-300);
    EXPECT_LT(values[2], 1e-300);
    EXPECT_TRUE(std::isnan(values[3]));
}
