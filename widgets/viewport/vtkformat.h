// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QSurfaceFormat>

namespace quadrille::widgets {

/// What VTK needs of an OpenGL context.
QSurfaceFormat viewFormat();

/// Whether a processor draws in place of a graphics card.
/// \pre VtkView::openGlAvailable()
bool isDrawnByProcessor();

} // namespace quadrille::widgets
