// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/symmetriceigen.h"

#include <Eigen/Eigenvalues>

namespace quadrille {

SymmetricEigen symmetricEigen(const Eigen::Ref<const Eigen::MatrixXd>& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace quadrille
