// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/blockkernels.h"

#include "model/core/simd.h"

namespace quadrille {

namespace {

constexpr std::int64_t valuesOfBlock = QuantisedSpace::blockSize;

} // namespace

QUADRILLE_SIMD_CLONES
void combineSteps(const std::int16_t* mean, float meanStep, const std::int8_t* steps, const float* scales,
                  const float* coefficients, std::int64_t count, float* values)
{
#pragma omp simd
    for (std::int64_t i = 0; i < valuesOfBlock; ++i)
        values[i] = meanStep * static_cast<float>(mean[i]);
    std::int64_t row = 0;
    for (; row + 4 <= count; row += 4) { // four at a time: sums are loaded and stored less often
        const std::int8_t* a = steps + row * valuesOfBlock;
        const std::int8_t* b = a + valuesOfBlock;
        const std::int8_t* c = b + valuesOfBlock;
        const std::int8_t* d = c + valuesOfBlock;
        const float forA = scales[row] * coefficients[row];
        const float forB = scales[row + 1] * coefficients[row + 1];
        const float forC = scales[row + 2] * coefficients[row + 2];
        const float forD = scales[row + 3] * coefficients[row + 3];
#pragma omp simd
        for (std::int64_t i = 0; i < valuesOfBlock; ++i)
            values[i] += forA * static_cast<float>(a[i]) + forB * static_cast<float>(b[i]) +
                         forC * static_cast<float>(c[i]) + forD * static_cast<float>(d[i]);
    }
    for (; row < count; ++row) {
        const std::int8_t* a = steps + row * valuesOfBlock;
        const float forA = scales[row] * coefficients[row];
#pragma omp simd
        for (std::int64_t i = 0; i < valuesOfBlock; ++i)
            values[i] += forA * static_cast<float>(a[i]);
    }
}

QUADRILLE_SIMD_CLONES
void multiplySteps(const std::int8_t* steps, std::int64_t count, std::int32_t* products)
{
    // The largest sum is 1536 · 127², far below the limit of 32 bits.
    for (std::int64_t row = 0; row < count; ++row) {
        const std::int8_t* a = steps + row * valuesOfBlock;
        for (std::int64_t column = 0; column <= row; ++column) {
            const std::int8_t* b = steps + column * valuesOfBlock;
            std::int32_t sum = 0;
            for (std::int64_t i = 0; i < valuesOfBlock; ++i)
                sum += static_cast<std::int16_t>(a[i]) * static_cast<std::int16_t>(b[i]);
            products[row * count + column] = sum;
        }
    }
}

QUADRILLE_SIMD_CLONES
void multiplyValues(const std::int8_t* steps, std::int64_t count, const double* values, double* products)
{
    for (std::int64_t row = 0; row < count; ++row) {
        const std::int8_t* a = steps + row * valuesOfBlock;
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (std::int64_t i = 0; i < valuesOfBlock; ++i)
            sum += static_cast<double>(a[i]) * values[i];
        products[row] = sum;
    }
}

} // namespace quadrille
