// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace quadrille {

/// Eigenvalues in rising order, n, and eigenvectors of length 1 in the columns, n × n.
struct SymmetricEigen
{
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// Eigenvalues and eigenvectors of a symmetric matrix, n × n with n ≥ 1; only its lower triangle is read. For
/// sizes that are known when the program runs: one piece of the program for all, as Eigen's takes long to
/// compile. Not finite where the matrix is not.
SymmetricEigen symmetricEigen(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

} // namespace quadrille
