// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/sampling.h"

#include "model/core/badargument.h"

#include <cmath>

namespace quadrille {

TrajectorySamples sampleTrajectories(const GpdmDynamics& dynamics, const RowMatrix& trajectory, int count,
                                     std::uint64_t seed, const HmcSettings& settings,
                                     const Progress& progress, double spread)
{
    if (trajectory.rows() == 0)
        refuse("the trajectory has no positions", "choose a learned trajectory");
    if (!(spread >= 0) || !std::isfinite(spread))
        refuse("the spread of variations is negative or infinite", "choose a number from 0 on, such as 1");
    const Eigen::Index steps = trajectory.rows() - 1;
    const Eigen::Index dimensions = trajectory.cols();
    const HmcEnergy energy = [](const Eigen::VectorXd& innovations, Eigen::VectorXd& gradient) {
        gradient = innovations;
        return 0.5 * innovations.squaredNorm();
    };
    const HmcChain chain = drawByHmc(energy, Eigen::VectorXd::Zero(steps * dimensions), {}, count, seed,
                                     settings, progress.part(0, 0.5));
    TrajectorySamples samples{.report = chain.report};
    const Progress drawing = progress.part(0.5, 1);
    for (const Eigen::VectorXd& sample : chain.samples) {
        const Eigen::Map<const RowMatrix> innovations(sample.data(), steps, dimensions);
        samples.trajectories.push_back(dynamics.trajectory(trajectory.row(0), spread * innovations));
        samples.energies.push_back(dynamics.energy(samples.trajectories.back()));
        drawing.report(std::ssize(samples.trajectories), std::ssize(chain.samples));
    }
    return samples;
}

} // namespace quadrille
