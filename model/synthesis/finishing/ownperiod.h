// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/ground.h"
#include "model/transition/posedistancesettings.h"

#include <optional>

namespace quadrille {

/// A clip that already goes round, as animations for games do.
struct OwnPeriod
{
    std::int64_t frames = 0; ///< all of the clip, or one less where the last frame shows the first one again
    GroundMotion travel;     ///< from one cycle to the next
    float distance = 0;      ///< of the poses of the last and the first frame
};

/// Whether the first frame follows the last one as frames at both ends follow each other, or is the last one
/// over again, moved over the ground. Nothing where it does not, and where the clip has fewer than 4 frames.
/// \throws Error as poseDistances.
std::optional<OwnPeriod> ownPeriod(const Clip& clip, UpAxis up, const PoseDistanceSettings& pose);

/// Some frames of a clip as a sequence, both ends included.
MeshSequence partOf(const Clip& clip, std::int64_t first, std::int64_t last);

} // namespace quadrille
