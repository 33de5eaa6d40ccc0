// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/stagedfiles.h"
#include "model/sequence/meshsequence.h"

#include <string>
#include <vector>

namespace quadrille {

/// Where the pictures of an exported sequence lie, as paths from its folder; both empty without textures.
struct CopiedTextures
{
    std::vector<std::string> ofMaterials; ///< one for each material, or one; empty strings for none
    std::vector<std::string> ofFrames;    ///< one for each frame, where textures change

    /// The picture of a material in a frame; empty when there is none.
    const std::string& of(std::int64_t frame, std::size_t material = 0) const;
};

/// Copies the pictures that a sequence uses beside a file that is written: STEM_texture.png,
/// STEM_texture2.png, …, or textures/STEM/0000.png, … where each frame has its own, so that an import finds
/// them again.
/// \param stem of the exported files. \throws Error what reading a picture throws, WriteFailed, Cancelled.
CopiedTextures copyTextures(const MeshSequence& sequence, const std::string& stem, StagedFiles& files,
                            const Progress& progress);

} // namespace quadrille
