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

/// A take and its share in a blend.
struct TakeShare
{
    const AlignedTake* take = nullptr;
    double share = 0;
};

/// A movement between takes on one reference (CVS §7): poses by non-linear interpolation, of more than two
/// takes one after the other, laid onto their template; placements by blendedPlacements, timing by
/// blendedWarp, coefficients linearly. Where one take is all of it, that take, but for its name. \throws
/// Error BadArgument (shares below 0, or that do not add up to 1), VertexCountMismatch, Cancelled. Parallel
/// over the frames.
AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, std::span<const TakeShare> takes,
                        std::string name, const PreblendSettings& settings = {},
                        const Progress& progress = {});
/// Of two takes. \param weight  of the second, 0 … 1.
AlignedTake blendedTake(const std::shared_ptr<const PoissonSystem>& system, const AlignedTake& a,
                        const AlignedTake& b, double weight, std::string name,
                        const PreblendSettings& settings = {}, const Progress& progress = {});

/// Placements of a blend of takes, from a first place in between: displacements are interpolated linearly to
/// a path on the ground, height and tilt are between those of the takes in every frame.
/// \pre Some shares, greater than 0, that add up to 1.
std::vector<RigidMotion> blendedPlacements(std::span<const TakeShare> takes, UpAxis up);

} // namespace quadrille
