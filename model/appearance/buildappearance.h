// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/alignment.h"

namespace quadrille {

struct BuildAppearanceOptions
{
    int gutter = 4; ///< around charts, texels
    AlignmentOptions alignment;
    std::int64_t components = 50; ///< of textures and warps together, at most
    /// Of the components; what SMCAS §5.2 found best. Where all are of textures, nothing is aligned: that is
    /// plain PCA of the textures as they are.
    double textureShare = 2.0 / 3;
};

/// Eigen textures and Eigen warps, before they are made small.
struct BuiltAppearance
{
    UsedTexels used;
    WarpGrid grid;
    LinearSpace textures; ///< of aligned textures: R, G, B per used texel
    /// Of backward warps: x, y per node; no component where nothing was aligned. Their mean stands in the
    /// aligned textures.
    LinearSpace warps;
    std::int64_t reference = 0;
    int rounds = 0;                        ///< that it took to find the reference
    std::vector<AlignmentFigures> figures; ///< per texture
};

/// How many of the components are textures.
std::int64_t textureComponents(const BuildAppearanceOptions& options);

/// Builds the model of a character's appearance from the textures of its frames (SMCAS §5.1).
/// \param textures  of one size and at least one. \param topology  whose UVs they are for.
/// \param cache  keeps flows; see FlowCache.
/// \throws Error NoUvs, BadArgument, Cancelled, and those of alignTextures.
BuiltAppearance buildAppearance(const TextureSource& textures, const Topology& topology,
                                const BuildAppearanceOptions& options = {}, FlowCache* cache = nullptr,
                                const Progress& progress = {}, const Executor& executor = localExecutor());

} // namespace quadrille
