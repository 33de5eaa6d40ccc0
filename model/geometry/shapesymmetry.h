// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/symmetry.h"

#include <vector>

namespace quadrille {

/// The plane across which a pose is most like its own reflection.
struct ShapeSymmetry
{
    ReflectionPlane plane;
    struct Counterpart
    {
        TriangleIndex triangle;
        Vec3f weights = Vec3f::Zero(); ///< of its corners, not negative, together 1
    };
    /// Per vertex the surface point nearest to its reflection.
    std::vector<Counterpart> counterparts;
};

/// Tries planes through the middle in many directions and improves each by turns of nearest vertices and best
/// plane. \pre The topology has triangles. \throws Error Cancelled.
ShapeSymmetry shapeSymmetry(const Topology& topology, Positions pose, const Progress& progress = {});

} // namespace quadrille
