// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/covariancefactor.h"

#include <Eigen/Cholesky>
#include <limits>

namespace quadrille {

RowMatrix covarianceFactor(const RowMatrix& covariance)
{
    Eigen::LLT<RowMatrix> factor(covariance);
    if (covariance.size() == 0)
        return covariance;
    const double mean = std::max(covariance.diagonal().mean(), std::numeric_limits<double>::min());
    for (double rise = 1e-14; factor.info() != Eigen::Success && rise < 1; rise *= 10) {
        RowMatrix raised = covariance;
        raised.diagonal().array() += rise * mean;
        factor.compute(raised);
    }
    return factor.matrixL();
}

} // namespace quadrille
