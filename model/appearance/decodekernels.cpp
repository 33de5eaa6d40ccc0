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

constexpr int lanes = lookupLanes; // one register of the widest machines
constexpr int mostApart = 3;       // that squares of neighbours begin, more than the texels themselves
using Numbers = float __attribute__((vector_size(4 * lanes)));
using Wholes = std::int32_t __attribute__((vector_size(4 * lanes)));
using UnalignedNumbers = float __attribute__((vector_size(4 * lanes), aligned(4), may_alias));
using UnalignedWholes = std::int32_t __attribute__((vector_size(4 * lanes), aligned(4), may_alias));

// Registers are handed over by reference: how functions return them depends on the machine.

[[gnu::always_inline]] inline void load(const float* values, Numbers& numbers)
{
    numbers = *reinterpret_cast<const UnalignedNumbers*>(values);
}

[[gnu::always_inline]] inline void load(const std::int32_t* values, Wholes& wholes)
{
    wholes = *reinterpret_cast<const UnalignedWholes*>(values);
}

/// Adds weight · byte. \param shift  of the byte.
[[gnu::always_inline]] inline void addByte(const Wholes& texels, int shift, const Numbers& weight,
                                           Numbers& sum)
{
    sum += weight * __builtin_convertvector(texels >> shift & 255, Numbers);
}

[[gnu::always_inline]] inline void joinByte(const Numbers& sums, int shift, Wholes& texels)
{
    Numbers values = sums + 0.5F;
    values = values > 0.0F ? values : Numbers{}; // also what is no number
    const Numbers most = Numbers{} + 255.0F;
    values = values < most ? values : most;
    texels |= __builtin_convertvector(values, Wholes) << shift;
}

/// Weights of as many taps as some squares side by side need. \param starts  of each square, from 0 to most.
[[gnu::always_inline]] inline void spreadWeights(const float (&weights)[4][lanes], const Wholes& starts,
                                                 int most, Numbers* taps)
{
    for (int tap = 0; tap < 4 + most; ++tap) {
        Numbers sum{};
        for (int own = tap > most ? tap - most : 0; own < 4 && own <= tap; ++own) {
            Numbers weight;
            load(weights[own], weight);
            sum = starts == tap - own ? weight : sum;
        }
        taps[tap] = sum;
    }
}

/// One texel, from the sixteen around it: first the rows become one, then its texels.
[[gnu::always_inline]] inline std::uint32_t lookUpSquare(const std::uint32_t* texel, int stride,
                                                         const CubicWeights& across, const CubicWeights& down)
{
    const auto* row0 = reinterpret_cast<const std::uint8_t*>(texel - stride - 1);
    const std::ptrdiff_t rowBytes = std::ptrdiff_t{4} * stride;
    const std::uint8_t* row1 = row0 + rowBytes;
    const std::uint8_t* row2 = row1 + rowBytes;
    const std::uint8_t* row3 = row2 + rowBytes;
    alignas(64) float column[16];
#pragma omp simd
    for (int c = 0; c < 16; ++c)
        column[c] = down.w0 * number(row0[c]) + down.w1 * number(row1[c]) + down.w2 * number(row2[c]) +
                    down.w3 * number(row3[c]);
    std::uint32_t joined = 0;
    for (int c = 0; c < 4; ++c) {
        const float sum = across.w0 * column[c] + across.w1 * column[4 + c] + across.w2 * column[8 + c] +
                          across.w3 * column[12 + c];
        joined |= static_cast<std::uint32_t>(static_cast<std::int32_t>(limited(sum + 0.5F, 255.0F)))
                  << (8 * c);
    }
    return joined;
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
    const auto mostX = static_cast<float>(lookup.lastX);
    const auto mostY = static_cast<float>(lookup.lastY);
    const auto row = static_cast<float>(lookup.y);
    const int stride = lookup.stride;
    for (int from = 0; from < lookup.count; from += lanes) {
        alignas(64) float across[4][lanes];
        alignas(64) float down[4][lanes];
        alignas(64) std::int32_t left[lanes]; // from the texel itself
        alignas(64) std::int32_t top[lanes];
        const int first = lookup.x + from;
#pragma omp simd
        for (int i = 0; i < lanes; ++i) {
            const int n = from + i;
            const float toX = warp.x[0][n] + warp.weight * (warp.x[1][n] - warp.x[0][n]);
            const float toY = warp.y[0][n] + warp.weight * (warp.y[1][n] - warp.y[0][n]);
            const float x = limited(static_cast<float>(first + i) + toX, mostX);
            const float y = limited(row + toY, mostY);
            const auto column = static_cast<std::int32_t>(x);
            const auto line = static_cast<std::int32_t>(y);
            const CubicWeights ofX = cubicWeights(x - static_cast<float>(column));
            const CubicWeights ofY = cubicWeights(y - static_cast<float>(line));
            across[0][i] = ofX.w0;
            across[1][i] = ofX.w1;
            across[2][i] = ofX.w2;
            across[3][i] = ofX.w3;
            down[0][i] = ofY.w0;
            down[1][i] = ofY.w1;
            down[2][i] = ofY.w2;
            down[3][i] = ofY.w3;
            left[i] = column - first - i;
            top[i] = line;
            places[n] = line * stride + column;
        }
        // Lanes behind the last texel are looked up as well, and may lie anywhere.
        const int some = lookup.count - from < lanes ? lookup.count - from : lanes;
        std::int32_t leastLeft = left[0];
        std::int32_t mostLeft = left[0];
        std::int32_t leastTop = top[0];
        std::int32_t mostTop = top[0];
        for (int i = 1; i < some; ++i) {
            leastLeft = left[i] < leastLeft ? left[i] : leastLeft;
            mostLeft = left[i] > mostLeft ? left[i] : mostLeft;
            leastTop = top[i] < leastTop ? top[i] : leastTop;
            mostTop = top[i] > mostTop ? top[i] : mostTop;
        }
        if (!lookup.isOpaque || mostLeft - leastLeft > mostApart || mostTop - leastTop > mostApart) {
            for (int i = 0; i < some; ++i)
                texels[from + i] = lookUpSquare(lookup.plane + places[from + i], stride,
                                                {across[0][i], across[1][i], across[2][i], across[3][i]},
                                                {down[0][i], down[1][i], down[2][i], down[3][i]});
            continue;
        }
        // Neighbours that move alike take their squares from rows that lie side by side: tap by tap, all at
        // once. Where some squares begin further on than others there are more taps, of which four count for
        // each.
        Wholes starts;
        Numbers ofColumn[4 + mostApart];
        Numbers ofRow[4 + mostApart];
        load(left, starts);
        spreadWeights(across, starts - leastLeft, mostLeft - leastLeft, ofColumn);
        load(top, starts);
        spreadWeights(down, starts - leastTop, mostTop - leastTop, ofRow);
        const int columns = 4 + (mostLeft - leastLeft);
        const int rows = 4 + (mostTop - leastTop);
        const std::uint32_t* corner =
            lookup.plane + std::ptrdiff_t{leastTop - 1} * stride + first + leastLeft - 1;
        Numbers red{};
        Numbers green{};
        Numbers blue{};
        for (int r = 0; r < rows; ++r, corner += stride) {
            Numbers rowRed{};
            Numbers rowGreen{};
            Numbers rowBlue{};
            for (int c = 0; c < columns; ++c) {
                Wholes taps;
                load(reinterpret_cast<const std::int32_t*>(corner + c), taps);
                addByte(taps, 0, ofColumn[c], rowRed);
                addByte(taps, 8, ofColumn[c], rowGreen);
                addByte(taps, 16, ofColumn[c], rowBlue);
            }
            red += ofRow[r] * rowRed;
            green += ofRow[r] * rowGreen;
            blue += ofRow[r] * rowBlue;
        }
        Wholes joined = Wholes{} | static_cast<std::int32_t>(0xFF000000U);
        joinByte(red, 0, joined);
        joinByte(green, 8, joined);
        joinByte(blue, 16, joined);
        *reinterpret_cast<UnalignedWholes*>(texels + from) = joined;
    }
}

} // namespace quadrille
