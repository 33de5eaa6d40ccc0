// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/poseappearance.h"
#include "model/project/steps/appearancework.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// The poses of frames whose appearance is known.
struct KnownPoses
{
    std::vector<AppearanceRow> rows; ///< up to 400 of all, evenly spread
    std::vector<std::int64_t> takes; ///< of each row, from 0 on
    std::vector<std::string> names;  ///< of takes
    PosePlaces places;
};

/// \param rows  of a model, one sequence after the other; not empty. \throws Error what opening and reading
/// the sequences throws, Cancelled.
KnownPoses knownPoses(SequenceOpener& opener, const std::vector<AppearanceRow>& rows,
                      const Progress& progress = {});

/// Learns how the textures of a model vary with poses, see PoseAppearance.
BuildStep posesStep(const std::shared_ptr<const AppearanceWork>& work);

} // namespace quadrille
