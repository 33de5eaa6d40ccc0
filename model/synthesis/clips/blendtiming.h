// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/warppath.h"

#include <cmath>
#include <vector>

namespace quadrille {

/// Which moments of its two windows a transition shows.
enum class BlendTiming
{
    Cells, ///< the frames of the warp path's cells (SMCAS Alg. 1); poses stop where it repeats a frame
    /// Both sequences play on at a speed that follows the path but changes gently, and leave and arrive at
    /// their own; between captured frames vertices go straight.
    Smooth,
};

/// A moment of a sequence: a frame, and how far on to the next one.
struct FrameTime
{
    NodeIndex frame = 0;
    double part = 0; ///< in [0, 1); 0 at the last frame of a sequence

    NodeIndex next() const { return part > 0 ? frame + 1 : frame; }
    NodeIndex nearest() const { return part < 0.5 ? frame : frame + 1; }
    bool operator==(const FrameTime&) const = default;
};

/// The moments of both windows at one frame of a transition.
struct BlendTimes
{
    FrameTime source;
    FrameTime destination;
};

/// One for each cell of the path. They rise, stay in the windows, begin at pose i and end at pose j.
std::vector<BlendTimes> blendTimes(const Transition& transition, BlendTiming timing);

} // namespace quadrille
