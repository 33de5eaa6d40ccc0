// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/charactergraph.h"
#include "model/synthesis/clipplan.h"
#include "model/synthesis/constraints.h"
#include "model/synthesis/postprocessing.h"

namespace quadrille {

/// A walk with what was asked of it; nothing was where the animation has a walk already.
struct AnimationWalk
{
    WalkConstraints constraints;
    WalkSolution solution;
};

/// The walk of an animation: the one that it has, or the one that is found.
/// \param found  receives each better walk as findWalk tells it.
/// \throws Error as walkConstraints and findWalk, with frames called by their sequences.
AnimationWalk animationWalk(const AnimationEntry& animation, const CharacterGraph& graph,
                            const Progress& progress = {}, const SolutionCallback& found = {});

/// Its frames before any post-processing. \throws Error as planClip.
ClipPlan animationPlan(const AnimationEntry& animation, const CharacterGraph& graph, const Walk& walk,
                       const GroundMotion& start);

/// Its clip, after post-processing. \throws Error as makeClip and postProcessed.
PostProcessed animationClip(const AnimationEntry& animation, const CharacterGraph& graph,
                            const CharacterFrames& frames, const ClipPlan& plan,
                            const Progress& progress = {});

} // namespace quadrille
