// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/covariances.h"
#include "model/geometry/triangleframes.h"
#include "model/transition/pairtiles.h"
#include "model/transition/posedistance.h"
#include "model/transition/posedistancekernels.h"

#include <vector>

namespace quadrille {

/// What one metric compares.
struct MetricInputs
{
    PoseDistanceSettings settings;
    std::vector<CornerSlice> corners;  ///< of the triangles to use
    std::int64_t triangleCount = 0;    ///< in `corners`
    std::vector<std::size_t> vertices; ///< to use; Euclidean metric only
};

/// What all tiles of a table of distances have in common.
struct PoseDistanceInputs
{
    CharacterFrames character;
    std::vector<MetricInputs> metrics;
    OfCovariance ofCovariance;  ///< may be empty
    std::vector<Vec3d> centres; ///< of every frame, the mean of its vertices

    std::size_t tables() const { return metrics.size() + (ofCovariance ? 1 : 0); }
};

/// Distances of the pairs of a tile, rows × columns, of one metric after the other; then what covariances
/// say. Where the frame of the row does not come before that of the column there is 0: the tables are
/// symmetric. \throws Error what reading frames throws, Cancelled.
std::vector<float> poseDistanceTile(const PoseDistanceInputs& inputs, const PairTile& tile,
                                    const Progress& progress);

/// Some vertices of a pose, for the kernels. \pre At most sliceVertices.
void fillVertexSlice(const CentredPose& pose, std::span<const std::size_t> vertices, VertexSlice& out);

/// So many slices hold all that is listed, and those that one of them holds.
std::size_t vertexSliceCount(std::span<const std::size_t> vertices);
std::span<const std::size_t> ofVertexSlice(std::span<const std::size_t> vertices, std::size_t slice);

} // namespace quadrille
