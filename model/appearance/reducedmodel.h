// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"

namespace quadrille {

/// A model of textures that are smaller by a whole factor, for thumbnails: decoding it takes as much less
/// time as it has fewer texels. A texel is the mean of those that it covers and that belong to one chart.
/// Coefficients and eigenvalues stay as they are. \pre factor ≥ 1, and the spacing of the grid is a multiple
/// of it. \throws Error Cancelled. Cost: O(values · components).
AppearanceModel reduced(const AppearanceModel& model, int factor, const Progress& progress = {});

} // namespace quadrille
