// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/surfacemesh.h"
#include "model/sample/takes.h"

namespace quadrille {

/// The figure whose surface is moved: what does not change from take to take.
struct Performer
{
    SurfaceMesh mesh;
    std::vector<Vec3d> normals;
    Skeleton skeleton;
    std::vector<VertexWeights> weights;
};

/// Vertices of every frame: skinned, then moved by what follows late or swells – breath, belly, muscles,
/// cloth – a few millimetres to a centimetre. \return frames × vertices.
std::vector<Vec3f> moveSurface(const Performer& performer, const std::vector<SkeletonPose>& poses,
                               double breathPhase);

} // namespace quadrille
