// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/animate.h"
#include "model/project/store/result.h"

#include <string>

namespace quadrille {

/// The step that finds the walk of an animation.
std::string walkStepOf(const std::string& animation);

/// A motion over the ground as an array of three numbers.
DataArray groundMotionArray(std::string name, std::string description, const GroundMotion& motion);

GroundMotion groundMotionOf(const DataArray& array);
/// How long a clip lasts before it is retimed, see PostProcessed.
DataArray framesBeforeRetimeArray(std::int64_t frames);

/// A walk with its report, as the step of walks stores it.
Result walkResult(const AnimationEntry& animation, const CharacterGraph& graph, const AnimationWalk& walk);

/// What walkResult made of a walk. \pre The result is one of walkResult, of this animation and graph.
/// \throws Error as walkConstraints.
AnimationWalk storedWalk(const Result& result, const AnimationEntry& animation, const CharacterGraph& graph);
/// The spans and the place of it alone, which are all that a clip is made of; the one action is all that was
/// asked for. \pre as storedWalk.
WalkSolution shownWalkOf(const Result& result, const CharacterGraph& graph);

} // namespace quadrille
