// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/rootposes.h"

#include "model/geometry/covariances.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

} // namespace

OfCovariance turnOf(UpAxis up)
{
    return [ground = Ground(up)](const Eigen::Matrix3d& covariance) { return angleOf(covariance, ground); };
}

RootPoses rootPoses(std::vector<Vec3d> centres, Table<float> turns, UpAxis up)
{
    turns.matrix().triangularView<Eigen::StrictlyLower>() *= -1.0F;
    return {.up = up, .centres = std::move(centres), .turns = SharedTable<float>(std::move(turns))};
}

RootPoses rootPoses(const CharacterFrames& character, UpAxis up, const Progress& progress,
                    const Executor& executor)
{
    PosePairs pairs = posePairs(character, {}, turnOf(up), progress, executor);
    return rootPoses(std::move(pairs.centres), std::move(pairs.ofCovariances), up);
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
