// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/modeltextures.h"
#include "model/project/results/projectresults.h"

#include <memory>
#include <string>

namespace quadrille {

/// A model of appearance as it is worked with.
struct OpenedAppearance
{
    FrameAppearances known;
    std::shared_ptr<const AppearanceDecoder> decoder; ///< null where nothing was computed yet
    bool isFresh = false;             ///< the model is as the project says, and what variations take from it
    bool areCompletionsFresh = false; ///< so are the textures that it completes
    std::string keys;                 ///< of the results that it was read from
};
using OpenedAppearancePointer = std::shared_ptr<const OpenedAppearance>;

/// Models as jobs see them. Copies, for a thread of its own; all of this header is called on threads of jobs.
/// \pre (of all functions) The project has a model of this name.
struct AppearanceJob
{
    WorkingProject working;
    std::string name;
    OpenedAppearancePointer before; ///< what was opened last; null for nothing
};

/// What the last rebuild left of a model, and whether that is as the project says; computes nothing. What was
/// opened already is not read again. \throws Error Cancelled, of opening sequences.
OpenedAppearancePointer openAppearance(const AppearanceJob& job, const Progress& progress);
/// Brings a model, and what variations take from it, up to date first. \throws Error of the step that failed,
/// Cancelled.
OpenedAppearancePointer buildAppearanceModel(const AppearanceJob& job, const Progress& progress);
/// Brings the model and the textures that it completes up to date first. \pre There are completions.
/// \throws as buildAppearanceModel.
OpenedAppearancePointer completeAppearance(const AppearanceJob& job, const Progress& progress);

} // namespace quadrille
