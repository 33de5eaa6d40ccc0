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
/// \param said  out: what covariances say, rows × columns; may be empty.
std::vector<RotationF> rotationsOf(const PoseDistanceInputs& inputs, const FrameRun& rows,
                                   const FrameRun& columns, const PairTile& tile, std::span<float> said,
                                   const Progress& progress)
{
    // Covariances of all rows would take more room than the frames.
    constexpr std::size_t rowsAtOnce = 128;
    std::vector<RotationF> rotations(rows.size() * columns.size());
    for (std::size_t first = 0; first < rows.size(); first += rowsAtOnce) {
        const std::size_t count = std::min(rowsAtOnce, rows.size() - first);
        const Progress own =
            progress.part(static_cast<double>(first) / static_cast<double>(rows.size()),
                          static_cast<double>(first + count) / static_cast<double>(rows.size()));
        const Eigen::MatrixXd all =
            covariances(std::span(rows.poses).subspan(first, count), columns.poses, own.part(0, 0.7));
        for (std::size_t r = 0; r < count; ++r) {
            const std::size_t row = first + r;
            for (std::size_t column = firstAbove(tile, row); column < columns.size(); ++column) {
                const Eigen::Matrix3d covariance =
                    all.block<3, 3>(static_cast<Eigen::Index>(3 * r), static_cast<Eigen::Index>(3 * column));
                const std::size_t place = row * columns.size() + column;
                if (!said.empty())
                    said[place] = static_cast<float>(inputs.ofCovariance(covariance));
                if (inputs.metrics.empty())
                    continue;
                const Eigen::Quaterniond q = rotationOfCovariance(covariance);
                rotations[place] = {static_cast<float>(q.w()), static_cast<float>(q.x()),
                                    static_cast<float>(q.y()), static_cast<float>(q.z())};
            }
            own.part(0.7, 1).report(static_cast<std::int64_t>(r + 1), static_cast<std::int64_t>(count));
        }
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
    constexpr std::size_t columnsAtOnce = 64;
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

/// \param distances  out: of the pairs of a tile, by one metric.
void setDistances(const MetricInputs& metric, const FrameRun& rows, const FrameRun& columns,
                  const PairTile& tile, const std::vector<RotationF>& rotations, const Progress& progress,
                  std::span<float> distances)
{
    std::vector<double> sums;
    std::size_t count = 0;
    if (metric.settings.metric == PoseMetric::Surface) {
        count = static_cast<std::size_t>(metric.triangleCount);
        const auto weight = static_cast<float>(metric.settings.stretchWeight);
        sums = sumSlices<TriangleSlice>(
            rows, columns, tile, rotations, metric.corners.size(), progress,
            [&](const CentredPose& pose, std::size_t slice, TriangleSlice& out) {
                fillTriangleSlice(pose.positions, metric.corners[slice], out);
            },
            [&](const TriangleSlice& row, const TriangleSlice* others, const RotationF* turns, std::size_t n,
                double* out) { addSurfaceDistances(row, others, turns, n, weight, out); });
    } else {
        count = metric.vertices.size();
        sums = sumSlices<VertexSlice>(
            rows, columns, tile, rotations, vertexSliceCount(metric.vertices), progress,
            [&](const CentredPose& pose, std::size_t slice, VertexSlice& out) {
                fillVertexSlice(pose, ofVertexSlice(metric.vertices, slice), out);
            },
            addEuclideanDistances);
    }
    std::transform(sums.begin(), sums.end(), distances.begin(),
                   [count](double sum) { return static_cast<float>(sum / static_cast<double>(count)); });
}

} // namespace

void fillVertexSlice(const CentredPose& pose, std::span<const std::size_t> vertices, VertexSlice& out)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& row = out.coordinates[axis];
        const double centre = pose.centre[static_cast<Eigen::Index>(axis)];
        for (std::size_t v = 0; v < vertices.size(); ++v)
            row[v] = static_cast<float>(double{pose.positions[vertices[v]][static_cast<Eigen::Index>(axis)]} -
                                        centre);
        std::fill(row.begin() + std::ssize(vertices), row.end(), 0.0F);
    }
}

std::size_t vertexSliceCount(std::span<const std::size_t> vertices)
{
    return (vertices.size() + sliceVertices - 1) / sliceVertices;
}

std::span<const std::size_t> ofVertexSlice(std::span<const std::size_t> vertices, std::size_t slice)
{
    const std::size_t first = slice * sliceVertices;
    return vertices.subspan(first, std::min(sliceVertices, vertices.size() - first));
}

std::vector<float> poseDistanceTile(const PoseDistanceInputs& inputs, const PairTile& tile,
                                    const Progress& progress)
{
    const FrameRun rows = loadRun(inputs, tile.firstRow, tile.rows, progress.part(0, 0.03));
    const FrameRun columns = loadRun(inputs, tile.firstColumn, tile.columns, progress.part(0.03, 0.06));
    const std::size_t pairs = rows.size() * columns.size();
    const std::size_t metrics = inputs.metrics.size();
    std::vector<float> values(inputs.tables() * pairs);
    const std::vector<RotationF> rotations =
        rotationsOf(inputs, rows, columns, tile, std::span(values).subspan(metrics * pairs),
                    progress.part(0.06, metrics > 0 ? 0.16 : 1));
    for (std::size_t m = 0; m < metrics; ++m) {
        const double share = 0.84 / static_cast<double>(metrics);
        const double begin = 0.16 + share * static_cast<double>(m);
        setDistances(inputs.metrics[m], rows, columns, tile, rotations, progress.part(begin, begin + share),
                     std::span(values).subspan(m * pairs, pairs));
    }
    return values;
}

} // namespace quadrille
