// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/openanimation.h"

#include <vector>

namespace quadrille {

/// A stretch of a clip that is of one kind.
struct ClipPart
{
    bool isJunction = false; ///< made from two takes, otherwise captured
    int index = -1;    ///< of the span or of the junction of the walk; −1: made by what happens afterwards
    FrameRange frames; ///< of the clip as it is shown
    bool operator==(const ClipPart&) const = default;
};

/// For each frame of an animation's clip as it is shown the planned frame that it shows; −1 where there is
/// none because loops and the like made it. A frame of the plan that comes several times is the next one
/// after what was shown before. Cost: O(n log n).
std::vector<std::int64_t> plannedFrames(const AnimationResult& result);

/// What a clip as it is shown is put together from, from its first frame to its last.
/// \param planned  as plannedFrames says.
std::vector<ClipPart> clipParts(const AnimationResult& result, const std::vector<std::int64_t>& planned);

/// The first run of frames of the clip as it is shown that show planned frames of a range; empty for none.
/// \param planned  as plannedFrames says. \param range  of planned frames.
std::optional<FrameRange> shownRange(const std::vector<std::int64_t>& planned, FrameRange range);

} // namespace quadrille
