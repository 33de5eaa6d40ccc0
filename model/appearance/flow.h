// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/chartlookup.h"
#include "model/appearance/flowmethod.h"
#include "model/core/progress.h"

namespace quadrille {

struct FlowOptions
{
    FlowMethod method = FlowMethod::TvL1;
    /// Brightness is compared after its local mean and deviation were taken out, over this radius (standard
    /// deviation, texels): smaller ones are less misled by light, larger ones less by noise.
    double normalisation = 2;
    /// Of TV-L1: less makes smoother fields.
    double lambda = 0.05;
};

/// Where the texels of one texture are in another: fixed(x) ≈ moving(x + f(x)), whatever smooth light did to
/// them. Only covered texels take part; see ChartLookup::keepInside for the others. Computes on the calling
/// thread.
///
/// \pre Both textures have the size of the atlas.
/// \return a displacement for each used texel, in texels.
/// \throws Error BadArgument where a side has less than 32 texels, Cancelled (asked between the stages of the
/// flow).
std::vector<Vec2f> denseFlow(const Image& fixed, const Image& moving, const ChartLookup& charts,
                             const FlowOptions& options = {}, const Progress& progress = {});

} // namespace quadrille
