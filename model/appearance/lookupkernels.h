// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/warpgrid.h"

#include <cstdint>

namespace quadrille {

/// Where four rows of four texels lie, and what is looked up between them.
struct SquareLookup
{
    std::uint32_t rows[4]; ///< the first texel of each
    float x = 0;           ///< part of the way from the second texel to the third
    float y = 0;           ///< and from the second row to the third
    std::uint32_t to = 0;  ///< the texel that the result is for
};

/// Three values between the 4 × 4 of each square, cubic in both directions: see CubicWeights. \param values
/// three of each texel, and one more. \param looked  three of each texel.
void lookUpSquares(const float* values, const SquareLookup* squares, int count, float* looked);

/// The displacements w of some places of a row with w(x) = wanted(x) − warp(x + w(x)); by fixed-point
/// iteration, which stops at a thousandth of a texel. \param x  columns of the places, texels. \param wanted
/// x, y of each; null: zero. \param found  x, y of each.
void undoWarp(const float* nodes, const WarpGrid& grid, const float* x, int y, int count, const float* wanted,
              float* found);

} // namespace quadrille
