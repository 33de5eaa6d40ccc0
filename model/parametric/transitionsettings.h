// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille {

struct TransitionSearchSettings
{
    int depth = 12;           ///< of the trellis on either side, frames
    double latencyWeight = 5; ///< λ of IA4D eq. 4, for a frame; greater than 0
    int steps = 10;           ///< of each axis' range
    double stepsAFrame = 1;   ///< by so many a place moves a frame at most; IA4D: 1
    std::size_t choices = 6;  ///< how many are found, at least 1

    bool operator==(const TransitionSearchSettings&) const = default;
};

} // namespace quadrille
