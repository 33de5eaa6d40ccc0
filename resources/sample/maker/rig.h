// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/skeleton.h"
#include "model/sample/surfacemesh.h"
#include "resources/sample/maker/body.h"

namespace quadrille {

/// The 23 joints of a body: hips, spine, chest, neck, head, and on each side clavicle, upper arm, forearm,
/// hand, fingers, thigh, shin, foot, toes.
Skeleton makeSkeleton(const Body& body);

/// Bone heat: weights that are smooth on the surface and follow the nearest bone. Source: Baran and Popović,
/// Automatic Rigging and Animation of 3D Characters, 2007.
std::vector<VertexWeights> boneHeatWeights(const SurfaceMesh& mesh, const Skeleton& skeleton);

} // namespace quadrille
