// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/warpgrid.h"

#include <cstdint>

namespace quadrille {

/// Numbers rounded to bytes, limited to 0 … 255.
void roundToBytes(const float* values, int count, std::uint8_t* bytes);

/// first + weight · (second − first), rounded to nearest. \param weight  0 … 1. The result may be one of
/// both.
void mixBytes(const std::uint8_t* first, const std::uint8_t* second, float weight, std::int64_t count,
              std::uint8_t* mixed);

inline constexpr int lookupsAtOnce = 256;
/// So many texels go through the processor together, some behind the last one with them.
inline constexpr int lookupLanes = 16;

/// Warps of some texels of a row, between those of two rows of nodes.
struct WarpRows
{
    const float* x[2];
    const float* y[2];
    float weight = 0; ///< of the second row
};

/// Some texels of a row, looked up in a plane of R G B A.
struct RowLookup
{
    const std::uint32_t* plane = nullptr; ///< its texel (0, 0); one before it and two behind the last are
                                          ///< there in each direction, and 2 · lookupLanes at its end
    bool isOpaque = true;                 ///< all A are 255: then all at once are looked up
    int stride = 0;
    int lastX = 0; ///< the largest place that is looked up
    int lastY = 0;
    int x = 0; ///< of the first texel
    int y = 0;
    int count = 0; ///< at most lookupsAtOnce
};

/// Texels at x + warp(x), cubic in both directions: see CubicWeights. \param places  where in the plane the
/// texel at the upper left of each place lies. Both have room for a multiple of lookupLanes, and so many
/// warps can be read.
void lookUpRow(const RowLookup& lookup, const WarpRows& warp, std::int32_t* places, std::uint32_t* texels);

} // namespace quadrille
