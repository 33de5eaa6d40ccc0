// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/sample.h"
#include "resources/sample/maker/bodymesh.h"
#include "resources/sample/maker/paint.h"

namespace quadrille {

/// Proportions of the second body: shorter, stockier, with longer arms.
Proportions targetProportions();

/// Edge lengths that are short at face, fingers and feet. \param scale on all lengths.
EdgeLength edgeLengthFor(const Body& body, double scale);

/// What the second body wears.
Palette targetPalette();

/// The same named places on two bodies.
std::vector<LandmarkPair> makeLandmarks(const Body& one, const SurfaceMesh& oneMesh, const Body& other,
                                        const SurfaceMesh& otherMesh);

} // namespace quadrille
