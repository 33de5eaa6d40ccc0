// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/evaluation/appearanceerrors.h"
#include "model/project/steps/appearancework.h"
#include "model/project/steps/charactersteps.h"

#include <memory>

namespace quadrille {

/// What the evaluations of a character's model of appearance share.
struct AppearanceInputs
{
    CharacterInputs work;
    AppearanceWork appearance;

    std::string modelStep() const { return appearanceModelStep(appearance.entry.name); }
};

/// The textures that a model is learned from, to be measured.
struct MeasuredAppearance
{
    AppearanceTraining training;
    AppearanceSubject subject;
    std::vector<AppearanceFrame> frames; ///< the first that shows each texture
};

/// The begin of a step for a table about the model: its names, and the model as its input.
BuildStep appearanceStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);

/// Opens what the model was learned from. \param least  how many textures are needed.
/// \throws Error what opening it throws; ProjectInvalid where there are fewer textures.
std::shared_ptr<const MeasuredAppearance> measuredAppearance(const AppearanceInputs& inputs,
                                                             std::int64_t least, const Progress& progress);

/// The alignment that the model was made with, by the flows that it left; those that are gone are computed
/// again. Null where the model has no share of warps: nothing is aligned then.
/// \param model  its result. \throws Error what reading textures throws, Cancelled, WriteFailed (scratch).
std::shared_ptr<TextureAlignment> alignmentOf(const AppearanceInputs& inputs,
                                              const MeasuredAppearance& measured, const Result& model,
                                              const Progress& progress);

// Steps for the tables of a model of appearance.
/// fig17 and fig18.
BuildStep compactnessStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);
/// fig19 and fig20.
BuildStep generalisationStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);
BuildStep fig22Step(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);
BuildStep appearanceInterpolationStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);
BuildStep appearanceShapeStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);
BuildStep appearanceRatesStep(const AppearanceInputs& inputs, const EvaluationEntry& evaluation);

} // namespace quadrille
