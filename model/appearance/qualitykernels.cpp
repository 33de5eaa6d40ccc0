// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/qualitykernels.h"

#include "model/core/simd.h"

#include <cstddef>

namespace quadrille {

namespace {

[[gnu::always_inline]] inline float lumaAboutZero(const std::uint8_t* pixel)
{
    return 0.299F * static_cast<float>(pixel[0]) + 0.587F * static_cast<float>(pixel[1]) +
           0.114F * static_cast<float>(pixel[2]) - lumaMiddle;
}

/// Weighted sums of windowWidth arrays; the weights are the same from both ends.
[[gnu::always_inline]] inline void addWeighted(const float* const* values, int width, const float* weights,
                                               float* sums)
{
    static_assert(windowReach == 5);
    const float w0 = weights[0];
    const float w1 = weights[1];
    const float w2 = weights[2];
    const float w3 = weights[3];
    const float w4 = weights[4];
    const float w5 = weights[5];
#pragma omp simd
    for (int x = 0; x < width; ++x)
        sums[x] = w5 * values[5][x] + w4 * (values[4][x] + values[6][x]) +
                  w3 * (values[3][x] + values[7][x]) + w2 * (values[2][x] + values[8][x]) +
                  w1 * (values[1][x] + values[9][x]) + w0 * (values[0][x] + values[10][x]);
}

} // namespace

QUADRILLE_SIMD_CLONES
void pixelMoments(const std::uint8_t* first, const std::uint8_t* second, const std::uint8_t* mask, int width,
                  float* moments, int stride)
{
    float* one = moments;
    float* other = one + stride;
    float* squares = other + stride;
    float* product = squares + stride;
    float* weight = product + stride;
    for (int x = 0; x < width; ++x)
        weight[x] = !mask || mask[x] != 0 ? 1.0F : 0.0F;
#pragma omp simd
    for (std::ptrdiff_t x = 0; x < width; ++x) {
        const float a = weight[x] * lumaAboutZero(first + 4 * x);
        const float b = weight[x] * lumaAboutZero(second + 4 * x);
        one[x] = a;
        other[x] = b;
        squares[x] = a * a + b * b;
        product[x] = a * b;
    }
}

QUADRILLE_SIMD_CLONES
void filterRow(const float* values, int width, const float* weights, float* sums)
{
    const float* at[windowWidth];
    for (int k = 0; k < windowWidth; ++k)
        at[k] = values + k;
    addWeighted(at, width, weights, sums);
}

QUADRILLE_SIMD_CLONES
void similarityOfRow(const float* const* rows, int width, const float* weights, float* moments,
                     float* similarity)
{
    for (int m = 0; m < momentCount; ++m) {
        const float* at[windowWidth];
        const std::ptrdiff_t place = std::ptrdiff_t{m} * width;
        for (int k = 0; k < windowWidth; ++k)
            at[k] = rows[k] + place;
        addWeighted(at, width, weights, moments + place);
    }
    constexpr float forMeans = (0.01F * 255) * (0.01F * 255);
    constexpr float forSpreads = (0.03F * 255) * (0.03F * 255);
#pragma omp simd
    for (int x = 0; x < width; ++x) {
        const float weight = moments[4 * width + x];
        const float perWeight = weight > 0 ? 1 / weight : 0;
        const float a = moments[x] * perWeight;
        const float b = moments[width + x] * perWeight;
        const float spreads = moments[2 * width + x] * perWeight - (a * a + b * b);
        const float covariance = moments[3 * width + x] * perWeight - a * b;
        const float meanA = a + lumaMiddle;
        const float meanB = b + lumaMiddle;
        similarity[x] = (2 * meanA * meanB + forMeans) * (2 * covariance + forSpreads) /
                        ((meanA * meanA + meanB * meanB + forMeans) * (spreads + forSpreads));
    }
}

} // namespace quadrille
