// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/quantisedspace.h"

#include <cstdint>

namespace quadrille {

// Sums over one block of QuantisedSpace::blockSize values; `steps` is a matrix of count × blockSize.

/// values = meanStep · mean + Σ scale · coefficient · steps.
void combineSteps(const std::int16_t* mean, float meanStep, const std::int8_t* steps, const float* scales,
                  const float* coefficients, std::int64_t count, float* values);

/// The products of all rows with each other, the lower triangle of count × count.
void multiplySteps(const std::int8_t* steps, std::int64_t count, std::int32_t* products);

/// The products of all rows with some values.
void multiplyValues(const std::int8_t* steps, std::int64_t count, const double* values, double* products);

} // namespace quadrille
