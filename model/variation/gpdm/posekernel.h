// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille {

/// Four sums of the rows of one panel.
/// \param coefficients  rows × 4. \param out  4 × 16.
void combinePanel(const float* panel, const float* coefficients, std::ptrdiff_t rows, float* out);

} // namespace quadrille
