// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <string>

namespace quadrille {

/// The character of a sequence: the one it names, or the only one; null when the project has none.
const CharacterEntry* characterOf(const Project& project, const SequenceEntry& entry);
const SequenceEntry* findSequence(const Project& project, const std::string& name);
const AnimationEntry* findAnimation(const Project& project, const std::string& name);
const VariationEntry* findVariation(const Project& project, const std::string& name);
const MotionSpaceEntry* findMotionSpace(const Project& project, const std::string& name);
const LiveEntry* findLive(const Project& project, const std::string& name);
const AppearanceEntry* findAppearance(const Project& project, const std::string& name);
const TransferEntry* findTransfer(const Project& project, const std::string& name);
const ProjectionEntry* findProjection(const Project& project, const std::string& name);
/// The model that clips of a character take their textures from: the first one of its own; null without one.
const AppearanceEntry* appearanceOf(const Project& project, const std::string& character);
/// The character of an animation, a variation, a motion space or an appearance: the one it names, or the only
/// one; empty when the project has none.
std::string characterNameOf(const Project& project, const AnimationEntry& animation);
std::string characterNameOf(const Project& project, const VariationEntry& variation);
std::string characterNameOf(const Project& project, const MotionSpaceEntry& space);
/// That of its first space.
std::string characterNameOf(const Project& project, const LiveEntry& live);
std::string characterNameOf(const Project& project, const AppearanceEntry& appearance);
/// How many motion spaces of at least two takes a character has.
std::size_t steeredSpaces(const Project& project, const std::string& character);
/// The parts of a character's body; null where the project has none.
const BodyPartsEntry* bodyPartsOf(const Project& project, const std::string& character);

} // namespace quadrille
