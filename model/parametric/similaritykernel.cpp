// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/similaritykernel.h"

#include "model/core/densetile.h"
#include "model/core/simd.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Groups of rows, of each group its columns one after the other; rows that there are not are zero.
template <std::size_t Group>
[[gnu::always_inline]] inline void packRows(const FloatRows& rows, double* packed)
{
    for (std::size_t first = 0; first < productRows; first += Group, packed += Group * rows.columns) {
        for (std::size_t r = 0; r < Group; ++r) {
            const bool isThere = first + r < rows.count;
            const float* row = rows.first + (isThere ? (first + r) * rows.stride : 0);
            for (std::size_t k = 0; k < rows.columns; ++k)
                packed[k * Group + r] = isThere ? row[k] : 0.0;
        }
    }
}

} // namespace

QUADRILLE_SIMD_CLONES
void addRowProducts(const FloatRows& left, const FloatRows& right, double* scratch, double* sums)
{
    constexpr auto rows = static_cast<std::size_t>(dense::tileRows);
    constexpr auto columns = static_cast<std::size_t>(dense::tileColumns);
    double* const packedLeft = scratch;
    double* const packedRight = scratch + productRows * productColumns;
    packRows<rows>(left, packedLeft);
    packRows<columns>(right, packedRight);
    const auto length = static_cast<std::ptrdiff_t>(left.columns);
    for (std::size_t c = 0; c < right.count; c += columns) {
        for (std::size_t r = 0; r < left.count; r += rows) {
            dense::Tile tile;
            dense::addProduct(tile, {packedLeft + r * left.columns, 1, dense::tileRows},
                              packedRight + c * right.columns, 0, length);
            double sum[rows * columns];
            dense::storeTile(sum, dense::tileColumns, tile);
            for (std::size_t i = 0; i < rows; ++i)
                for (std::size_t j = 0; j < columns; ++j)
                    sums[(r + i) * productRows + c + j] += sum[i * columns + j];
        }
    }
}

} // namespace quadrille
