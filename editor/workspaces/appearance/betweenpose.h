// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"

namespace quadrille {

/// The pose between two frames, in place of every frame of a sequence; made when one is read first. Reading
/// throws what reading both frames throws.
/// \param first,second  the sequences of the frames `from` and `to`. \param weight  from the first to the
/// second, 0 … 1.
/// \return the sequence's own frames where one of both is null or of another mesh.
std::shared_ptr<const FrameSource> betweenPose(const MeshSequence& sequence, const MeshSequence* first,
                                               FrameIndex from, const MeshSequence* second, FrameIndex to,
                                               double weight);

} // namespace quadrille
