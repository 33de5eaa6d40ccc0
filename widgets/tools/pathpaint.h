// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/pathdrawing.h"

class QPainter;

namespace quadrille::widgets {

// What of a path lies over the picture of the scene, in logical pixels of the view.

/// Its handles, which way it runs, and what holds points in space.
void paintPath(QPainter& painter, const PathLayout& layout, const PathPart& hovered);
/// What is being drawn, and how.
void paintPathDrawing(QPainter& painter, const PathLayout& layout, const PathDrawing& drawing,
                      const PathSampler& sampler);

} // namespace quadrille::widgets
