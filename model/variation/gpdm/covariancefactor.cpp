// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/gpdm/covariancefactor.h"

#include "model/core/densekernels.h"

namespace quadrille {

DenseMatrix covarianceFactor(const DenseMatrix& covariance, double scale)
{
    DenseMatrix factor = covariance;
    bool isDefinite = factoriseCholesky(factor);
    for (double rise = 1e-14; !isDefinite && rise < 1; rise *= 10) {
        factor = covariance;
        factor.view().diagonal().array() += rise * scale;
        isDefinite = factoriseCholesky(factor);
    }
    return factor;
}

} // namespace quadrille
