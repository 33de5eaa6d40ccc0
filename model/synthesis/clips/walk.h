// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/framelayout.h"
#include "model/transition/warppath.h"

#include <vector>

namespace quadrille {

/// Frames of one sequence played as captured, both included.
struct WalkSpan
{
    NodeIndex first = 0;
    NodeIndex last = 0;

    NodeIndex frameCount() const { return last - first + 1; }
    bool operator==(const WalkSpan&) const = default;
};

/// A walk through a graph: captured spans, joined by the transitions from the last frame of each to the first
/// of the next. A span of one frame joins two transitions. A transition that lasts L frames begins with the
/// last frame of the span before it and ends with the first of the one behind; each frame is shown once.
struct Walk
{
    std::vector<WalkSpan> spans;

    bool operator==(const Walk&) const = default;
    bool isEmpty() const { return spans.empty(); }
    std::size_t transitionCount() const { return spans.empty() ? 0 : spans.size() - 1; }
    FramePair transition(std::size_t index) const { return {spans[index].last, spans[index + 1].first}; }
};

} // namespace quadrille
