// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/plainalgebra.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace quadrille::test {

SingularVectors singularVectors(const Eigen::MatrixXd& matrix)
{
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
    return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& matrix)
{
    return matrix.inverse();
}

double determinantOf(const Eigen::MatrixXd& matrix)
{
    return matrix.determinant();
}

Eigen::MatrixXd solutionOf(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
    return matrix.partialPivLu().solve(right);
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right)
{
    return matrix.completeOrthogonalDecomposition().solve(right);
}

} // namespace quadrille::test
