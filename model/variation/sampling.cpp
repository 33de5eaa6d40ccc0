// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"

namespace quadrille {

namespace {

/// A trajectory from its start and all later positions one after the other.
RowMatrix trajectoryOf(const Eigen::RowVectorXd& start, const Eigen::VectorXd& later)
{
    const Eigen::Index count = start.size() > 0 ? later.size() / start.size() : 0;
    RowMatrix trajectory(count + 1, start.size());
    trajectory.row(0) = start;
    trajectory.bottomRows(count) = Eigen::Map<const RowMatrix>(later.data(), count, start.size());
    return trajectory;
}

Eigen::VectorXd laterPositions(const RowMatrix& trajectory)
{
    const Eigen::Index d = trajectory.cols();
    return Eigen::Map<const Eigen::VectorXd>(trajectory.data() + d, trajectory.size() - d);
}

} // namespace

TrajectorySamples sampleTrajectories(const GpdmDynamics& dynamics, const RowMatrix& trajectory, int count,
                                     std::uint64_t seed, const HmcSettings& settings,
                                     const Progress& progress)
{
    const Eigen::RowVectorXd start = trajectory.row(0);
    const RowMatrix first = dynamics.meanPrediction(start, trajectory.rows());
    RowMatrix byTrajectory;
    const HmcEnergy energy = [&](const Eigen::VectorXd& position, Eigen::VectorXd& gradient) {
        const double value = dynamics.energy(trajectoryOf(start, position), &byTrajectory);
        gradient = laterPositions(byTrajectory);
        return value;
    };
    HmcChain chain =
        drawByHmc(energy, laterPositions(first), dynamics.curvature(first), count, seed, settings, progress);
    TrajectorySamples samples;
    for (const Eigen::VectorXd& sample : chain.samples)
        samples.trajectories.push_back(trajectoryOf(start, sample));
    samples.report = std::move(chain.report);
    return samples;
}

} // namespace quadrille
