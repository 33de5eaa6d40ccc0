// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/transfer/transferclip.h"

#include <span>
#include <vector>

namespace quadrille {

/// How many pairs are proposed where nobody says.
inline constexpr std::size_t usualPairs = 120;

/// A pair that was proposed.
struct ProposedPair
{
    TrianglePair pair;
    /// How alike the places are, 1 where nothing tells them apart; below about 0.3 it deserves a look.
    double quality = 0;
};

/// Pairs of triangles of two humanoids, whatever their poses and proportions: what lies on each other once
/// the template has been laid onto the target (bodyalignment.h). The template's triangles lie as far from
/// each other as they can, and nearer where it bends.
/// \param reference, target  arms and legs that do not touch each other, feet on the ground.
/// \param performed  poses of the template, all vertices, that tell where it bends; or none.
/// \param count  how many at most; fewer where several would have one triangle of the target.
/// \throws Error TransferNoLimbsOfTemplate, TransferNoLimbsOfTarget, Cancelled.
/// Cost: that of BodyPlaces for each mesh and of BodyAlignment, O(count · triangles · (1 + poses)).
std::vector<ProposedPair> proposePairs(const PosedMesh& reference, const PosedMesh& target, UpAxis up,
                                       std::span<const std::vector<Vec3f>> performed = {},
                                       std::size_t count = usualPairs, const Progress& progress = {});

} // namespace quadrille
