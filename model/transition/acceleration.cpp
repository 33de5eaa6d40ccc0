// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/acceleration.h"

#include "model/core/error.h"
#include "model/geometry/covariances.h"
#include "model/geometry/procrustes.h"
#include "model/transition/pairtiles.h"
#include "model/transition/posedistancekernels.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Poses and accelerations of frames that follow each other.
struct LoadedRun
{
    std::vector<Frame> frames;
    std::vector<CentredPose> poses;
    std::vector<std::vector<Vec3f>> accelerations;

    LoadedRun(const CharacterFrames& character, NodeIndex first, NodeIndex count, double fps,
              const Progress& progress)
    {
        for (NodeIndex node = first; node < first + count; ++node) {
            progress.report(std::int64_t{node - first}, std::int64_t{count});
            frames.push_back(character.frame(node));
            const Positions positions = frames.back().positions();
            poses.push_back({.positions = positions, .centre = centroid(positions)});
            accelerations.push_back(vertexAccelerations(character, node, fps));
        }
    }
};

/// Frames along a tile: two runs of them fit 24 MB.
NodeIndex tileSize(std::uint32_t vertexCount)
{
    constexpr std::size_t runBytes = std::size_t{12} << 20;
    return static_cast<NodeIndex>(std::clamp(runBytes / (2 * sizeof(Vec3f) * std::max(vertexCount, 1U)),
                                             std::size_t{4}, std::size_t{48}));
}

void fillSlice(const std::vector<Vec3f>& accelerations, std::size_t slice, VertexSlice& out)
{
    const std::size_t first = slice * sliceVertices;
    const std::size_t count = std::min(sliceVertices, accelerations.size() - first);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& row = out.coordinates[axis];
        for (std::size_t v = 0; v < count; ++v)
            row[v] = accelerations[first + v][static_cast<Eigen::Index>(axis)];
        std::fill(row.begin() + static_cast<std::ptrdiff_t>(count), row.end(), 0.0F);
    }
}

/// The rotations that turn the frames of columns onto those of rows, rows × columns.
std::vector<RotationF> rotationsOf(const LoadedRun& rows, const LoadedRun& columns, const Progress& progress)
{
    const Eigen::MatrixXd all = covariances(rows.poses, columns.poses, progress);
    std::vector<RotationF> rotations;
    for (std::size_t r = 0; r < rows.poses.size(); ++r) {
        for (std::size_t c = 0; c < columns.poses.size(); ++c) {
            const Eigen::Quaterniond q = rotationOfCovariance(
                all.block<3, 3>(static_cast<Eigen::Index>(3 * r), static_cast<Eigen::Index>(3 * c)));
            rotations.push_back({static_cast<float>(q.w()), static_cast<float>(q.x()),
                                 static_cast<float>(q.y()), static_cast<float>(q.z())});
        }
    }
    return rotations;
}

/// rows × columns.
std::vector<float> differencesOf(const CharacterFrames& character, const PairTile& tile, double fps,
                                 const Progress& progress)
{
    const LoadedRun rows(character, tile.firstRow, tile.rows, fps, progress.part(0, 0.1));
    const LoadedRun columns(character, tile.firstColumn, tile.columns, fps, progress.part(0.1, 0.2));
    const std::vector<RotationF> rotations = rotationsOf(rows, columns, progress.part(0.2, 0.4));
    const std::size_t width = columns.poses.size();
    std::vector<double> sums(rotations.size(), 0.0);
    std::vector<VertexSlice> columnSlices(width);
    VertexSlice rowSlice;
    const std::size_t vertexCount = character.vertexCount();
    const std::size_t sliceCount = (vertexCount + sliceVertices - 1) / sliceVertices;
    for (std::size_t slice = 0; slice < sliceCount; ++slice) {
        progress.part(0.4, 1).report(static_cast<std::int64_t>(slice), static_cast<std::int64_t>(sliceCount));
        for (std::size_t c = 0; c < width; ++c)
            fillSlice(columns.accelerations[c], slice, columnSlices[c]);
        for (std::size_t r = 0; r < rows.poses.size(); ++r) {
            fillSlice(rows.accelerations[r], slice, rowSlice);
            addEuclideanDistances(rowSlice, columnSlices.data(), rotations.data() + r * width, width,
                                  sums.data() + r * width);
        }
    }
    std::vector<float> means(sums.size());
    std::transform(sums.begin(), sums.end(), means.begin(), [vertexCount](double sum) {
        return static_cast<float>(sum / static_cast<double>(vertexCount));
    });
    return means;
}

} // namespace

std::vector<Vec3f> vertexAccelerations(const CharacterFrames& character, NodeIndex node, double fps)
{
    std::vector<Vec3f> accelerations(character.vertexCount(), Vec3f::Zero());
    const FrameLayout& layout = character.layout();
    const int sequence = layout.sequenceOf(node);
    if (layout.countOf(sequence) < 3)
        return accelerations;
    const NodeIndex middle = std::clamp(node, layout.firstOf(sequence) + 1, layout.lastOf(sequence) - 1);
    const Frame before = character.frame(middle - 1);
    const Frame here = character.frame(middle);
    const Frame after = character.frame(middle + 1);
    const auto perSquaredSecond = static_cast<float>(fps * fps);
    for (std::size_t v = 0; v < accelerations.size(); ++v)
        accelerations[v] =
            ((before.positions()[v] - here.positions()[v]) + (after.positions()[v] - here.positions()[v])) *
            perSquaredSecond;
    return accelerations;
}

Table<float> accelerationDifferences(const CharacterFrames& character, double fps, const Progress& progress,
                                     const Executor& executor)
{
    if (!(fps > 0) || !std::isfinite(fps))
        throw Error(ErrorCode::BadArgument,
                    {.values = {{"reason", "The frame rate of accelerations is not positive"},
                                {"remedy", "Give the frame rate of the sequences."}}});
    const NodeIndex frameCount = character.frameCount();
    Table<float> differences = Table<float>::Zero(frameCount, frameCount);
    const std::vector<PairTile> tiles = pairTiles(frameCount, tileSize(character.vertexCount()));
    const auto tileOf = [&tiles](std::int64_t task) -> const PairTile& {
        return tiles[static_cast<std::size_t>(task)];
    };
    executor.run(makeTasks<float>(
                     static_cast<std::int64_t>(tiles.size()),
                     [&](std::int64_t task, const Progress& own) {
                         return differencesOf(character, tileOf(task), fps, own);
                     },
                     [&](std::int64_t task, std::span<const float> values) {
                         storeSymmetric(tileOf(task), values, differences);
                     }),
                 progress);
    return differences;
}

double accelerationCost(TableView<float> differences, const Transition& transition)
{
    assert(!transition.path.empty());
    double sum = 0;
    for (const FramePair cell : transition.path)
        sum += static_cast<double>(differences(cell.source, cell.destination));
    return sum / transition.length();
}

} // namespace quadrille
