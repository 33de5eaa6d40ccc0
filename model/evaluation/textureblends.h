// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/decode.h"
#include "model/evaluation/appearanceerrors.h"

#include <array>

namespace quadrille {

/// How near blends of pairs of textures with some Eigen textures come to those with all of them
/// (SMCAS Fig. 22).
struct BlendReductionRow
{
    std::int64_t textures = 0; ///< Eigen textures
    PictureQuality quality;    ///< mean over pairs
};

/// Blends pairs midway in the spaces of aligned textures and of warps, all components of warps kept.
/// \param alignment  its aligned textures are replaced; null: there are no warps. \param counts  of Eigen
/// textures.
/// \throws Error Cancelled, WriteFailed (scratch), and what reading textures throws.
std::vector<BlendReductionRow> blendReduction(const AppearanceSubject& subject, TextureAlignment* alignment,
                                              std::span<const std::array<std::int64_t, 2>> pairs,
                                              std::span<const std::int64_t> counts,
                                              const Progress& progress = {},
                                              const Executor& executor = localExecutor());

/// A captured texture, and two that were captured as long before as after it.
struct MiddleTexture
{
    std::int64_t before = 0;
    std::int64_t middle = 0;
    std::int64_t after = 0;
};

/// How near both ways to blend textures come to what was captured in the middle.
struct MiddleErrors
{
    PictureQuality model;  ///< see blendedTexture
    PictureQuality linear; ///< the mean of both textures
};

/// \param decoder  of a model that was learned from all of the textures, whose frames are its rows.
/// \throws Error Cancelled, and what reading textures throws.
std::vector<MiddleErrors> middleErrors(const TextureSource& textures, const AppearanceDecoder& decoder,
                                       std::span<const MiddleTexture> middles, const Progress& progress = {},
                                       const Executor& executor = localExecutor());

} // namespace quadrille
