// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/projectionentry.h"

namespace quadrille::test {

/// With every key that is known.
inline ProjectionEntry fullProjection()
{
    ProjectionEntry entry;
    entry.name = "filmed";
    entry.clip = "sequences/talk";
    entry.cameras = "studio/cameras.json";
    entry.cameraAxes = CoordinateSystem{UpAxis::Z, 0.001};
    entry.size = 2048;
    entry.sharpness = 6;
    entry.fills = false;
    return entry;
}

} // namespace quadrille::test
