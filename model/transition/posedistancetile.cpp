// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/posedistancetile.h"

#include "model/geometry/procrustes.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Some frames that follow each other, held in memory.
struct FrameRun
{
    std::vector<Frame> frames;
    std::vector<CentredPose> poses;

    std::size_t size() const { return frames.size(); }
};

FrameRun loadRun(const PoseDistanceInputs& inputs, NodeIndex first, NodeIndex count, const Progress& progress)
{
    FrameRun run;
    for (NodeIndex node = first; node < first + count; ++node) {
        run.frames.push_back(inputs.character.frame(node));
        run.poses.push_back({run.frames.back().positions(), inputs.centres[static_cast<std::size_t>(node)]});
        progress.report(std::int64_t{node - first + 1}, std::int64_t{count});
    }
    return run;
}

/// Where the columns of a row begin that lie above the diagonal, from the tile's first column.
std::size_t firstAbove(const PairTile& tile, std::size_t row)
{
    const NodeIndex next = tile.firstRow + static_cast<NodeIndex>(row) + 1;
    return static_cast<std::size_t>(std::clamp(next - tile.firstColumn, NodeIndex{0}, tile.columns));
}

/// The rotations that turn the frames of columns onto those of rows, rows × columns.
std::vector<RotationF> rotationsOf(const FrameRun& rows, const FrameRun& columns, const PairTile& tile,
                                   const Progress& progress)
{
    const Eigen::MatrixXd all = covariances(rows.poses, columns.poses, progress.part(0, 0.7));
    std::vector<RotationF> rotations(rows.size() * columns.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t column = firstAbove(tile, row); column < columns.size(); ++column) {
            const Eigen::Quaterniond q = rotationOfCovariance(
                all.block<3, 3>(static_cast<Eigen::Index>(3 * row), static_cast<Eigen::Index>(3 * column)));
            rotations[row * columns.size() + column] = {static_cast<float>(q.w()), static_cast<float>(q.x()),
                                                        static_cast<float>(q.y()), static_cast<float>(q.z())};
        }
        progress.part(0.7, 1).report(static_cast<std::int64_t>(row + 1),
                                     static_cast<std::int64_t>(rows.size()));
    }
    return rotations;
}

/// Adds what all slices of the frames give to the sums of the pairs above the diagonal.
/// \param fill  (const CentredPose&, slice number, Slice& out)
/// \param add  (const Slice& row, const Slice* columns, const RotationF*, count, double* sums)
template <typename Slice, typename Fill, typename Add>
std::vector<double> sumSlices(const FrameRun& rows, const FrameRun& columns, const PairTile& tile,
                              const std::vector<RotationF>& rotations, std::size_t sliceCount,
                              const Progress& progress, const Fill& fill, const Add& add)
{
    // Slices of so many columns stay in a core's own cache while all rows go by.
    constexpr std::size_t columnsAtOnce = 128;
    std::vector<double> sums(rows.size() * columns.size(), 0.0);
    std::vector<Slice> columnSlices(columns.size());
    std::vector<Slice> rowSlices(rows.size());
    for (std::size_t slice = 0; slice < sliceCount; ++slice) {
        for (std::size_t column = 0; column < columns.size(); ++column)
            fill(columns.poses[column], slice, columnSlices[column]);
        for (std::size_t row = 0; row < rows.size() && firstAbove(tile, row) < columns.size(); ++row)
            fill(rows.poses[row], slice, rowSlices[row]);
        for (std::size_t begin = 0; begin < columns.size(); begin += columnsAtOnce) {
            const std::size_t end = std::min(begin + columnsAtOnce, columns.size());
            for (std::size_t row = 0; row < rows.size(); ++row) {
                const std::size_t first = std::max(begin, firstAbove(tile, row));
                if (first >= end)
                    break; // and so are the rows below
                const std::size_t place = row * columns.size() + first;
                add(rowSlices[row], columnSlices.data() + first, rotations.data() + place, end - first,
                    sums.data() + place);
            }
        }
        progress.report(static_cast<std::int64_t>(slice + 1), static_cast<std::int64_t>(sliceCount));
    }
    return sums;
}

} // namespace

void fillVertexSlice(const CentredPose& pose, std::size_t slice, VertexSlice& out)
{
    const std::size_t first = slice * sliceVertices;
    const std::size_t count = std::min(sliceVertices, pose.positions.size() - first);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& row = out.coordinates[axis];
        for (std::size_t v = 0; v < count; ++v)
            row[v] = static_cast<float>(double{pose.positions[first + v][static_cast<Eigen::Index>(axis)]} -
                                        pose.centre[static_cast<Eigen::Index>(axis)]);
        std::fill(row.begin() + static_cast<std::ptrdiff_t>(count), row.end(), 0.0F);
    }
}

std::vector<float> poseDistanceTile(const PoseDistanceInputs& inputs, const PairTile& tile,
                                    const Progress& progress)
{
    const FrameRun rows = loadRun(inputs, tile.firstRow, tile.rows, progress.part(0, 0.03));
    const FrameRun columns = loadRun(inputs, tile.firstColumn, tile.columns, progress.part(0.03, 0.06));
    const std::vector<RotationF> rotations = rotationsOf(rows, columns, tile, progress.part(0.06, 0.16));
    const Progress rest = progress.part(0.16, 1);
    const std::size_t vertexCount = inputs.character.vertexCount();
    std::vector<double> sums;
    double count = 0;
    if (inputs.settings.metric == PoseMetric::Surface) {
        count = static_cast<double>(inputs.triangleCount);
        const auto weight = static_cast<float>(inputs.settings.stretchWeight);
        sums = sumSlices<TriangleSlice>(
            rows, columns, tile, rotations, inputs.corners.size(), rest,
            [&](const CentredPose& pose, std::size_t slice, TriangleSlice& out) {
                fillTriangleSlice(pose.positions, inputs.corners[slice], out);
            },
            [&](const TriangleSlice& row, const TriangleSlice* others, const RotationF* turns, std::size_t n,
                double* out) { addSurfaceDistances(row, others, turns, n, weight, out); });
    } else {
        count = static_cast<double>(vertexCount);
        sums = sumSlices<VertexSlice>(rows, columns, tile, rotations,
                                      (vertexCount + sliceVertices - 1) / sliceVertices, rest,
                                      fillVertexSlice, addEuclideanDistances);
    }
    std::vector<float> distances(sums.size());
    std::transform(sums.begin(), sums.end(), distances.begin(),
                   [count](double sum) { return static_cast<float>(sum / count); });
    return distances;
}

} // namespace quadrille
