// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/similarity.h"
#include "model/project/steps/buildstep.h"
#include "model/project/steps/motionspacework.h"

#include <memory>
#include <string>
#include <string_view>

namespace quadrille {

// The names of the steps of a motion space, and of a pair of them.

std::string motionSpaceStepOf(const std::string& space);
/// The motion space of such a step; empty for any other one.
std::string motionSpaceOfStep(std::string_view step);
std::string motionSpaceQualityStepOf(const std::string& space);
std::string similarityStepOf(const std::string& source, const std::string& target);
std::string transitionReportStepOf(const std::string& source, const std::string& target);

/// A space as its step stored it, shared by all who want it.
/// \pre The context has the result of its step. \throws Error what opening a take of it throws.
std::shared_ptr<const MotionSpace> sharedMotionSpace(const MotionSpaceWork& work, const StepContext& context,
                                                     const Progress& progress = {});
/// The table of two spaces, likewise. \pre The context has the result of its step.
std::shared_ptr<const SimilarityTable>
sharedSimilarities(const std::string& source, const std::string& target, const StepContext& context);

} // namespace quadrille
