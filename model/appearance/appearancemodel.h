// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/quantisedspace.h"
#include "model/appearance/usedtexels.h"
#include "model/appearance/warpgrid.h"
#include "model/core/units.h"

#include <string>
#include <vector>

namespace quadrille {

/// A captured frame that a model was made from.
struct AppearanceFrame
{
    std::string sequence;
    FrameIndex frame;

    bool operator==(const AppearanceFrame&) const = default;
};

/// Eigen textures and Eigen warps (SMCAS §5): a texture is a point of the space of aligned textures,
/// de-aligned by a point of the space of warps. A texture sample has R, G and B (0 … 255) of each used texel,
/// a warp sample x (right) and y (down), in texels, of each node: texture(x) = aligned(x + warp(x)).
struct AppearanceModel
{
    UsedTexels texels;
    WarpGrid grid;
    QuantisedSpace textures;             ///< 3 values per used texel
    QuantisedSpace warps;                ///< 2 values per node; no component where textures are not aligned
    std::vector<AppearanceFrame> frames; ///< of both spaces' coefficients

    bool operator==(const AppearanceModel&) const = default;
};

/// A texture in an AppearanceModel. Fewer than the model has: the others are zero.
struct AppearanceCoefficients
{
    std::vector<float> textures;
    std::vector<float> warps;

    bool operator==(const AppearanceCoefficients&) const = default;
};

/// Makes a model of spaces that were fitted to the same frames.
/// \pre Sizes of the spaces fit texels and grid, and both have a row of coefficients for each frame.
/// Cost: O(values · components).
AppearanceModel quantised(UsedTexels texels, WarpGrid grid, const LinearSpace& textures,
                          const LinearSpace& warps, std::vector<AppearanceFrame> frames,
                          const Progress& progress = {});

/// Those of a frame that the model was made from. \pre frame < model.frames.size().
AppearanceCoefficients coefficientsOf(const AppearanceModel& model, std::size_t frame);

/// Linear interpolation, as SMCAS §5.3 does for transitions. \param weight  0: the first, 1: the second.
AppearanceCoefficients interpolated(const AppearanceCoefficients& first, const AppearanceCoefficients& second,
                                    double weight);

} // namespace quadrille
