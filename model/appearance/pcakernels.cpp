// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/pcakernels.h"

#include "model/core/simd.h"

#include <cmath>

namespace quadrille {

namespace {

constexpr std::size_t pcaColumns = 2; // sums of a tile stay in the registers of AVX2

template <typename Number>
inline __attribute__((always_inline)) void addTiles(const float* rows, std::size_t stride, std::size_t depth,
                                                    std::size_t first, double* sums)
{
    const std::size_t width = first + pcaRows;
    const float* left = rows + first * stride;
    for (std::size_t from = 0; from < depth; from += pcaDepth) {
        for (std::size_t column = 0; column < width; column += pcaColumns) {
            const float* right = rows + column * stride;
            Number a0 = 0, a1 = 0, b0 = 0, b1 = 0, c0 = 0, c1 = 0, d0 = 0, d1 = 0;
#pragma omp simd reduction(+ : a0, a1, b0, b1, c0, c1, d0, d1)
            for (std::size_t k = from; k < from + pcaDepth; ++k) {
                const Number r0 = right[k];
                const Number r1 = right[stride + k];
                const Number a = left[k];
                const Number b = left[stride + k];
                const Number c = left[2 * stride + k];
                const Number d = left[3 * stride + k];
                a0 += a * r0;
                a1 += a * r1;
                b0 += b * r0;
                b1 += b * r1;
                c0 += c * r0;
                c1 += c * r1;
                d0 += d * r0;
                d1 += d * r1;
            }
            double* out = sums + column;
            out[0] += static_cast<double>(a0);
            out[1] += static_cast<double>(a1);
            out[width] += static_cast<double>(b0);
            out[width + 1] += static_cast<double>(b1);
            out[2 * width] += static_cast<double>(c0);
            out[2 * width + 1] += static_cast<double>(c1);
            out[3 * width] += static_cast<double>(d0);
            out[3 * width + 1] += static_cast<double>(d1);
        }
    }
}

} // namespace

QUADRILLE_SIMD_CLONES
bool addRow(const float* row, std::size_t count, double* sums)
{
    int others = 0;
#pragma omp simd reduction(| : others)
    for (std::size_t k = 0; k < count; ++k) {
        sums[k] += double{row[k]};
        others |= std::abs(row[k]) <= 255.0F && row[k] == std::floor(row[k]) ? 0 : 1;
    }
    return others == 0;
}

QUADRILLE_SIMD_CLONES
void addRowProducts(const float* rows, std::size_t stride, std::size_t depth, std::size_t first, bool isWhole,
                    double* sums)
{
    if (isWhole)
        addTiles<float>(rows, stride, depth, first, sums);
    else
        addTiles<double>(rows, stride, depth, first, sums);
}

QUADRILLE_SIMD_CLONES
void combineRows(const float* rows, std::size_t count, std::size_t stride, std::size_t depth,
                 const double* weights, float* sums)
{
    constexpr std::size_t lanes = 8;
    for (std::size_t from = 0; from < depth; from += lanes) {
        double part[pcaRows][lanes] = {};
        const float* in = rows + from;
        for (std::size_t k = 0; k < count; ++k, in += stride) {
            for (std::size_t row = 0; row < pcaRows; ++row) {
#pragma omp simd
                for (std::size_t lane = 0; lane < lanes; ++lane)
                    part[row][lane] += weights[k * pcaRows + row] * double{in[lane]};
            }
        }
        for (std::size_t row = 0; row < pcaRows; ++row)
            for (std::size_t lane = 0; lane < lanes; ++lane)
                sums[row * stride + from + lane] = static_cast<float>(part[row][lane]);
    }
}

QUADRILLE_SIMD_CLONES
bool turnRow(float* row, std::size_t count)
{
    float least = 0;
    float most = 0;
#pragma omp simd reduction(min : least) reduction(max : most)
    for (std::size_t k = 0; k < count; ++k) {
        least = row[k] < least ? row[k] : least;
        most = row[k] > most ? row[k] : most;
    }
    if (-least <= most)
        return false;
#pragma omp simd
    for (std::size_t k = 0; k < count; ++k)
        row[k] = -row[k];
    return true;
}

} // namespace quadrille
