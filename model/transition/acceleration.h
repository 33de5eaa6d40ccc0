// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"
#include "model/core/table.h"
#include "model/transition/characterframes.h"
#include "model/transition/warppath.h"

#include <vector>

namespace quadrille {

/// Acceleration of every vertex in a frame, m/s²: the second difference of its positions · fps², at the ends
/// of a sequence that of the neighbouring frame. Zero in sequences of fewer than three frames. \throws Error
/// as MeshSequence::frame.
std::vector<Vec3f> vertexAccelerations(const CharacterFrames& character, NodeIndex node, double fps);

/// How differently the frames of each pair accelerate: mean over the vertices of ‖a_i − a_j‖, a_j turned by
/// the rotation of the Procrustes alignment of pose j onto pose i (SMCAS §3.3).
/// \return frames × frames, m/s²; symmetric, zeros on the diagonal.
/// \throws Error BadArgument (fps not positive and finite), what reading frames throws, Cancelled.
/// Cost: O(frames² · vertices); beside the table, at most about 24 MB for each core.
Table<float> accelerationDifferences(const CharacterFrames& character, double fps,
                                     const Progress& progress = {},
                                     const Executor& executor = localExecutor());

/// The acceleration cost of a transition: mean over the cells of its warp path, m/s² (SMCAS Fig. 7d–f).
/// \param differences  of accelerationDifferences. \pre The path is not empty.
double accelerationCost(TableView<float> differences, const Transition& transition);

} // namespace quadrille
