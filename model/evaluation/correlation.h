// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <span>

namespace quadrille {

/// Pearson's correlation of two samples; 0 where one of them does not vary.
/// \pre As many values in both, finite.
double pearsonCorrelation(std::span<const double> x, std::span<const double> y);

/// Distance correlation of two samples: 0 where they are independent, 1 where one is a linear function of the
/// other; 0 where one of them does not vary. The root of the ratio of V-statistics (Székely, Rizzo & Bakirov
/// 2007), exact, without the table of all differences (Huo & Székely 2016).
/// \pre As many values in both, finite. \throws Error Cancelled. Cost: O(n log n).
double distanceCorrelation(std::span<const double> x, std::span<const double> y,
                           const Progress& progress = {});

} // namespace quadrille
