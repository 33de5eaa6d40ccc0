// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/framelayout.h"

namespace quadrille {

/// A source frame and a destination frame: a cell of a warp path, or the two ends of a transition.
struct FramePair
{
    NodeIndex source = 0;
    NodeIndex destination = 0;
    bool operator==(const FramePair&) const = default;
};

} // namespace quadrille
