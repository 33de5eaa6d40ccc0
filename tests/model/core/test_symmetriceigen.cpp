// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/symmetriceigen.h"

#include <cmath>
#include <gtest/gtest.h>

namespace quadrille {

namespace {

TEST(SymmetricEigen, IsThatOfAMatrixSolvedByHandAndReadsItsLowerTriangleOnly)
{
    const Eigen::Matrix2d matrix{{2, 99}, {1, 2}};
    const SymmetricEigen solved = symmetricEigen(matrix);
    EXPECT_NEAR(solved.values(0), 1, 1e-15);
    EXPECT_NEAR(solved.values(1), 3, 1e-15);
    EXPECT_NEAR(std::abs(solved.vectors(0, 0)), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(solved.vectors(0, 0), -solved.vectors(1, 0), 1e-15);
    EXPECT_NEAR(solved.vectors(0, 1), solved.vectors(1, 1), 1e-15);
}

TEST(SymmetricEigen, MakesTheMatrixAgainWhereItIsSingularAndInRows)
{
    using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const RowMatrix root = RowMatrix::Random(9, 4);
    const RowMatrix matrix = root * root.transpose();
    const SymmetricEigen solved = symmetricEigen(matrix);
    EXPECT_LT((solved.vectors * solved.values.asDiagonal() * solved.vectors.transpose() - matrix).norm(),
              1e-13 * matrix.norm());
    EXPECT_LT(solved.values.head(5).cwiseAbs().maxCoeff(), 1e-13 * matrix.norm());
}

} // namespace

} // namespace quadrille
