// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/similarity.h"

#include <vector>

namespace quadrille::test {

/// A node in a frame.
struct PlainState
{
    std::vector<Vec3d> pose;
    std::vector<Vec3d> velocity; ///< for a frame of time
};

PlainState plainState(const MotionSpace& space, std::size_t frame, std::size_t node);

/// d of two states, coordinate by coordinate.
double plainDistance(const PlainState& source, const PlainState& target, double velocityWeight);

/// All of a table, by plain loops.
std::vector<float> plainSimilarities(const MotionSpace& source, const MotionSpace& target,
                                     double velocityWeight);

} // namespace quadrille::test
