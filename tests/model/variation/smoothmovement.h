// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

namespace quadrille::test {

/// Rows of several takes of one cyclic movement.
struct SmoothMovement
{
    RowMatrix rows; ///< frames × coordinates, centred
    std::vector<RowSpan> spans;
};

/// Takes of a movement in few dimensions that smooth random maps take to many coordinates of some 0.1 m, with
/// noise.
/// \param noise  its standard deviation, metres.
SmoothMovement smoothMovement(int takes, Eigen::Index framesOfTake, Eigen::Index coordinates,
                              std::uint64_t seed, double noise = 0.001);

/// Latents and hyperparameters without any order, for tests of derivatives.
GpdmState randomState(Eigen::Index frames, int dimensions, std::uint64_t seed);

} // namespace quadrille::test
