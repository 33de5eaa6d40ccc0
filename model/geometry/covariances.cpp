// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/covariances.h"

#include "model/geometry/geometrykernels.h"

#include <algorithm>
#include <vector>

namespace quadrille {

namespace {

/// Centred coordinates of the vertices [first, first + count) of all poses, in panels of `width` coordinates;
/// zeros where there is no vertex or pose.
void pack(std::span<const CentredPose> poses, std::size_t first, std::size_t count, std::size_t width,
          std::vector<float>& panels)
{
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t coordinate = 3 * pose + axis;
            float* out = panels.data() + coordinate / width * productDepth * width + coordinate % width;
            const float* in = poses[pose].positions[first].data() + axis;
            const double centre = poses[pose].centre[static_cast<Eigen::Index>(axis)];
            for (std::size_t k = 0; k < count; ++k)
                out[k * width] = static_cast<float>(double{in[3 * k]} - centre);
            for (std::size_t k = count; k < productDepth; ++k)
                out[k * width] = 0;
        }
    }
}

std::size_t tilesOf(std::size_t poses, std::size_t width)
{
    return (3 * poses + width - 1) / width;
}

} // namespace

Eigen::MatrixXd covariances(std::span<const CentredPose> targets, std::span<const CentredPose> sources,
                            const Progress& progress)
{
    using Sums = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const std::size_t rowTiles = tilesOf(targets.size(), productRows);
    const std::size_t columnTiles = tilesOf(sources.size(), productColumns);
    Sums sums = Sums::Zero(static_cast<Eigen::Index>(rowTiles * productRows),
                           static_cast<Eigen::Index>(columnTiles * productColumns));
    std::vector<float> left(rowTiles * productRows * productDepth);
    std::vector<float> right(columnTiles * productColumns * productDepth);
    const std::size_t vertexCount = targets.empty() ? 0 : targets.front().positions.size();
    for (std::size_t first = 0; first < vertexCount; first += productDepth) {
        const std::size_t count = std::min(productDepth, vertexCount - first);
        pack(targets, first, count, productRows, left);
        pack(sources, first, count, productColumns, right);
        addProducts(left.data(), right.data(), rowTiles, columnTiles, sums.data());
        progress.report(static_cast<std::int64_t>(first + count), static_cast<std::int64_t>(vertexCount));
    }
    return sums.topLeftCorner(static_cast<Eigen::Index>(3 * targets.size()),
                              static_cast<Eigen::Index>(3 * sources.size()));
}

} // namespace quadrille
