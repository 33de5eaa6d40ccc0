// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/rootposes.h"

#include "model/geometry/covariances.h"
#include "model/transition/pairtiles.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// The angle that makes the trace of the turned covariance greatest, Σ x·yᵀ of targets x and poses y.
double angleOf(const Eigen::Matrix3d& covariance, const Ground& ground)
{
    const Eigen::Index up = ground.upAxis();
    const Eigen::Index first = (up + 1) % 3;
    const Eigen::Index second = (up + 2) % 3;
    return std::atan2(covariance(second, first) - covariance(first, second),
                      covariance(first, first) + covariance(second, second));
}

std::vector<float> turnsOf(const CharacterFrames& character, const std::vector<Vec3d>& centres,
                           const PairTile& tile, const Ground& ground, const Progress& progress)
{
    std::vector<Frame> frames;
    const auto load = [&](NodeIndex first, NodeIndex count) {
        std::vector<CentredPose> poses;
        for (NodeIndex node = first; node < first + count; ++node) {
            frames.push_back(character.frame(node));
            poses.push_back({frames.back().positions(), centres[static_cast<std::size_t>(node)]});
        }
        return poses;
    };
    const std::vector<CentredPose> rows = load(tile.firstRow, tile.rows);
    const std::vector<CentredPose> columns = load(tile.firstColumn, tile.columns);
    const Eigen::MatrixXd all = covariances(rows, columns, progress);
    std::vector<float> turns;
    turns.reserve(rows.size() * columns.size());
    for (Eigen::Index r = 0; r < tile.rows; ++r) {
        for (Eigen::Index c = 0; c < tile.columns; ++c)
            turns.push_back(static_cast<float>(angleOf(all.block<3, 3>(3 * r, 3 * c), ground)));
    }
    return turns;
}

} // namespace

RootPoses rootPoses(const CharacterFrames& character, UpAxis up, const Progress& progress,
                    const Executor& executor)
{
    const NodeIndex frameCount = character.frameCount();
    RootPoses roots{.up = up, .turns = Table<float>::Zero(frameCount, frameCount)};
    roots.centres.reserve(static_cast<std::size_t>(frameCount));
    for (NodeIndex node = 0; node < frameCount; ++node) {
        progress.part(0, 0.1).report(std::int64_t{node}, std::int64_t{frameCount});
        roots.centres.push_back(centroid(character.frame(node).positions()));
    }
    constexpr std::size_t runBytes = std::size_t{12} << 20;
    const auto size =
        static_cast<NodeIndex>(std::clamp(runBytes / (sizeof(Vec3f) * std::max(character.vertexCount(), 1U)),
                                          std::size_t{8}, std::size_t{256}));
    const std::vector<PairTile> tiles = pairTiles(frameCount, size);
    const auto tileOf = [&tiles](std::int64_t task) -> const PairTile& {
        return tiles[static_cast<std::size_t>(task)];
    };
    executor.run(makeTasks<float>(
                     static_cast<std::int64_t>(tiles.size()),
                     [&](std::int64_t task, const Progress& own) {
                         return turnsOf(character, roots.centres, tileOf(task), Ground(up), own);
                     },
                     [&](std::int64_t task, std::span<const float> turns) {
                         storeSymmetric(tileOf(task), turns, roots.turns);
                     }),
                 progress.part(0.1, 1));
    roots.turns.matrix().triangularView<Eigen::StrictlyLower>() *= -1.0F;
    return roots;
}

std::vector<double> pacesOf(const RootPoses& roots, const FrameLayout& layout, double fps)
{
    constexpr double around = 0.5; // seconds, to each side
    const Ground ground(roots.up);
    const auto reach = static_cast<NodeIndex>(std::lround(around * fps));
    std::vector<double> paces;
    paces.reserve(static_cast<std::size_t>(layout.frameCount()));
    for (NodeIndex node = 0; node < layout.frameCount(); ++node) {
        const int sequence = layout.sequenceOf(node);
        const NodeIndex first = std::max(node - reach, layout.firstOf(sequence));
        const NodeIndex last = std::min(node + reach, layout.lastOf(sequence));
        const Vec2d way = ground.of(roots.centres[static_cast<std::size_t>(last)]) -
                          ground.of(roots.centres[static_cast<std::size_t>(first)]);
        paces.push_back(way.norm() * fps / std::max(1, last - first));
    }
    return paces;
}

double groundAlignment(Positions moved, Positions target, const Ground& ground)
{
    const std::vector<CentredPose> targets{{target, centroid(target)}};
    const std::vector<CentredPose> sources{{moved, centroid(moved)}};
    return angleOf(covariances(targets, sources), ground);
}

} // namespace quadrille
