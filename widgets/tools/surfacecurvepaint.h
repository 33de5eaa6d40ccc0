// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/surfacecurvedrawing.h"

class QPainter;

namespace quadrille::widgets {

// What of curves on a surface lies over the picture of the scene, in logical pixels of the view. Colours are
// the theme's.

/// How curves are worked on.
struct SurfaceCurveLook
{
    bool isDrawing = false;   ///< points are added to the drawn curve
    SurfaceCurvePart hovered; ///< under the pointer
    QString refusal;          ///< why the last gesture could not be done
    QRectF occupied;          ///< names keep away from it
};

/// The curves, thin and dashed where the body hides them, with their names and points. What is wrong with one
/// stands in the place of its name while it is selected.
void paintSurfaceCurves(QPainter& painter, const SurfaceCurveLayout& layout, const SurfaceCurveLook& look);
/// Where the curve would go on.
void paintSurfaceDrawing(QPainter& painter, const SurfaceCurveLayout& layout,
                         const SurfaceCurveDrawing& drawing, const SurfaceCurveLook& look);
/// What mouse and keys do now, or why they could not.
void paintSurfaceHint(QPainter& painter, const SurfaceCurveLayout& layout, const SurfaceCurveLook& look);

} // namespace quadrille::widgets
