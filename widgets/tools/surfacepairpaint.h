// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/surfacepairlayout.h"

class QPainter;

namespace quadrille::widgets {

/// The ends of all pairs that can be seen; the hovered and the selected pair with a line between its ends,
/// and its name.
void paintSurfacePairs(QPainter& painter, const SurfacePairLayout& layout, const PairEnd& hovered);

/// The first end of a pair that is being made, with a line to the pointer.
void paintBegunPair(QPainter& painter, const SurfacePairLayout& layout, const QPointF& pointer);

} // namespace quadrille::widgets
