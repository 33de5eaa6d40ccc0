// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/scene/polygongeometry.h"
#include "model/sequence/io/scene/scene.h"

#include <span>

struct aiScene;

namespace quadrille {

/// Gives meshes that Assimp split at every corner the vertices of the file again, in its order; meshes that
/// are none of the geometries stay split.
/// \param scene  what sceneFromAssimp made of `source`.
void restoreControlPoints(Scene& scene, const aiScene& source, std::span<const PolygonGeometry> geometries);

} // namespace quadrille
