// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille {

/// How many rows of two matrices are multiplied with each other at a time, and how many of their columns.
inline constexpr std::size_t productRows = 64;
inline constexpr std::size_t productColumns = 256;

/// Some columns of some rows of a matrix.
struct FloatRows
{
    const float* first = nullptr;
    std::size_t count = 0;   ///< at most productRows
    std::size_t columns = 0; ///< at most productColumns
    std::size_t stride = 0;  ///< from one row to the next, in numbers
};

/// Adds the products of all pairs of rows, summed in double precision.
/// \param left, right  as many columns. \param scratch  room for 2 · productRows · productColumns numbers.
/// \param sums  productRows × productRows: of each row on the left those with all on the right.
void addRowProducts(const FloatRows& left, const FloatRows& right, double* scratch, double* sums);

} // namespace quadrille
