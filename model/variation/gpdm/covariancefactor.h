// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/densematrix.h"

namespace quadrille {

/// Lower Cholesky factor of a covariance matrix. Where rounding left it indefinite, its diagonal is raised by
/// as little as is needed, at least 1e-14 of `scale`.
/// \param scale  size of the terms that the covariance is a sum or difference of.
DenseMatrix covarianceFactor(const DenseMatrix& covariance, double scale);

} // namespace quadrille
