// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/surfacedistances.h"
#include "model/sequence/axes.h"

#include <array>
#include <vector>

namespace quadrille {

/// What sticks out of a body.
struct Limb
{
    VertexIndex tip;              ///< its far end
    std::vector<float> distances; ///< of all vertices from the tip over the surface, metres
};

/// The limbs of a humanoid, left and right.
struct BodyLimbs
{
    std::array<Limb, 2> hands;
    std::array<Limb, 2> feet;
    bool hasMore = false; ///< more sticks out than four limbs: a head, hair
    double height = 0;    ///< of the figure, metres
    Vec3d up = Vec3d::UnitY();
};

/// The places of the largest component that stick out farthest from its middle: feet are the lowest, hands
/// are those of the others that lie farthest from each other; left is told by where the toes point. \throws
/// Error PartsNoLimbs (found: what sticks out) where fewer than four do or more than two stand on the ground,
/// Cancelled.
BodyLimbs findLimbs(const SurfaceGraph& graph, UpAxis up, const Progress& progress);

/// Over the surface, metres; infinite where no way leads.
std::vector<float> distancesFrom(const SurfaceGraph& graph, VertexIndex vertex);

} // namespace quadrille
