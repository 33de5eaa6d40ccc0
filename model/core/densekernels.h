// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/densematrix.h"

#include <span>

namespace quadrille {

// Dense algebra for wide vectors, one thread. Triangles are lower ones; above their diagonal there is zero.
//
// Why not Eigen: compiled as the rest of the program is, for any x86-64, it takes for 160 to 400 rows
// (bench_cholesky) 2.4 times as long to factorise, 2 to 3 times to solve for three and more columns, 1.2
// times for a single one, and 6 to 10 times for inverses, products and exponentials. Compiled for AVX2 it
// would still take 1.2 to 1.4, 1.1 to 1.3, 0.7 and 2.7 to 4 times.

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
