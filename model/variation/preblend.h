// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/poissonsystem.h"
#include "model/transition/interpolationmethod.h"
#include "model/variation/training.h"

#include <memory>
#include <string>

namespace quadrille {

/// A movement between two takes on one reference (CVS §7): poses by non-linear interpolation, displacements
/// linearly, timing by blendedWarp. At 0 and 1 the takes themselves, but for their names.
/// \param weight  of the second take, 0 … 1.
/// \throws Error BadArgument (weight), VertexCountMismatch, Cancelled. Parallel over the frames.
AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, const AlignedTake& a,
                        const AlignedTake& b, double weight, std::string name,
                        InterpolationMethod method = InterpolationMethod::Poisson,
                        const Progress& progress = {});

/// Placements of a blend of two takes: displacements in between, from a first place in between.
std::vector<RigidMotion> blendedPlacements(std::span<const RigidMotion> a, std::span<const RigidMotion> b,
                                           double weight);

} // namespace quadrille
