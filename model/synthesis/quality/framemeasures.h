// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/supports.h"
#include "model/transition/characterframes.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// How a captured frame moves, by what the eye notices.
struct FrameMeasure
{
    /// Root mean square over the vertices, m/s²; nothing at the ends of a sequence.
    std::optional<double> acceleration;
    double volume = 0; ///< m³; of open surfaces that of the cone over their vertices' mean
    /// Mean horizontal speed, until the next frame, of the vertices that stand in both, m/s; nothing where
    /// there are none.
    std::optional<double> slip;
};

/// \param supports  of each frame; empty: slips are not measured. \throws Error what reading frames throws,
/// Cancelled. Cost: O(frames · vertices).
std::vector<FrameMeasure> frameMeasures(const CharacterFrames& character, std::span<const Support> supports,
                                        UpAxis up, const Progress& progress = {});

/// Root mean square over the vertices of the second difference · fps², m/s².
double rmsAcceleration(Positions before, Positions now, Positions after, double fps);
/// Mean distance of the vertices, metres.
double meanStep(Positions from, Positions to);
/// Signed, m³.
double enclosedVolume(Positions positions, std::span<const Triangle> triangles);
/// Mean horizontal distance of some vertices, metres. \pre There are any.
double meanSlip(Positions from, Positions to, std::span<const std::uint32_t> vertices, const Ground& ground);

} // namespace quadrille
