// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clipplan.h"

#include <optional>

namespace quadrille {

/// How fast feet slide in a transition: the mean, over its frames, of slideOf the feet that stand there
/// (units of length a second). Nothing where none does: in flight.
/// \param clip  what makeClip makes of the plan that has the junction, corrected or not. \param standing  of
/// each of its frames: of stancesOf, before any correction.
std::optional<double> footSlide(const Clip& clip, const ClipPlan::Junction& junction, const RootPoses& roots,
                                std::span<const std::uint32_t> standing);

/// By how much the velocity of the body's centre over the ground is another behind a transition than before:
/// the length of the difference of both, each taken over up to three captured frames, as the clip shows them
/// (units of length a second). Nothing where there are no frames before or behind.
std::optional<double> speedJump(const ClipPlan& plan, const ClipPlan::Junction& junction, double fps);

} // namespace quadrille
