// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/sampling.h"

namespace quadrille {

/// Trajectories that deviate smoothly from a learned one and begin where it does, and how probable they are:
/// the joint conditional of the dynamics (GpdmDynamics::energy) on sums of sine waves in the time of the
/// take, a quarter of a period over the whole, then odd multiples of that, as many as the learned trajectory
/// itself consists of. Noise that goes anywhere from one frame to the next has no place in them, and what the
/// take passes quickly on the reference it passes without a jerk. Those of a cycle end as they begin: whole
/// periods of sines and cosines. Refers to the dynamics.
class SmoothDeviations
{
public:
    /// \pre The trajectory has at least two positions; times as LearnedTrajectory has them.
    SmoothDeviations(const GpdmDynamics& dynamics, const LearnedTrajectory& trajectory);

    /// How many numbers make a deviation.
    Eigen::Index size() const { return m_waves.cols() * m_trajectory.cols(); }
    /// Waves × dimensions as positions, frames × dimensions; the first row is zero.
    RowMatrix deviation(const Eigen::VectorXd& amplitudes) const;
    /// Of any deviation what waves make of it: the nearest smooth one.
    RowMatrix smoothed(const RowMatrix& deviation) const
    {
        return m_waves * (m_waves.transpose() * deviation);
    }
    /// Negative log density, without constants, and its gradient.
    double energy(const Eigen::VectorXd& amplitudes, Eigen::VectorXd& gradient) const;
    /// Second derivatives of the energy where nothing deviates, made positive definite: a good mass for
    /// drawByHmc. Cost: 2 · size() energies.
    Eigen::MatrixXd curvature() const;

private:
    const GpdmDynamics& m_dynamics;
    RowMatrix m_trajectory;
    RowMatrix m_waves; ///< frames × waves, orthonormal
    double m_size;     ///< of the movement from where it began, per wave
};

} // namespace quadrille
