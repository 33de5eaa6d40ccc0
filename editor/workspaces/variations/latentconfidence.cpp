// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/latentconfidence.h"

#include "model/variation/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

constexpr int cells = 14;    ///< of the grid, along each axis
constexpr double room = 0.1; ///< of the grid beyond the trajectories, of their extent
constexpr double leastVariance = 1e-12;

double logarithm(double variance)
{
    return std::log10(std::max(variance, leastVariance));
}

} // namespace

LatentConfidence confidenceOf(const GpdmState& state, const std::vector<RowMatrix>& paths,
                              const Progress& progress)
{
    const Eigen::Index dimensions = state.latents.cols();
    // Variances depend on the latents alone.
    const PoseReconstruction poses(state, RowMatrix(state.latents.rows(), 0), Eigen::RowVectorXd());
    LatentConfidence confidence;
    confidence.least = std::numeric_limits<double>::infinity();
    confidence.greatest = -confidence.least;
    const auto sureness = [&](const Eigen::RowVectorXd& latent) {
        const double value = logarithm(poses.variance(latent));
        confidence.least = std::min(confidence.least, value);
        confidence.greatest = std::max(confidence.greatest, value);
        return value;
    };
    for (const RowMatrix& path : paths) {
        std::vector<double>& along = confidence.alongPaths.emplace_back();
        for (Eigen::Index frame = 0; frame < path.rows(); ++frame)
            along.push_back(sureness(path.row(frame)));
    }
    const Eigen::RowVectorXd lower = state.latents.colwise().minCoeff();
    const Eigen::RowVectorXd extent = state.latents.colwise().maxCoeff() - lower;
    const Eigen::RowVectorXd middle = state.latents.colwise().mean();
    const int depth = dimensions > 2 ? cells : 1;
    std::vector<std::array<double, 3>> places;
    std::vector<double> values;
    for (int x = 0; x < cells; ++x) {
        progress.report(x, cells);
        for (int y = 0; y < cells; ++y) {
            for (int z = 0; z < depth; ++z) {
                Eigen::RowVectorXd latent = middle;
                const std::array<int, 3> cell{x, y, z};
                std::array<double, 3> place{};
                for (Eigen::Index axis = 0; axis < std::min<Eigen::Index>(dimensions, 3); ++axis) {
                    const double share =
                        (1 + 2 * room) * cell.at(static_cast<std::size_t>(axis)) / (cells - 1) - room;
                    latent[axis] = lower[axis] + share * extent[axis];
                    place.at(static_cast<std::size_t>(axis)) = latent[axis];
                }
                places.push_back(place);
                values.push_back(sureness(latent));
            }
        }
    }
    const double half = (confidence.least + confidence.greatest) / 2;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (values[i] < half) {
            confidence.places.push_back(places[i]);
            confidence.atPlaces.push_back(values[i]);
        }
    }
    return confidence;
}

} // namespace quadrille
