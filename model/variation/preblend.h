// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/poissonsystem.h"
#include "model/sequence/axes.h"
#include "model/transition/interpolationmethod.h"
#include "model/variation/training.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

struct PreblendSettings
{
    UpAxis up = UpAxis::Y;
    InterpolationMethod method = InterpolationMethod::Poisson;
};

/// A movement between two takes on one reference (CVS §7): poses by non-linear interpolation, laid onto
/// the takes' template, placements by blendedPlacements, timing by blendedWarp. At 0 and 1 the takes
/// themselves, but for their names. \param weight  of the second take, 0 … 1. \throws Error BadArgument
/// (weight), VertexCountMismatch, Cancelled. Parallel over the frames.
AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, const AlignedTake& a,
                        const AlignedTake& b, double weight, std::string name,
                        const PreblendSettings& settings = {}, const Progress& progress = {});

/// Placements of a blend of two takes, from a first place in between: displacements are interpolated linearly
/// to a path on the ground, height and tilt are between those of the takes in every frame.
std::vector<RigidMotion> blendedPlacements(std::span<const RigidMotion> a, std::span<const RigidMotion> b,
                                           double weight, UpAxis up);

} // namespace quadrille
