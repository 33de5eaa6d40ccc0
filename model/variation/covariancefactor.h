// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm.h"

namespace quadrille {

/// Lower Cholesky factor of a covariance matrix. Where rounding left it indefinite, its diagonal is raised by
/// as little as is needed, at least 1e-14 of its mean.
RowMatrix covarianceFactor(const RowMatrix& covariance);

} // namespace quadrille
