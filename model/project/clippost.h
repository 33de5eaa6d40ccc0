// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/characterstages.h"
#include "model/synthesis/postprocessing.h"

namespace quadrille {

/// What the post-processing of an animation needs to know of its character: when feet stand, as its sequences
/// say, and its symmetry, from the file that is named or the character's mesh.
PostProcessingInputs postProcessingInputs(const AnimationEntry& animation, const CharacterWork& work,
                                          const CharacterFrames& frames);

/// The file of the symmetry; none where it is not named or not needed.
std::vector<std::filesystem::path> symmetryFiles(const AnimationEntry& animation, const CharacterWork& work);

} // namespace quadrille
