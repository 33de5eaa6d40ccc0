// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/sample/surfacemesh.h"
#include "model/sample/texelmap.h"
#include "resources/sample/maker/paint.h"

namespace quadrille {

/// The painted texture with soft shadows in corners and folds.
Image bakeTexture(const SurfaceMesh& mesh, const Body& body, const TexelMap& texels, const Palette& palette);

} // namespace quadrille
