// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/synthesis/clips/ground.h"
#include "model/synthesis/clips/transitionmotion.h"
#include "model/transition/characterframes.h"
#include "model/transition/transitionsettings.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace quadrille {

/// What a curve over the ground says about a motion.
struct CurveMeasures
{
    double length = 0;       ///< metres along the curve
    double distance = 0;     ///< metres between its ends
    double greatestTurn = 0; ///< largest change of direction from one frame to the next, radians
    int reversals = 0;       ///< changes of direction by more than a quarter turn
};

/// Steps shorter than a tenth of the mean have no direction of their own and are left out of turns.
CurveMeasures measureCurve(std::span<const Vec2d> points);

/// How far a motion turns from its first frame to its last, radians, counter-clockwise seen from above.
/// \throws Error as MeshSequence::frame.
double netTurning(const MeshSequence& sequence, const Ground& ground);

/// The warp path that blends as much as it can of one sequence into another: windows of up to the longest of
/// the settings, neither more than twice as long as the other, where the poses go together best. Windows
/// shorter than those of a transition are taken where a sequence has no more.
/// \param distances  frames × frames, of both sequences, the source first.
/// \throws Error BadArgument from checkSettings.
Transition longBlend(TableView<float> distances, const FrameLayout& layout,
                     const TransitionSettings& settings);

/// A blend of two sequences (SMCAS Fig. 11–12).
struct BlendTrajectory
{
    BlendAlignment alignment = BlendAlignment::EveryStep;
    std::vector<Vec3d> centres; ///< of each frame
    CurveMeasures measures;     ///< seen from above
};

/// The centre of a blend by every alignment: none, in the middle of the windows, at every step.
/// \param constantWeight  of the destination; empty: from 0 to 1.
std::vector<BlendTrajectory> blendTrajectories(const RootPoses& roots, const Transition& transition,
                                               std::optional<double> constantWeight);

} // namespace quadrille
