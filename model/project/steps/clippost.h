// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/charactersteps.h"
#include "model/synthesis/clips/stances.h"
#include "model/synthesis/finishing/postprocessing.h"

namespace quadrille {

/// What the post-processing of an animation needs to know of its character: when feet stand, and its
/// symmetry, from the file that is named or the character's mesh. \param stances  of the graph's frames.
PostProcessingInputs postProcessingInputs(const AnimationEntry& animation, const CharacterInputs& work,
                                          const CharacterFrames& frames, const Stances& stances);

/// The symmetry of a character: in its mesh file the body mostly rests, as no captured frame may.
/// \param any  a sequence of it. \throws Error as findSymmetry; what opening the mesh throws.
Symmetry symmetryOf(SequenceOpener& opener, const std::string& character, const MeshSequence& any,
                    const Progress& progress = {});

/// The file of the symmetry; none where it is not named or not needed.
std::vector<std::filesystem::path> symmetryFiles(const AnimationEntry& animation,
                                                 const CharacterInputs& work);

} // namespace quadrille
