// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"
#include "model/core/image.h"

namespace quadrille::test {

/// A chart that is a disc; its texels are covered but for a gutter at its rim.
struct Disc
{
    double x = 0;
    double y = 0;
    double radius = 0;
};

/// Texels of discs that do not overlap.
UsedTexels texelsOfDiscs(int width, int height, const std::vector<Disc>& discs, double gutter = 2);
/// Discs in rows and columns that use 43 % of an atlas, as the charts of a real capture do.
UsedTexels texelsOfAtlas(int size);

/// A space of random components. \param spread  of the coefficients of the first component, per value; the
/// others descend. \param orthonormal  else of length 1 only, which is much quicker to make.
LinearSpace randomSpace(std::vector<float> mean, int components, int samples, double spread, bool orthonormal,
                        std::uint64_t seed);

struct FixtureSettings
{
    int components = 6;
    int warpComponents = 3;
    int frames = 8;
    double contrast = 4; ///< grey levels that the first component adds to a value, about
    double warp = 1.5;   ///< texels that the first component of warps moves a node, about
    bool orthonormal = true;
};
/// Noise in every texel, moved by smooth warps.
struct AppearanceSpaces
{
    UsedTexels texels;
    WarpGrid grid;
    LinearSpace textures;
    LinearSpace warps;
    std::vector<AppearanceFrame> frames;
};
AppearanceSpaces randomSpaces(const UsedTexels& texels, const FixtureSettings& settings, std::uint64_t seed);
AppearanceModel quantised(const AppearanceSpaces& spaces);

/// A model of two charts in 160 × 96 texels with 5 Eigen textures, 3 Eigen warps and 8 frames, of waves: as
/// smooth as pictures are.
AppearanceModel modelOfWaves();

/// The same as the decoder in plain loops of double precision, without rounding between its steps.
Image plainDecode(const AppearanceModel& model, const AppearanceCoefficients& coefficients);

/// Plain loops of single precision over components that are not rounded: what a decoder would be without
/// ours. Look-ups may leave charts.
void plainFloatDecode(const AppearanceSpaces& spaces, const AppearanceCoefficients& coefficients,
                      std::vector<float>& aligned, Image& texture);

} // namespace quadrille::test
