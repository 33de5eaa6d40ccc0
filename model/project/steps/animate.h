// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/charactergraph.h"
#include "model/synthesis/clips/clipplan.h"
#include "model/synthesis/finishing/postprocessing.h"
#include "model/synthesis/finishing/repeats.h"
#include "model/synthesis/walks/constraints.h"

namespace quadrille {

/// A walk with what was asked of it; nothing was where the animation has a walk already.
struct AnimationWalk
{
    WalkConstraints constraints;
    WalkSolution solution;
};

/// How the transitions of an animation are blended.
BlendSettings blendSettings(const AnimationEntry& animation);

/// Whether the walk of an animation goes on before and after its actions, so that its loop can blend there.
bool hasLoopEnds(const AnimationEntry& animation);

/// The walk of an animation: the one that it has, or the one that is found.
/// \param found  receives each better walk as findWalk tells it.
/// \throws Error as walkConstraints and findWalk, with frames called by their sequences.
AnimationWalk animationWalk(const AnimationEntry& animation, const CharacterGraph& graph,
                            const Progress& progress = {}, const SolutionCallback& found = {});

/// Its frames before any post-processing, turned towards a path. \throws Error as planClip.
ClipPlan animationPlan(const AnimationEntry& animation, const CharacterGraph& graph,
                       const WalkSolution& solution, const std::optional<PathConstraint>& path);

/// The clip of an animation and what it was made of.
struct AnimationClip
{
    PostProcessed processed;
    ClipPlan plan; ///< before post-processing, with the variations that the first playing shows
    /// Of its walk, for each playing of a loop; nothing is drawn where the animation has no such option.
    std::vector<SpanDraw> spans;
    bool hasNoFeet = false; ///< so that contacts could not be corrected as asked
};

/// How often the walk of an animation is played, as a loop.
int playingsOf(const AnimationEntry& animation);

/// What its clip is made of, without making it.
struct PlannedClip
{
    ClipPlan plan;               ///< before post-processing, with the variations that the first playing shows
    std::vector<SpanDraw> spans; ///< see AnimationClip
};
/// \throws Error as variedPlan.
PlannedClip plannedClip(const AnimationEntry& animation, const CharacterGraph& graph,
                        const CharacterFrames& frames, const ClipPlan& plan,
                        std::span<const TakeVariation> variations = {}, const Progress& progress = {});

/// Its clip, after post-processing. Playings of a loop differ where variations are there to draw from.
/// \param variations  what repeats are drawn from, of clipsDrawnFrom; origins count them from 1.
/// \throws Error as variedPlan, makeClip and postProcessed.
AnimationClip animationClip(const AnimationEntry& animation, const CharacterGraph& graph,
                            const CharacterFrames& frames, const ClipPlan& plan,
                            std::span<const TakeVariation> variations = {}, const Progress& progress = {});

} // namespace quadrille
