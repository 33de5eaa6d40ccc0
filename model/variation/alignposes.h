// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/variation/training.h"

namespace quadrille {

/// Fills the poses and placements of a take whose warp is known: captured frames are laid onto the template
/// by Procrustes; between two of them poses are interpolated linearly, placements by slerp.
/// \param templatePose  centred at the origin. \throws Error what reading frames throws, Cancelled. Parallel
/// over the frames.
void alignPoses(const MeshSequence& sequence, Positions templatePose, AlignedTake& take,
                const Progress& progress = {});

} // namespace quadrille
