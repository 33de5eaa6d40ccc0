// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/characterstages.h"

namespace quadrille {

/// The begin of a stage for a table of a character: its names.
ResultStage evaluationStage(const CharacterWork& work, const EvaluationEntry& evaluation);

// One stage for each of evaluationTables.
ResultStage fig4Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage fig7Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage fig9Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage fig11Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage fig12Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage junctionsStage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage densityStage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage walksStage(const CharacterWork& work, const EvaluationEntry& evaluation);
/// \pre A sequence has reference joint angles.
ResultStage table1Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage table2Stage(const CharacterWork& work, const EvaluationEntry& evaluation);

/// \pre The character has variations.
ResultStage cvsFig4Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage cvsFig7Stage(const CharacterWork& work, const EvaluationEntry& evaluation);
ResultStage variationsStage(const CharacterWork& work, const EvaluationEntry& evaluation);

/// The sequences of a character that have reference joint angles, as positions in its list.
std::vector<std::size_t> sequencesWithAngles(const CharacterWork& work);

} // namespace quadrille
