// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinelayout.h"

namespace quadrille::widgets {

/// The nearest edge of a span, playhead, end of range or loop within six pixels of a boundary between frames
/// (boundary f lies before frame f), or the boundary itself.
/// \param except  a span whose edges do not count.
/// \param loop  whether the ends of the loop count.
int snappedBoundary(const TimelineLayout& layout, int boundary, const std::optional<SpanRef>& except,
                    bool loop);

/// Where a key would be at a place: the frame there, or the nearest within six pixels of it that a span, a
/// key or the playhead marks; kept inside the frames there are.
/// \param except  a key that does not count.
int keyFrameAt(const TimelineLayout& layout, double x, bool snap, const std::optional<SpanRef>& except);

} // namespace quadrille::widgets
