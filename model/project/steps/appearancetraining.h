// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/alignment.h"
#include "model/project/media/opensequence.h"
#include "model/project/store/appearanceresult.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// The textures that a model of appearance is learned from.
struct AppearanceTraining
{
    std::shared_ptr<const Topology> topology;
    std::vector<Texture> textures;         ///< each once
    std::vector<AppearanceRow> rows;       ///< of all frames that show them
    std::optional<std::int64_t> reference; ///< that the entry names

    /// Reads them; each must have the size of the first. \throws Error what reading throws; ProjectInvalid
    /// where the size is another, naming the file.
    TextureSource source() const;
    /// The first frame that shows each texture.
    std::vector<AppearanceFrame> frames() const;
};

/// The sequences whose textures an entry learns from: those that it names, or all of its character that do
/// not show made clips.
std::vector<std::string> trainingSequences(const Project& project, const AppearanceEntry& entry);

/// Opens them. Frames whose textures are to be completed are left out (SMCAS §5.3), and sequences without a
/// texture per frame where the entry names none.
/// \throws Error what opening throws; ProjectInvalid where no frame is left, a sequence that is named has no
/// texture per frame, or the reference is not among them; NoUvs.
AppearanceTraining appearanceTraining(SequenceOpener& opener, const AppearanceEntry& entry,
                                      const Progress& progress = {});

} // namespace quadrille
