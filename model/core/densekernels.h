// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/densematrix.h"

#include <span>

namespace quadrille {

// Dense algebra for wide vectors, one thread. Triangles are lower ones; above their diagonal there is zero.

/// The Cholesky factor L of A = L·Lᵀ in its place; only the lower triangle of A is read. What fills the
/// matrix up gets ones on its diagonal.
/// \return false where A is not positive definite to working precision; the matrix is then of no use.
bool factoriseCholesky(DenseMatrix& a);

/// ln|L·Lᵀ|.
double logDeterminant(const DenseMatrix& factor);

/// B becomes L⁻¹·B.
void solveLower(const DenseMatrix& factor, DenseMatrix& b);

/// B becomes L⁻ᵀ·B.
void solveLowerTransposed(const DenseMatrix& factor, DenseMatrix& b);

/// L⁻¹, as large as L.
void invertLower(const DenseMatrix& factor, DenseMatrix& inverse);

/// A·B of two lower triangles, lower as well, as large as they are.
void multiplyLower(const DenseMatrix& a, const DenseMatrix& b, DenseMatrix& product);

/// The lower triangle of A·Aᵀ for a lower triangle A.
void squareLower(const DenseMatrix& a, DenseMatrix& product);

/// The lower triangle of Aᵀ·A for a lower triangle A.
void squareLowerTransposed(const DenseMatrix& a, DenseMatrix& product);

/// The lower triangle of Aᵀ·B + Bᵀ·A for lower triangles A and B.
void multiplySymmetric(const DenseMatrix& a, const DenseMatrix& b, DenseMatrix& product);

/// Each value becomes its exponential, 4e-16 of itself; below −708 it is the smallest normal number or so.
void exponentials(std::span<double> values);

} // namespace quadrille
