// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/units.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// The pose that is nearest to another one.
struct NearestPose
{
    std::int64_t index = -1; ///< of those to choose from; −1 where there are none
    double distance = 0;     ///< mean over the vertices after rigid Procrustes, metres
};

/// Of each pose the nearest of some others, by euclideanDistance; of those as near the first.
/// \pre All poses have as many vertices, at least one.
/// \return the same for any number of threads.
/// \throws Error Cancelled. Cost: O(poses · others · vertices).
std::vector<NearestPose> nearestPoses(std::span<const Positions> poses, std::span<const Positions> others,
                                      const Progress& progress = {});

} // namespace quadrille
