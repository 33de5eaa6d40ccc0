// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/decodekernels.h"

#include "model/appearance/cubicweights.h"
#include "model/core/simd.h"

namespace quadrille {

namespace {

[[gnu::always_inline]] inline float limited(float value, float most)
{
    value = value > 0 ? value : 0; // also what is no number
    return value < most ? value : most;
}

[[gnu::always_inline]] inline float number(std::uint8_t byte)
{
    return static_cast<float>(static_cast<std::int32_t>(byte));
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
        const float value = number(first[i]) + weight * (number(second[i]) - number(first[i])) + 0.5F;
        mixed[i] = static_cast<std::uint8_t>(static_cast<std::int32_t>(value));
    }
}

QUADRILLE_SIMD_CLONES
void lookUpRow(const RowLookup& lookup, const WarpRows& warp, std::int32_t* places, std::uint32_t* texels)
{
    alignas(64) float across[4][lookupsAtOnce];
    alignas(64) float down[4][lookupsAtOnce];
    alignas(64) float sums[4 * lookupsAtOnce];
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
        const CubicWeights ofX = cubicWeights(x - static_cast<float>(left));
        const CubicWeights ofY = cubicWeights(y - static_cast<float>(top));
        across[0][i] = ofX.w0;
        across[1][i] = ofX.w1;
        across[2][i] = ofX.w2;
        across[3][i] = ofX.w3;
        down[0][i] = ofY.w0;
        down[1][i] = ofY.w1;
        down[2][i] = ofY.w2;
        down[3][i] = ofY.w3;
        places[i] = top * stride + left;
    }
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(lookup.plane);
    const std::ptrdiff_t rowBytes = std::ptrdiff_t{4} * stride;
    for (int i = 0; i < count; ++i) {
        // Four texels of four rows: first the rows become one, then its texels.
        const std::uint8_t* row0 = bytes + 4 * (std::ptrdiff_t{places[i]} - stride - 1);
        const std::uint8_t* row1 = row0 + rowBytes;
        const std::uint8_t* row2 = row1 + rowBytes;
        const std::uint8_t* row3 = row2 + rowBytes;
        alignas(64) float column[16];
#pragma omp simd
        for (int c = 0; c < 16; ++c)
            column[c] = down[0][i] * number(row0[c]) + down[1][i] * number(row1[c]) +
                        down[2][i] * number(row2[c]) + down[3][i] * number(row3[c]);
#pragma omp simd
        for (int c = 0; c < 4; ++c)
            sums[4 * i + c] = across[0][i] * column[c] + across[1][i] * column[4 + c] +
                              across[2][i] * column[8 + c] + across[3][i] * column[12 + c];
    }
    roundToBytes(sums, 4 * count, reinterpret_cast<std::uint8_t*>(texels));
}

} // namespace quadrille
