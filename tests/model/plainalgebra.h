// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace quadrille::test {

// What tests and plain references ask of dense matrices whose sizes are known when they run, by Eigen's
// decompositions. Each of these takes seconds to compile wherever it is used, so they are compiled once.

/// matrix = left · diagonal(values) · rightᵀ for m × n and k = min(m, n): left is m × k, right n × k, values
/// fall.
struct SingularVectors
{
    Eigen::MatrixXd left;
    Eigen::VectorXd values;
    Eigen::MatrixXd right;
};

SingularVectors singularVectors(const Eigen::MatrixXd& matrix);

/// The inverse of a square matrix that has one.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& matrix);

double determinantOf(const Eigen::MatrixXd& matrix);

/// x of matrix · x = right for a square matrix that has an inverse.
Eigen::MatrixXd solutionOf(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The shortest x for which matrix · x is nearest to right.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

} // namespace quadrille::test
