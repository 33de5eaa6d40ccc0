// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/executor.h"
#include "model/core/table.h"
#include "model/transition/characterframes.h"
#include "model/transition/posedistancesettings.h"

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

namespace quadrille {

/// The distances of all pairs of frames of a character.
struct PoseDistances
{
    FrameLayout layout;
    /// frames × frames, radians (surface) or metres (Euclidean); exactly symmetric, zeros on the diagonal.
    Table<float> distances;
    std::int64_t trianglesUsed = 0;
    /// Triangles whose area is below 1e-12 of the squared bounding diagonal in some frame, and those beyond
    /// the number that is to be compared.
    std::int64_t trianglesLeftOut = 0;
};

/// A number of two poses, by the covariance of the one (x) with the other (y), see covariances.
using OfCovariance = std::function<double(const Eigen::Matrix3d&)>;

/// What one pass over all pairs of frames finds out.
struct PosePairs
{
    std::vector<PoseDistances> distances; ///< by metric
    /// frames × frames: of the earlier and the later frame, exactly symmetric, zeros on the diagonal; empty
    /// where nothing of covariances is asked for.
    Table<float> ofCovariances;
    std::vector<Vec3d> centres; ///< of every frame, the mean of its vertices
};

/// Several tables of all pairs of frames at once: poses are aligned once for all of them, which is what costs
/// most but for the surface distance. The tables are those of passes of their own, to the bit.
/// \param ofCovariance  asked from several threads; may be empty.
/// \throws Error, cost: as poseDistances.
PosePairs posePairs(const CharacterFrames& character, std::span<const PoseDistanceSettings> metrics,
                    const OfCovariance& ofCovariance = {}, const Progress& progress = {},
                    const Executor& executor = localExecutor());

/// Distances of all pairs of frames. Memory beside the table and the frames in the media cache does not grow
/// with the number of frames: at most about 80 MB a core.
/// \throws Error BadArgument (weight negative or not finite, no triangles to compare), NoUsableTriangles
/// (surface metric), what reading frames throws, Cancelled. Cost: O(frames² · (triangles + vertices)).
/// Source: SMCAS section 3.1; section 1 of the specification of algorithms.
PoseDistances poseDistances(const CharacterFrames& character, const PoseDistanceSettings& settings = {},
                            const Progress& progress = {}, const Executor& executor = localExecutor());

/// Distances of the first frames to all: the first rows of the table of poseDistances alone. \pre 0 ≤ rows ≤
/// frames. \throws Error as poseDistances.
Table<float> poseDistancesOfFirst(const CharacterFrames& character, NodeIndex rows,
                                  const PoseDistanceSettings& settings = {}, const Progress& progress = {},
                                  const Executor& executor = localExecutor());

/// The surface distance of two poses, radians, in double precision.
/// \param triangles  those to use, each with an area in both poses; 0 when there are none.
double surfaceDistance(Positions a, Positions b, std::span<const Triangle> triangles,
                       double stretchWeight = PoseDistanceSettings().stretchWeight);

/// What each triangle adds to the surface distance of two poses, radians, in double precision: how far it
/// turned beside the rigid motion of the whole, and its weighted stretch. \return one per triangle; NaN for
/// those without an area in one of the poses. The mean of the others is their surfaceDistance. \pre Both
/// poses have as many vertices.
std::vector<double> triangleDistances(Positions a, Positions b, std::span<const Triangle> triangles,
                                      double stretchWeight = PoseDistanceSettings().stretchWeight);

/// The mean distance of the vertices of two poses after rigid Procrustes, metres, in double precision.
/// \pre Both poses have as many vertices, at least one.
double euclideanDistance(Positions a, Positions b);

} // namespace quadrille
