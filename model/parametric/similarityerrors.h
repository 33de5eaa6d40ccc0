// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/units.h"

#include <functional>
#include <vector>

namespace quadrille {

/// A pose, and how its vertices move in a frame.
struct MovingPose
{
    std::vector<Vec3f> pose;
    std::vector<Vec3f> velocity; ///< as many
};

/// The non-linear blend of two takes in one frame. \param share  of the second take, 0 … 1.
using MovingPoseAt = std::function<MovingPose(double share)>;

struct SimilarityErrorSettings
{
    int mostBisections = 2;
    int samples = 21;          ///< places in either space, at least 2: evenly from one take to the other
    double velocityWeight = 1; ///< as in SimilaritySettings
};

/// How far the bilinear dissimilarity is from the true one.
struct SimilarityError
{
    int bisections = 0;  ///< each divides all intervals between nodes
    double mean = 0;     ///< of all samples, percent of the range of the true one
    double greatest = 0; ///< of all samples, percent
};

/// Errors of distances that are interpolated between nodes, of two spaces of two takes each in one pair of
/// frames, for no bisection and more (IA4D Table 3). All are 0 where the true distance is the same
/// everywhere. \pre All poses have as many vertices. \throws Error Cancelled. Cost: samples² · vertices;
/// samples and nodes are blended once.
std::vector<SimilarityError> similarityErrors(const MovingPoseAt& source, const MovingPoseAt& target,
                                              const SimilarityErrorSettings& settings = {},
                                              const Progress& progress = {});

} // namespace quadrille
