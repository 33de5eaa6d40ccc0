// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/synthesis/quality/framemeasures.h"

#include <span>

namespace quadrille {

/// How fast vertices speed up and slow down where a pair of sequences is lively: the 95th percentile of the
/// frames' rms accelerations, those of both together. \return sequences × sequences, m/s²; symmetric; 0 where
/// neither has three frames.
Table<double> livelinessOf(std::span<const FrameMeasure> measures, const FrameLayout& layout);

/// Costs of transitions that weigh by what their takes let pass unnoticed: D of each pair times the median
/// liveliness over that of its two sequences. A blend that nobody sees between two runs is a jerk between two
/// people who stand. Warp paths and windows stay the same, as the factor is one for all windows of a pair.
/// \param cost  D, frames × frames. \param liveliness  of livelinessOf; pairs where it is 0 keep their cost.
Table<float> costPerLiveliness(Table<float> cost, const FrameLayout& layout, const Table<double>& liveliness);

} // namespace quadrille
