// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/clip.h"

namespace quadrille {

/// Where a pose between the poses of two frames comes from, if one origin can say it: between two captured
/// frames, or on the way between two frames that both origins name. Otherwise the nearer frame's origin.
/// \param lambda  weight of the second, in [0, 1].
FrameProvenance originBetween(const FrameProvenance& first, const FrameProvenance& second, double lambda);

} // namespace quadrille
