// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <vector>

namespace quadrille {

/// Where a sequence goes and how low it gets, from some of its frames; in the unit of its positions.
struct SequenceBounds
{
    std::vector<Vec3f> centroids; ///< in order, from first to last frame
    Vec3f lower = Vec3f::Zero();  ///< corners of the box that holds every vertex
    Vec3f upper = Vec3f::Zero();
    float lowest = 0; ///< smallest height of any vertex
};

/// Reads at most `maximalFrames` frames, evenly spread, past the media cache. From any thread; blocks while
/// files are read.
/// \throws Error as MeshSequence::frame, Cancelled.
SequenceBounds surveySequence(const MeshSequence& sequence, UpAxis up, int maximalFrames,
                              const Progress& progress);

} // namespace quadrille
