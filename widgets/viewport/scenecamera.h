// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

class vtkRenderer;

namespace quadrille::widgets {

// What all scenes that are looked at with a turntable have in common.

/// Looks as a turntable says. \param nearest, farthest  what is drawn, from the camera.
void lookWith(vtkRenderer* renderer, const Turntable& camera, double nearest, double farthest);
/// The theme's gradient behind all.
void updateBackground(vtkRenderer* renderer);

} // namespace quadrille::widgets
