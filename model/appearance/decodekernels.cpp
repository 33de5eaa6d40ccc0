// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/decodekernels.h"

#include "model/core/simd.h"

namespace quadrille {

namespace {

[[gnu::always_inline]] inline float limited(float value, float most)
{
    value = value > 0 ? value : 0; // also what is no number
    return value < most ? value : most;
}

[[gnu::always_inline]] inline float channel(std::uint32_t pixel, int shift)
{
    return static_cast<float>(static_cast<std::int32_t>(pixel >> shift & 255U));
}

} // namespace

QUADRILLE_SIMD_CLONES
void roundToBytes(const float* values, int count, std::uint8_t* bytes)
{
#pragma omp simd
    for (int i = 0; i < count; ++i)
        bytes[i] = static_cast<std::uint8_t>(static_cast<std::int32_t>(limited(values[i] + 0.5F, 255.0F)));
}

QUADRILLE_SIMD_CLONES
void mixBytes(const std::uint8_t* first, const std::uint8_t* second, float weight, std::int64_t count,
              std::uint8_t* mixed)
{
#pragma omp simd
    for (std::int64_t i = 0; i < count; ++i) {
        const auto from = static_cast<float>(static_cast<std::int32_t>(first[i]));
        const auto to = static_cast<float>(static_cast<std::int32_t>(second[i]));
        const float value = from + weight * (to - from) + 0.5F;
        mixed[i] = static_cast<std::uint8_t>(static_cast<std::int32_t>(value));
    }
}

QUADRILLE_SIMD_CLONES
void lookUpRow(const RowLookup& lookup, const WarpRows& warp, std::int32_t* places, std::uint32_t* texels)
{
    alignas(64) float across[lookupsAtOnce];
    alignas(64) float down[lookupsAtOnce];
    const auto mostX = static_cast<float>(lookup.lastX);
    const auto mostY = static_cast<float>(lookup.lastY);
    const auto row = static_cast<float>(lookup.y);
    const int count = lookup.count;
    const int stride = lookup.stride;
    const int first = lookup.x;
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        const float toX = warp.x[0][i] + warp.weight * (warp.x[1][i] - warp.x[0][i]);
        const float toY = warp.y[0][i] + warp.weight * (warp.y[1][i] - warp.y[0][i]);
        const float x = limited(static_cast<float>(first + i) + toX, mostX);
        const float y = limited(row + toY, mostY);
        const auto left = static_cast<std::int32_t>(x);
        const auto top = static_cast<std::int32_t>(y);
        across[i] = x - static_cast<float>(left);
        down[i] = y - static_cast<float>(top);
        places[i] = top * stride + left;
    }
    const std::uint32_t* plane = lookup.plane;
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        const std::uint32_t a = plane[places[i]];
        const std::uint32_t b = plane[places[i] + 1];
        const std::uint32_t c = plane[places[i] + stride];
        const std::uint32_t d = plane[places[i] + stride + 1];
        std::uint32_t texel = 0xFF000000U;
        for (int shift = 0; shift < 24; shift += 8) {
            const float upper = channel(a, shift) + across[i] * (channel(b, shift) - channel(a, shift));
            const float lower = channel(c, shift) + across[i] * (channel(d, shift) - channel(c, shift));
            const float value = upper + down[i] * (lower - upper) + 0.5F;
            texel |= static_cast<std::uint32_t>(static_cast<std::int32_t>(value)) << shift;
        }
        texels[i] = texel;
    }
}

QUADRILLE_SIMD_CLONES
void warpRowBetween(const float* from, const float* to, const WarpGrid& grid, int row, float* between)
{
    constexpr int iterations = 4; // each leaves as much of the error as the warp stretches
    const float nodesPerTexel = 1.0F / static_cast<float>(grid.spacing);
    const auto lastColumn = static_cast<float>(grid.width - 1);
    const auto lastRow = static_cast<float>(grid.height - 1);
    const int width = grid.width;
    // The last node is left to the cell before it; grids of one column or row have none.
    const int lastLeft = width > 1 ? width - 2 : 0;
    const int lastTop = grid.height > 1 ? grid.height - 2 : 0;
    const int right = width > 1 ? 2 : 0;
    const int below = grid.height > 1 ? 2 * width : 0;
    const auto atRow = static_cast<float>(row);
    const float* here = from + std::ptrdiff_t{2} * row * width;
#pragma omp simd
    for (std::ptrdiff_t i = 0; i < width; ++i) {
        float foundX = to[2 * i] - here[2 * i];
        float foundY = to[2 * i + 1] - here[2 * i + 1];
        for (int iteration = 0; iteration < iterations; ++iteration) {
            const float x = limited(static_cast<float>(i) + foundX * nodesPerTexel, lastColumn);
            const float y = limited(atRow + foundY * nodesPerTexel, lastRow);
            std::int32_t left = static_cast<std::int32_t>(x);
            std::int32_t top = static_cast<std::int32_t>(y);
            left = left < lastLeft ? left : lastLeft;
            top = top < lastTop ? top : lastTop;
            const float across = x - static_cast<float>(left);
            const float down = y - static_cast<float>(top);
            const std::int32_t at = 2 * (top * width + left);
            const float upperX = from[at] + across * (from[at + right] - from[at]);
            const float upperY = from[at + 1] + across * (from[at + right + 1] - from[at + 1]);
            const float lowerX = from[at + below] + across * (from[at + below + right] - from[at + below]);
            const float lowerY =
                from[at + below + 1] + across * (from[at + below + right + 1] - from[at + below + 1]);
            foundX = to[2 * i] - (upperX + down * (lowerX - upperX));
            foundY = to[2 * i + 1] - (upperY + down * (lowerY - upperY));
        }
        between[2 * i] = foundX;
        between[2 * i + 1] = foundY;
    }
}

} // namespace quadrille
