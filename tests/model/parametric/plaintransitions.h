// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/onlinetransition.h"

#include <vector>

namespace quadrille::test {

/// What TransitionSearch finds, by trying everything.
std::vector<TransitionChoice> plainTransitions(const SimilarityTable& table, const MotionSpace& source,
                                               const MotionSpace& target, const SpaceState& state,
                                               const TransitionGoal& goal,
                                               const TransitionSearchSettings& settings);

} // namespace quadrille::test
