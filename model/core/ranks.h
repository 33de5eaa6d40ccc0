// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The value that so large a share of the values does not exceed (the least such of them); 0 where there are
/// none. \param share  0 … 1: 0.5 is the median.
double quantile(std::vector<double> values, double share);

/// Places of values among each other, from 1; equal values share the mean of their places.
std::vector<double> ranksOf(std::span<const double> values);

/// Spearman's rank correlation, in [−1, 1]; nothing where either has less than two different values.
/// \pre As many values on either side.
std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b);

/// The probability that a score is higher where something is so than where it is not, ties counting half
/// (area under the receiver operating characteristic): ½ tells nothing, 1 all. Nothing where all or none are
/// so. \pre As many of both.
std::optional<double> areaUnderCurve(std::span<const double> scores, const std::vector<bool>& isSo);

} // namespace quadrille
