// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/decode.h"
#include "model/core/progress.h"

#include <functional>

namespace quadrille {

/// Where a texture lies in another one: 2 values per node of a model's grid, so that fixed(x) = moving(x +
/// warp(x)) at known texels. \param known  height × width, not 0 where `fixed` is known.
using WarpEstimate = std::function<std::vector<float>(const Image& fixed, const Image& moving,
                                                      std::span<const std::uint8_t> known)>;

struct CompletionOptions
{
    int rounds = 8;        ///< at most, of textures and warps in turn
    double noise = 1;      ///< deviation of what no model explains, grey levels
    double warpNoise = 1;  ///< the same of an estimated warp, texels
    int blend = 6;         ///< texels over which differences at the border of what is known fade out
    WarpEstimate estimate; ///< of the first warp; none: the mean warp
};

struct CompletedTexture
{
    Image texture;
    AppearanceCoefficients coefficients;
};

/// Fills what is missing of a texture with what is likeliest by a model (SMCAS §5.3): the coefficients of
/// Eigen textures from its known texels, aligned by the warp as it stands, and those of Eigen warps from the
/// same texels, in turn. Known texels stay as they are; next to them what is filled in takes on their
/// difference from the model.
///
/// \param known  height × width, not 0 where the texture is known.
/// \pre Texture and mask have the atlas's size; spaces have an eigenvalue for each component.
/// \throws Error Cancelled. Cost: O(rounds · texels · components²).
CompletedTexture completeTexture(const AppearanceDecoder& decoder, const Image& texture,
                                 std::span<const std::uint8_t> known, const CompletionOptions& options = {},
                                 const Progress& progress = {});

} // namespace quadrille
