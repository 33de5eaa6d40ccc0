// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/variation/training.h"

namespace quadrille {

/// Some vertices of a pose; all where none are named.
std::vector<Vec3f> anchorOf(Positions pose, std::span<const VertexIndex> anchor);

/// Fills the poses and placements of a take whose warp is known: captured frames are laid onto the template
/// by Procrustes; between two of them poses are interpolated linearly, placements by slerp.
/// \param templatePose  whose anchor is centred at the origin. \param anchor  vertices that decide; all when
/// empty. \throws Error what reading frames throws, Cancelled. Parallel over the frames.
void alignPoses(const MeshSequence& sequence, Positions templatePose, std::span<const VertexIndex> anchor,
                AlignedTake& take, const Progress& progress = {});

} // namespace quadrille
