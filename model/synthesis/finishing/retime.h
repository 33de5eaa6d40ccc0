// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/finishing/loop.h"
#include "model/synthesis/finishing/postprocessingsettings.h"
#include "model/transition/interpolationmethod.h"

#include <vector>

namespace quadrille {

/// Which moment of a clip each frame of its retiming shows.
/// \param frames  that the clip lasts, from its first moment to its last: one less than it has, or as many as
/// a cycle has, at least 1 where the result has more than one frame.
/// \return moments of the result's frames and of its end, in frames of the clip, not falling, in [0, frames].
/// The frames are as many as come nearest to the duration asked for, so that both ends are met.
/// \throws Error TimeCurveNotMonotone; BadArgument (factor or duration not positive and finite, fewer than
/// two points, times beyond the clip, more than 1,000,000 frames).
std::vector<double> retimedMoments(const RetimeSettings& settings, std::int64_t frames, double fps);

/// The clip at other times. Moments that are frames show them bit for bit; those between are interpolated;
/// see originBetween for where they come from. A clip of one frame lasts as long as asked for.
/// \throws Error as retimedMoments, Cancelled. Cost: one interpolation for each frame between two.
Clip retimed(const Clip& clip, const RetimeSettings& settings, UpAxis up,
             InterpolationMethod interpolation = InterpolationMethod::Poisson, const Progress& progress = {});

/// The cycle at other times, so that it closes as before; with the root's speed kept it travels another way.
/// \throws Error as above; BadArgument also where a curve does not go all round the cycle.
Loop retimed(const Loop& loop, const RetimeSettings& settings, UpAxis up,
             InterpolationMethod interpolation = InterpolationMethod::Poisson, const Progress& progress = {});

} // namespace quadrille
