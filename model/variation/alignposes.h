// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/variation/training.h"

namespace quadrille {

/// Fills the poses and placements of a take whose warp and template are known: captured frames are laid onto
/// the template; between two of them poses are interpolated linearly, placements by slerp.
/// \throws Error what reading frames throws, Cancelled. Parallel over the frames.
void alignPoses(const MeshSequence& sequence, AlignedTake& take, const Progress& progress = {});

} // namespace quadrille
