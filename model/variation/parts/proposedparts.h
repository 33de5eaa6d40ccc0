// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/variation/parts/bodyparts.h"

#include <memory>
#include <vector>

namespace quadrille {

/// Curves and parts that cut a body; `cutIntoParts` takes them.
struct ProposedParts
{
    std::vector<PartCurve> curves;
    std::vector<PartDescription> parts;
};

struct ProposalSettings
{
    UpAxis up = UpAxis::Y;
    /// Width of overlaps, heights of the figure: 7.5 cm for somebody of 1.75 m.
    double overlap = 0.043;
};

/// Cuts a humanoid into five parts – "torso", "left arm", "right arm", "left leg", "right leg" – from one
/// pose in which arms and legs stick out: curves where the shortest loop around a limb begins to grow as fast
/// as one goes on over the body, at armpits and crotch, each with a second one further out on the limb. Left
/// is told by where the toes point. \param pose  of all vertices, metres, standing. \throws Error
/// PartsNoLimbs (found), PartsLimbGrown (limb), PartsNotCut (limb), Cancelled.
ProposedParts proposeParts(const std::shared_ptr<const Topology>& topology, Positions pose,
                           const ProposalSettings& settings = {}, const Progress& progress = {});

} // namespace quadrille
