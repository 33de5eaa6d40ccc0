// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/similarityerrors.h"

#include "model/core/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace quadrille {

namespace {

double distanceOf(const MovingPose& a, const MovingPose& b, double velocityWeight)
{
    const auto distance = [](Positions from, Positions to) {
        double sum = 0;
        for (std::size_t v = 0; v < from.size(); ++v)
            sum += (from[v].cast<double>() - to[v].cast<double>()).squaredNorm();
        return std::sqrt(sum);
    };
    return (distance(a.pose, b.pose) + velocityWeight * distance(a.velocity, b.velocity)) /
           static_cast<double>(a.pose.size());
}

Table<double> distancesOf(std::span<const MovingPose> source, std::span<const MovingPose> target,
                          double velocityWeight, const Progress& progress)
{
    Table<double> distances(static_cast<Eigen::Index>(source.size()),
                            static_cast<Eigen::Index>(target.size()));
    for (Eigen::Index s = 0; s < distances.rows(); ++s) {
        progress.report(s, distances.rows());
        for (Eigen::Index t = 0; t < distances.cols(); ++t)
            distances(s, t) = distanceOf(source[static_cast<std::size_t>(s)],
                                         target[static_cast<std::size_t>(t)], velocityWeight);
    }
    return distances;
}

/// Of a share between evenly spaced nodes: the node before it, and how far it is on the way to the next.
struct BetweenNodes
{
    Eigen::Index before = 0;
    double part = 0;
};

BetweenNodes betweenNodes(double share, Eigen::Index nodes)
{
    const double at = share * static_cast<double>(nodes - 1);
    const auto before = std::min(static_cast<Eigen::Index>(at), nodes - 2);
    return {before, at - static_cast<double>(before)};
}

double interpolated(const Table<double>& nodes, double source, double target)
{
    const BetweenNodes s = betweenNodes(source, nodes.rows());
    const BetweenNodes t = betweenNodes(target, nodes.cols());
    const auto along = [&](Eigen::Index row) {
        return (1 - t.part) * nodes(row, t.before) + t.part * nodes(row, t.before + 1);
    };
    return (1 - s.part) * along(s.before) + s.part * along(s.before + 1);
}

/// Blends evenly from one take to the other.
std::vector<MovingPose> blendsOf(const MovingPoseAt& space, int count, const Progress& progress)
{
    std::vector<MovingPose> blends;
    for (int i = 0; i < count; ++i) {
        progress.report(i, count);
        blends.push_back(space(static_cast<double>(i) / (count - 1)));
    }
    return blends;
}

} // namespace

std::vector<SimilarityError> similarityErrors(const MovingPoseAt& source, const MovingPoseAt& target,
                                              const SimilarityErrorSettings& settings,
                                              const Progress& progress)
{
    assert(settings.samples >= 2 && settings.mostBisections >= 0);
    const Table<double> truth = distancesOf(blendsOf(source, settings.samples, progress.part(0, 0.3)),
                                            blendsOf(target, settings.samples, progress.part(0.3, 0.6)),
                                            settings.velocityWeight, progress.part(0.6, 0.7));
    const int nodes = (1 << settings.mostBisections) + 1;
    const Table<double> finest = distancesOf(blendsOf(source, nodes, progress.part(0.7, 0.8)),
                                             blendsOf(target, nodes, progress.part(0.8, 0.9)),
                                             settings.velocityWeight, progress.part(0.9, 1));
    const double range = truth.maxCoeff() - truth.minCoeff();
    std::vector<SimilarityError> errors;
    for (int bisections = 0; bisections <= settings.mostBisections; ++bisections) {
        SimilarityError error{.bisections = bisections};
        const Eigen::Index step = Eigen::Index{1} << (settings.mostBisections - bisections);
        const auto some = Eigen::seq(0, nodes - 1, step);
        const Table<double> coarse = finest(some, some);
        for (int s = 0; s < settings.samples; ++s) {
            for (int t = 0; t < settings.samples; ++t) {
                const double there = interpolated(coarse, static_cast<double>(s) / (settings.samples - 1),
                                                  static_cast<double>(t) / (settings.samples - 1));
                const double missed = range > 0 ? 100 * std::abs(there - truth(s, t)) / range : 0;
                error.mean += missed / (settings.samples * settings.samples);
                error.greatest = std::max(error.greatest, missed);
            }
        }
        errors.push_back(error);
    }
    progress.report(1);
    return errors;
}

} // namespace quadrille
