// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/densekernels.h"
#include "model/core/densetile.h"
#include "model/core/simd.h"

#include <algorithm>

namespace quadrille {

namespace {

using namespace dense;
using Numbers = std::vector<double, tbb::cache_aligned_allocator<double>>;

/// Eight columns of a lower triangle from its row `first` on, which is their first as well; each row keeps
/// its place in the panel.
[[gnu::always_inline]] inline void packColumns(const DenseMatrix& a, std::ptrdiff_t first, double* panel)
{
    for (std::ptrdiff_t k = first; k < a.filledRows(); ++k)
        std::copy_n(a.row(k) + first, tileColumns, panel + k * tileColumns);
}

Numbers panelOf(const DenseMatrix& a)
{
    return Numbers(static_cast<std::size_t>(a.filledRows() * tileColumns));
}

QUADRILLE_SIMD_CLONES
void lowerTimesLower(const DenseMatrix& a, const DenseMatrix& b, double* panel, DenseMatrix& product)
{
    const std::ptrdiff_t size = a.filledRows();
    for (std::ptrdiff_t first = 0; first < size; first += tileColumns) {
        packColumns(b, first, panel);
        for (std::ptrdiff_t i = first; i < size; i += tileRows) {
            Tile sum;
            addProduct(sum, {a.row(i), a.stride(), 1}, panel, first, i + tileRows);
            storeTile(product.row(i) + first, product.stride(), sum);
        }
    }
}

QUADRILLE_SIMD_CLONES
void lowerTimesUpper(const DenseMatrix& a, double* panel, DenseMatrix& product)
{
    const std::ptrdiff_t size = a.filledRows();
    for (std::ptrdiff_t first = 0; first < size; first += tileColumns) {
        const std::ptrdiff_t end = first + tileColumns;
        for (std::ptrdiff_t k = 0; k < end; ++k)
            for (std::ptrdiff_t c = 0; c < tileColumns; ++c)
                panel[k * tileColumns + c] = a.row(first + c)[k];
        for (std::ptrdiff_t i = first; i < size; i += tileRows) {
            Tile sum;
            addProduct(sum, {a.row(i), a.stride(), 1}, panel, 0, end);
            storeTile(product.row(i) + first, product.stride(), sum);
        }
    }
}

QUADRILLE_SIMD_CLONES
void upperTimesLower(const DenseMatrix& a, double* panel, DenseMatrix& product)
{
    const std::ptrdiff_t size = a.filledRows();
    for (std::ptrdiff_t first = 0; first < size; first += tileColumns) {
        packColumns(a, first, panel);
        for (std::ptrdiff_t i = first; i < size; i += tileRows) {
            Tile sum;
            addProduct(sum, {a.row(0) + i, 1, a.stride()}, panel, i, size);
            storeTile(product.row(i) + first, product.stride(), sum);
        }
    }
}

QUADRILLE_SIMD_CLONES
void bothWays(const DenseMatrix& a, const DenseMatrix& b, double* panelA, double* panelB,
              DenseMatrix& product)
{
    const std::ptrdiff_t size = a.filledRows();
    for (std::ptrdiff_t first = 0; first < size; first += tileColumns) {
        packColumns(a, first, panelA);
        packColumns(b, first, panelB);
        for (std::ptrdiff_t i = first; i < size; i += tileRows) {
            Tile sum;
            addProduct(sum, {a.row(0) + i, 1, a.stride()}, panelB, i, size);
            addProduct(sum, {b.row(0) + i, 1, b.stride()}, panelA, i, size);
            storeTile(product.row(i) + first, product.stride(), sum);
        }
    }
}

} // namespace

void multiplyLower(const DenseMatrix& a, const DenseMatrix& b, DenseMatrix& product)
{
    lowerTimesLower(a, b, panelOf(a).data(), product);
}

void squareLower(const DenseMatrix& a, DenseMatrix& product)
{
    lowerTimesUpper(a, panelOf(a).data(), product);
}

void squareLowerTransposed(const DenseMatrix& a, DenseMatrix& product)
{
    upperTimesLower(a, panelOf(a).data(), product);
}

void multiplySymmetric(const DenseMatrix& a, const DenseMatrix& b, DenseMatrix& product)
{
    bothWays(a, b, panelOf(a).data(), panelOf(a).data(), product);
}

} // namespace quadrille
