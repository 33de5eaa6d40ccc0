// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/variation/movement.h"

#include <vector>

namespace quadrille {

/// Of each captured take, how far a pose of its movement may be from all others that were learned from,
/// metres: of its frames that one which is farthest from the nearest pose of the other takes of the same
/// movement (sameMovement), and of theirs, the mean over these takes. Of a take alone it is a guess:
/// shareOfOneTake of how far its frames are from their mean pose (see PoseSpread::reference), three times.
/// Cost: as nearestPoses of the frames of all takes. \throws Error Cancelled.
std::vector<double> poseReaches(const Movement& movement, const Progress& progress = {});

} // namespace quadrille
