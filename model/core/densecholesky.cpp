// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"
#include "model/core/densetile.h"
#include "model/core/simd.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

using namespace dense;
using Numbers = std::vector<double, tbb::cache_aligned_allocator<double>>;

/// Pivots below this share of the diagonal are rounding errors.
constexpr double leastPivot = 1e-15;

/// Eight columns of right-hand sides, one after the other in memory, become those of L⁻¹ times them.
/// \param inverses  of the diagonal of L. Rows before `begin` are zero.
[[gnu::always_inline]] inline void forward(const DenseMatrix& factor, const double* inverses, double* panel,
                                           std::ptrdiff_t begin, std::ptrdiff_t end)
{
    const std::ptrdiff_t stride = factor.stride();
    for (std::ptrdiff_t i = begin; i < end; i += tileRows) {
        const double* const l = factor.row(i);
        Tile sum;
        addProduct(sum, {l, stride, 1}, panel, begin, i);
        double* const out = panel + i * tileColumns;
        const Four* const b = reinterpret_cast<const Four*>(out);
        const double* const l1 = l + stride + i;
        const double* const l2 = l1 + stride;
        const double* const l3 = l2 + stride;
        const Four a0 = (b[0] - sum.a0) * inverses[i];
        const Four b0 = (b[1] - sum.b0) * inverses[i];
        const Four a1 = (b[2] - sum.a1 - a0 * l1[0]) * inverses[i + 1];
        const Four b1 = (b[3] - sum.b1 - b0 * l1[0]) * inverses[i + 1];
        const Four a2 = (b[4] - sum.a2 - a0 * l2[0] - a1 * l2[1]) * inverses[i + 2];
        const Four b2 = (b[5] - sum.b2 - b0 * l2[0] - b1 * l2[1]) * inverses[i + 2];
        const Four a3 = (b[6] - sum.a3 - a0 * l3[0] - a1 * l3[1] - a2 * l3[2]) * inverses[i + 3];
        const Four b3 = (b[7] - sum.b3 - b0 * l3[0] - b1 * l3[1] - b2 * l3[2]) * inverses[i + 3];
        storeTile(out, tileColumns, {a0, a1, a2, a3, b0, b1, b2, b3});
    }
}

/// The same for L⁻ᵀ.
[[gnu::always_inline]] inline void backward(const DenseMatrix& factor, const double* inverses, double* panel,
                                            std::ptrdiff_t size)
{
    const std::ptrdiff_t stride = factor.stride();
    for (std::ptrdiff_t i = size - tileRows; i >= 0; i -= tileRows) {
        Tile sum;
        addProduct(sum, {factor.row(0) + i, 1, stride}, panel, i + tileRows, size);
        double* const out = panel + i * tileColumns;
        const Four* const b = reinterpret_cast<const Four*>(out);
        const double* const l1 = factor.row(i + 1) + i;
        const double* const l2 = l1 + stride;
        const double* const l3 = l2 + stride;
        const Four a3 = (b[6] - sum.a3) * inverses[i + 3];
        const Four b3 = (b[7] - sum.b3) * inverses[i + 3];
        const Four a2 = (b[4] - sum.a2 - a3 * l3[2]) * inverses[i + 2];
        const Four b2 = (b[5] - sum.b2 - b3 * l3[2]) * inverses[i + 2];
        const Four a1 = (b[2] - sum.a1 - a3 * l3[1] - a2 * l2[1]) * inverses[i + 1];
        const Four b1 = (b[3] - sum.b1 - b3 * l3[1] - b2 * l2[1]) * inverses[i + 1];
        const Four a0 = (b[0] - sum.a0 - a3 * l3[0] - a2 * l2[0] - a1 * l1[0]) * inverses[i];
        const Four b0 = (b[1] - sum.b0 - b3 * l3[0] - b2 * l2[0] - b1 * l1[0]) * inverses[i];
        storeTile(out, tileColumns, {a0, a1, a2, a3, b0, b1, b2, b3});
    }
}

/// The factor of the eight rows and columns from `first` on, from which all that comes before is subtracted.
[[gnu::always_inline]] inline bool factoriseBlock(double* block, const double* diagonal, double* inverses)
{
    for (std::ptrdiff_t k = 0; k < tileColumns; ++k) {
        double* const row = block + k * tileColumns;
        for (std::ptrdiff_t j = 0; j < k; ++j) {
            double sum = row[j];
            for (std::ptrdiff_t c = 0; c < j; ++c)
                sum -= row[c] * block[j * tileColumns + c];
            row[j] = sum * inverses[j];
        }
        double pivot = row[k];
        for (std::ptrdiff_t c = 0; c < k; ++c)
            pivot -= row[c] * row[c];
        if (!(pivot > leastPivot * diagonal[k]) || !std::isfinite(pivot))
            return false;
        row[k] = std::sqrt(pivot);
        inverses[k] = 1 / row[k];
        std::fill(row + k + 1, row + tileColumns, 0.0);
    }
    return true;
}

QUADRILLE_SIMD_CLONES
bool factorise(DenseMatrix& a, double* inverses, double* panel)
{
    const std::ptrdiff_t stride = a.stride();
    const std::ptrdiff_t size = a.filledRows();
    for (std::ptrdiff_t i = a.rows(); i < size; ++i) {
        std::fill_n(a.row(i), size, 0.0);
        a(i, i) = 1;
    }
    for (std::ptrdiff_t first = 0; first < size; first += tileColumns) {
        double* const rows = a.row(first);
        for (std::ptrdiff_t k = 0; k < first; ++k)
            for (std::ptrdiff_t c = 0; c < tileColumns; ++c)
                panel[k * tileColumns + c] = rows[c * stride + k];
        forward(a, inverses, panel, 0, first);

        double block[tileColumns * tileColumns];
        double diagonal[tileColumns];
        for (std::ptrdiff_t half = 0; half < tileColumns; half += tileRows) {
            Tile sum;
            addProduct(sum, {panel + half, 1, tileColumns}, panel, 0, first);
            storeTile(block + half * tileColumns, tileColumns, sum);
        }
        for (std::ptrdiff_t r = 0; r < tileColumns; ++r) {
            double* const row = rows + r * stride;
            diagonal[r] = row[first + r];
            for (std::ptrdiff_t c = 0; c <= r; ++c)
                block[r * tileColumns + c] = row[first + c] - block[r * tileColumns + c];
        }
        if (!factoriseBlock(block, diagonal, inverses + first))
            return false;
        for (std::ptrdiff_t r = 0; r < tileColumns; ++r) {
            double* const row = rows + r * stride;
            for (std::ptrdiff_t k = 0; k < first; ++k)
                row[k] = panel[k * tileColumns + r];
            std::copy_n(block + r * tileColumns, tileColumns, row + first);
            std::fill(row + first + tileColumns, row + size, 0.0);
        }
    }
    return true;
}

QUADRILLE_SIMD_CLONES
void solveForward(const DenseMatrix& factor, const double* inverses, double* panel, DenseMatrix& b)
{
    for (std::ptrdiff_t first = 0; first < b.filledColumns(); first += tileColumns) {
        for (std::ptrdiff_t k = 0; k < b.filledRows(); ++k)
            std::copy_n(b.row(k) + first, tileColumns, panel + k * tileColumns);
        forward(factor, inverses, panel, 0, factor.filledRows());
        for (std::ptrdiff_t k = 0; k < b.filledRows(); ++k)
            std::copy_n(panel + k * tileColumns, tileColumns, b.row(k) + first);
    }
}

QUADRILLE_SIMD_CLONES
void solveBackward(const DenseMatrix& factor, const double* inverses, double* panel, DenseMatrix& b)
{
    for (std::ptrdiff_t first = 0; first < b.filledColumns(); first += tileColumns) {
        for (std::ptrdiff_t k = 0; k < b.filledRows(); ++k)
            std::copy_n(b.row(k) + first, tileColumns, panel + k * tileColumns);
        backward(factor, inverses, panel, factor.filledRows());
        for (std::ptrdiff_t k = 0; k < b.filledRows(); ++k)
            std::copy_n(panel + k * tileColumns, tileColumns, b.row(k) + first);
    }
}

QUADRILLE_SIMD_CLONES
void invert(const DenseMatrix& factor, const double* inverses, double* panel, DenseMatrix& inverse)
{
    const std::ptrdiff_t size = factor.filledRows();
    for (std::ptrdiff_t first = 0; first < size; first += tileColumns) {
        std::fill(panel + first * tileColumns, panel + size * tileColumns, 0.0);
        for (std::ptrdiff_t c = 0; c < tileColumns; ++c)
            panel[(first + c) * tileColumns + c] = 1;
        forward(factor, inverses, panel, first, size);
        for (std::ptrdiff_t k = 0; k < first; ++k)
            std::fill_n(inverse.row(k) + first, tileColumns, 0.0);
        for (std::ptrdiff_t k = first; k < size; ++k)
            std::copy_n(panel + k * tileColumns, tileColumns, inverse.row(k) + first);
    }
}

Numbers inversesOf(const DenseMatrix& factor)
{
    Numbers inverses(static_cast<std::size_t>(factor.filledRows()));
    for (std::size_t i = 0; i < inverses.size(); ++i) {
        const auto index = static_cast<Eigen::Index>(i);
        inverses[i] = 1 / factor(index, index);
    }
    return inverses;
}

Numbers panelFor(const DenseMatrix& factor)
{
    return Numbers(static_cast<std::size_t>(factor.filledRows() * tileColumns));
}

} // namespace

bool factoriseCholesky(DenseMatrix& a)
{
    Numbers inverses(static_cast<std::size_t>(a.filledRows()));
    return factorise(a, inverses.data(), panelFor(a).data());
}

double logDeterminant(const DenseMatrix& factor)
{
    double sum = 0;
    for (Eigen::Index i = 0; i < factor.rows(); ++i)
        sum += std::log(factor(i, i));
    return 2 * sum;
}

void solveLower(const DenseMatrix& factor, DenseMatrix& b)
{
    solveForward(factor, inversesOf(factor).data(), panelFor(factor).data(), b);
}

void solveLowerTransposed(const DenseMatrix& factor, DenseMatrix& b)
{
    solveBackward(factor, inversesOf(factor).data(), panelFor(factor).data(), b);
}

void invertLower(const DenseMatrix& factor, DenseMatrix& inverse)
{
    invert(factor, inversesOf(factor).data(), panelFor(factor).data(), inverse);
}

} // namespace quadrille
