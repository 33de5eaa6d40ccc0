// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/densematrix.h"

namespace quadrille {

// Kernel matrices of latent positions and what follows from the derivatives by them. Points are dimensions ×
// positions, so that loops over positions are vectors. Of symmetric matrices only the lower triangle is read
// and written.

/// exp(−½·precision·‖x_i − x_j‖²).
void radialKernel(const DenseMatrix& points, double precision, DenseMatrix& kernel);

/// radial·kernel + linear·x_iᵀx_j, and the noise on the diagonal.
void assembleKernel(const DenseMatrix& points, const DenseMatrix& kernel, double radial, double linear,
                    double noise, DenseMatrix& sum);

/// Sums over all i, j of derivative · kernel, and of derivative · kernel · ‖x_i − x_j‖².
struct RadialSums
{
    double value = 0;
    double squared = 0;
};

/// Adds the derivatives by the points to `gradient`, which is as large as they are.
/// \param derivative  by the elements of the matrix that scale·kernel is a part of, each taken on its own.
/// \param kernel  of radialKernel with the same precision.
/// \param row  working memory for as many numbers as there are points.
RadialSums addRadialGradient(const DenseMatrix& points, const DenseMatrix& derivative,
                             const DenseMatrix& kernel, double scale, double precision, double* row,
                             DenseMatrix& gradient);

/// The same for scale·x_iᵀx_j. \return the sum over all i, j of derivative · x_iᵀx_j.
double addLinearGradient(const DenseMatrix& points, const DenseMatrix& derivative, double scale,
                         DenseMatrix& gradient);

} // namespace quadrille
