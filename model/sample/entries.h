// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/sample/sample.h"

#include <string>
#include <vector>

namespace quadrille {

// Entries of the sample project, about its character.

/// The papers' tables that take seconds.
std::vector<EvaluationEntry> sampleEvaluations(const std::string& character);
std::vector<ExportEntry> sampleExports();
/// One animation for each kind of constraint.
std::vector<AnimationEntry> sampleAnimations(const std::string& character);
/// The five parts that are proposed for its body.
BodyPartsEntry sampleBodyParts(const SampleBody& body);
/// Variations of walking and jogging, straight on and in turns, as in CVS Fig. 9, and of four jumps as in
/// Fig. 8.
std::vector<VariationEntry> sampleVariations(const SampleCharacter& character);
/// Walking by its speed and by how it turns, and jumps by their height.
std::vector<MotionSpaceEntry> sampleMotionSpaces(const SampleCharacter& character);
/// The mesh of a character as a sequence of one frame.
SequenceEntry sampleBodyAtRest(const CharacterEntry& character);
/// A walk that the body at rest performs, by proposed pairs.
TransferEntry sampleTransfer(const std::string& bodyAtRest);

} // namespace quadrille
