// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille {

inline constexpr std::size_t pcaRows = 4; ///< samples are handled by so many at a time
/// Values are handled by so many at a time: in single precision so many products of bytes have an exact sum.
inline constexpr std::size_t pcaDepth = 256;

/// Adds the values of a row to sums. \return whether all are whole numbers of −255 … 255.
bool addRow(const float* row, std::size_t count, double* sums);

/// Adds the products of four rows with those up to them.
/// \param rows  of `stride` values each, of which the first `depth` count, a multiple of pcaDepth.
/// \param first  of the four, a multiple of pcaRows.
/// \param isWhole  all values are whole numbers of −256 … 256.
/// \param sums  4 × (first + 4).
void addRowProducts(const float* rows, std::size_t stride, std::size_t depth, std::size_t first, bool isWhole,
                    double* sums);

/// Combinations of rows for four components.
/// \param rows  `count` of `stride` values each.
/// \param weights  count × 4.
/// \param sums  4 × stride; `depth` of each are written, a multiple of 8.
void combineRows(const float* rows, std::size_t count, std::size_t stride, std::size_t depth,
                 const double* weights, float* sums);

/// Turns the signs of a row whose largest absolute value is negative. \return whether it did.
bool turnRow(float* row, std::size_t count);

} // namespace quadrille
