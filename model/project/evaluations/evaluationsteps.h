// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/charactersteps.h"

namespace quadrille {

/// The papers' tables that the section “evaluations” names.
std::vector<BuildStep> makeEvaluationSteps(const StepMaking& making);

/// The begin of a step for a table of a character: its names.
BuildStep evaluationStep(const CharacterInputs& work, const EvaluationEntry& evaluation);

// One step for each of evaluationTables.
BuildStep fig4Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep fig7Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep fig9Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep fig11Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep fig12Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep junctionsStep(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep densityStep(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep walksStep(const CharacterInputs& work, const EvaluationEntry& evaluation);
/// \pre A sequence has reference joint angles.
BuildStep table1Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep table2Step(const CharacterInputs& work, const EvaluationEntry& evaluation);

/// \pre The character has variations.
BuildStep cvsFig4Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep cvsFig7Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep variationsStep(const CharacterInputs& work, const EvaluationEntry& evaluation);

/// \pre The character performs a transfer that names a truth.
BuildStep transferErrorStep(const CharacterInputs& work, const EvaluationEntry& evaluation);

/// \pre The character has as many motion spaces as neededMotionSpaces tells.
BuildStep ia4dTable1Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep ia4dFig4Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep ia4dTable2Step(const CharacterInputs& work, const EvaluationEntry& evaluation);
BuildStep ia4dTable3Step(const CharacterInputs& work, const EvaluationEntry& evaluation);

/// The sequences of a character that have reference joint angles, as positions in its list.
std::vector<std::size_t> sequencesWithAngles(const CharacterInputs& work);

} // namespace quadrille
